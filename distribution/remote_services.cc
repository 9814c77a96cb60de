#include "distribution/remote_services.h"

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <utility>

#include "runtime/core/api.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// The functions; the number is the first one of a question, the arguments follow it.
enum class RobotCall : uint64_t {
  kOpenPrimitive,      // locator -> id
  kClosePrimitive,     // id
  kControlPrimitive,   // id, request, bytes of the result; bytes of the parameter -> bytes
  kEnableJointGain,    // id
  kDisableJointGain,   // id
  kSetJointGain,       // id, six gains
  kGetJointGain,       // id -> six gains
  kRegisterGain,       // id, six gains
  kSetDefaultGain,     // id
  kGetDefaultGain,     // id -> six gains
  kJointValue,         // id -> bytes
  kSensorValue,        // id -> bytes
  kNewSyncKey,         // -> key
  kCancelSyncKey,      // key
  kDivideSyncKey,      // key -> two keys
  kSetCdt,             // region; its bytes
  kMotorPower,         // power
  kGetBootCondition,   // -> bytes
  kShutdown,           // bytes
  kPowerStatus,        // -> bytes
  kObservePower,       // object, selector; bytes
  kUnobservePower,     // object, selector
  kSetTime,            // bytes
  kGetTime,            // -> bytes
  kSetTimeDifference,  // hours
  kGetTimeDifference,  // -> hours
  kSetVolume,          // switch
  kGetVolume,          // -> switch
};

constexpr size_t kResultMax = 1024;  // bytes; more than any request of ControlPrimitive() returns

template <typename T>
std::string BytesOf(const T& value) {
  static_assert(std::is_trivially_copyable_v<T>);
  return {reinterpret_cast<const char*>(&value), sizeof value};
}

// Copies bytes of the wire to a struct, if they have its size.
template <typename T>
void Copy(const std::string& bytes, T* value) {
  static_assert(std::is_trivially_copyable_v<T>);
  if (bytes.size() == sizeof(T)) std::memcpy(static_cast<void*>(value), bytes.data(), sizeof(T));
}

// Asks the master, and waits for the answer.
Answer Ask(System* system, RobotCall call, std::vector<uint64_t> numbers, std::string text = "",
           std::string bytes = "") {
  numbers.insert(numbers.begin(), static_cast<uint64_t>(call));
  return system->uplink()->Ask(
      {QuestionKind::kService, std::move(numbers), std::move(text), std::move(bytes)});
}

OStatus StatusOf(const Answer& answer) { return static_cast<OStatus>(answer.status); }

std::vector<uint64_t> WithGains(OPrimitiveID id, const word gains[6]) {
  std::vector<uint64_t> numbers = {static_cast<uint64_t>(id)};
  numbers.insert(numbers.end(), gains, gains + 6);
  return numbers;
}

void CopyGains(const Answer& answer, word gains[6]) {
  for (size_t i = 0; i < 6; ++i) gains[i] = static_cast<word>(answer.number(i));
}

std::vector<uint64_t> EntryOf(const OServiceEntry& entry) {
  return {static_cast<uint64_t>(ObjectIdOf(entry.GetOID())), entry.GetSelector()};
}

}  // namespace

OStatus RemoteServices::OpenPrimitive(const char* locator, OPrimitiveID* id) {
  const Answer answer = Ask(system_, RobotCall::kOpenPrimitive, {}, locator);
  *id = static_cast<OPrimitiveID>(answer.number(0));
  return StatusOf(answer);
}
OStatus RemoteServices::ClosePrimitive(OPrimitiveID id) {
  return StatusOf(Ask(system_, RobotCall::kClosePrimitive, {id}));
}
OStatus RemoteServices::ControlPrimitive(OPrimitiveID id, OPrimitiveRequest request, void* param,
                                         size_t param_size, void* result, size_t result_size) {
  const std::string bytes(static_cast<const char*>(param), param == nullptr ? 0 : param_size);
  const Answer answer =
      Ask(system_, RobotCall::kControlPrimitive,
          {id, static_cast<uint64_t>(request), result == nullptr ? 0 : result_size}, "", bytes);
  if (result != nullptr)
    std::memcpy(result, answer.bytes.data(), std::min(result_size, answer.bytes.size()));
  return StatusOf(answer);
}
OStatus RemoteServices::EnableJointGain(OPrimitiveID id) {
  return StatusOf(Ask(system_, RobotCall::kEnableJointGain, {id}));
}
OStatus RemoteServices::DisableJointGain(OPrimitiveID id) {
  return StatusOf(Ask(system_, RobotCall::kDisableJointGain, {id}));
}
OStatus RemoteServices::SetJointGain(OPrimitiveID id, const word gains[6]) {
  return StatusOf(Ask(system_, RobotCall::kSetJointGain, WithGains(id, gains)));
}
OStatus RemoteServices::GetJointGain(OPrimitiveID id, word gains[6]) {
  const Answer answer = Ask(system_, RobotCall::kGetJointGain, {id});
  CopyGains(answer, gains);
  return StatusOf(answer);
}
OStatus RemoteServices::RegisterDefaultJointGain(OPrimitiveID id, const word gains[6]) {
  return StatusOf(Ask(system_, RobotCall::kRegisterGain, WithGains(id, gains)));
}
OStatus RemoteServices::SetDefaultJointGain(OPrimitiveID id) {
  return StatusOf(Ask(system_, RobotCall::kSetDefaultGain, {id}));
}
OStatus RemoteServices::GetDefaultJointGain(OPrimitiveID id, word gains[6]) {
  const Answer answer = Ask(system_, RobotCall::kGetDefaultGain, {id});
  CopyGains(answer, gains);
  return StatusOf(answer);
}
OStatus RemoteServices::GetJointValue(OPrimitiveID id, OJointValue* value) {
  const Answer answer = Ask(system_, RobotCall::kJointValue, {id});
  Copy(answer.bytes, value);
  return StatusOf(answer);
}
OStatus RemoteServices::GetSensorValue(OPrimitiveID id, OSensorValue* value) {
  const Answer answer = Ask(system_, RobotCall::kSensorValue, {id});
  Copy(answer.bytes, value);
  return StatusOf(answer);
}
OStatus RemoteServices::NewSyncKey(OVRSyncKey* key) {
  const Answer answer = Ask(system_, RobotCall::kNewSyncKey, {});
  *key = static_cast<OVRSyncKey>(answer.number(0));
  return StatusOf(answer);
}
OStatus RemoteServices::CancelSyncKey(OVRSyncKey key) {
  return StatusOf(Ask(system_, RobotCall::kCancelSyncKey, {static_cast<uint64_t>(key)}));
}
OStatus RemoteServices::DivideSyncKey(OVRSyncKey key, OVRSyncKey* key1, OVRSyncKey* key2) {
  const Answer answer = Ask(system_, RobotCall::kDivideSyncKey, {static_cast<uint64_t>(key)});
  *key1 = static_cast<OVRSyncKey>(answer.number(0));
  *key2 = static_cast<OVRSyncKey>(answer.number(1));
  return StatusOf(answer);
}
OStatus RemoteServices::SetCdtVectorData(MemoryRegionID id) {
  const RegionTable& regions = system_->regions();
  return StatusOf(Ask(
      system_, RobotCall::kSetCdt, {id}, "",
      std::string(regions.BaseOf(id) == nullptr ? "" : regions.BaseOf(id), regions.SizeOf(id))));
}
OStatus RemoteServices::SetMotorPower(OPower power) {
  return StatusOf(Ask(system_, RobotCall::kMotorPower, {static_cast<uint64_t>(power)}));
}
OStatus RemoteServices::GetBootCondition(OBootCondition* condition) {
  const Answer answer = Ask(system_, RobotCall::kGetBootCondition, {});
  Copy(answer.bytes, condition);
  return StatusOf(answer);
}
OStatus RemoteServices::Shutdown(const OBootCondition& condition) {
  return StatusOf(Ask(system_, RobotCall::kShutdown, {}, "", BytesOf(condition)));
}
OStatus RemoteServices::GetPowerStatus(OPowerStatus* status) {
  const Answer answer = Ask(system_, RobotCall::kPowerStatus, {});
  Copy(answer.bytes, status);
  return StatusOf(answer);
}
OStatus RemoteServices::ObservePowerStatus(const OPowerStatus& notify, const OServiceEntry& entry) {
  return StatusOf(Ask(system_, RobotCall::kObservePower, EntryOf(entry), "", BytesOf(notify)));
}
OStatus RemoteServices::UnobservePowerStatus(const OServiceEntry& entry) {
  return StatusOf(Ask(system_, RobotCall::kUnobservePower, EntryOf(entry)));
}
OStatus RemoteServices::SetTime(const OTime& time) {
  return StatusOf(Ask(system_, RobotCall::kSetTime, {}, "", BytesOf(time)));
}
OStatus RemoteServices::GetTime(OTime* time) {
  const Answer answer = Ask(system_, RobotCall::kGetTime, {});
  Copy(answer.bytes, time);
  return StatusOf(answer);
}
OStatus RemoteServices::SetTimeDifference(sbyte hours) {
  return StatusOf(Ask(system_, RobotCall::kSetTimeDifference, {static_cast<uint64_t>(hours)}));
}
OStatus RemoteServices::GetTimeDifference(sbyte* hours) {
  const Answer answer = Ask(system_, RobotCall::kGetTimeDifference, {});
  *hours = static_cast<sbyte>(answer.number(0));
  return StatusOf(answer);
}
OStatus RemoteServices::SetVolumeSwitch(OVolumeSwitch volume) {
  return StatusOf(Ask(system_, RobotCall::kSetVolume, {static_cast<uint64_t>(volume)}));
}
OStatus RemoteServices::GetVolumeSwitch(OVolumeSwitch* volume) {
  const Answer answer = Ask(system_, RobotCall::kGetVolume, {});
  *volume = static_cast<OVolumeSwitch>(answer.number(0));
  return StatusOf(answer);
}

namespace {

// Executes one call in the master.
class RobotCallServer {
 public:
  RobotCallServer(System* system, int robot, const Question& question)
      : system_(system), services_(system->robot(robot).services.get()), question_(question) {}

  Answer Serve() {
    switch (static_cast<RobotCall>(Number(0))) {
      case RobotCall::kControlPrimitive:
        return Control();
      case RobotCall::kSetCdt:
        return SetCdt();
      case RobotCall::kMotorPower:
      case RobotCall::kGetBootCondition:
      case RobotCall::kShutdown:
      case RobotCall::kPowerStatus:
      case RobotCall::kObservePower:
      case RobotCall::kUnobservePower:
        return ServePower();
      case RobotCall::kSetTime:
      case RobotCall::kGetTime:
      case RobotCall::kSetTimeDifference:
      case RobotCall::kGetTimeDifference:
      case RobotCall::kSetVolume:
      case RobotCall::kGetVolume:
        return ServeClock();
      case RobotCall::kNewSyncKey:
      case RobotCall::kCancelSyncKey:
      case RobotCall::kDivideSyncKey:
        return ServeSyncKeys();
      default:
        return ServePrimitive();
    }
  }

 private:
  uint64_t Number(size_t i) const {
    return i < question_.numbers.size() ? question_.numbers[i] : 0;
  }
  OPrimitiveID Id() const { return static_cast<OPrimitiveID>(Number(1)); }
  OServiceEntry Entry() const {
    return {OidOf(static_cast<ObjectId>(Number(1))), static_cast<Selector>(Number(2))};
  }

  Answer ServePrimitive() {
    word gains[6] = {};
    for (size_t i = 0; i < 6; ++i) gains[i] = static_cast<word>(Number(2 + i));
    switch (static_cast<RobotCall>(Number(0))) {
      case RobotCall::kOpenPrimitive: {
        OPrimitiveID id = oprimitiveID_UNDEF;
        const OStatus status = services_->OpenPrimitive(question_.text.c_str(), &id);
        return {status, {id}};
      }
      case RobotCall::kClosePrimitive:
        return {services_->ClosePrimitive(Id())};
      case RobotCall::kEnableJointGain:
        return {services_->EnableJointGain(Id())};
      case RobotCall::kDisableJointGain:
        return {services_->DisableJointGain(Id())};
      case RobotCall::kSetJointGain:
        return {services_->SetJointGain(Id(), gains)};
      case RobotCall::kRegisterGain:
        return {services_->RegisterDefaultJointGain(Id(), gains)};
      case RobotCall::kSetDefaultGain:
        return {services_->SetDefaultJointGain(Id())};
      case RobotCall::kGetJointGain:
        return WithGainsOf(services_->GetJointGain(Id(), gains), gains);
      case RobotCall::kGetDefaultGain:
        return WithGainsOf(services_->GetDefaultJointGain(Id(), gains), gains);
      case RobotCall::kJointValue:
        return WithBytes<OJointValue>(
            [this](OJointValue* value) { return services_->GetJointValue(Id(), value); });
      case RobotCall::kSensorValue:
        return WithBytes<OSensorValue>(
            [this](OSensorValue* value) { return services_->GetSensorValue(Id(), value); });
      default:
        return {oNOT_SUPPORTED};
    }
  }

  static Answer WithGainsOf(OStatus status, const word gains[6]) {
    return {status, {gains, gains + 6}};
  }
  template <typename T, typename F>
  static Answer WithBytes(F&& call) {
    T value;
    std::memset(static_cast<void*>(&value), 0, sizeof value);
    const OStatus status = call(&value);
    return {status, {}, BytesOf(value)};
  }

  Answer Control() {
    std::string param = question_.bytes;
    std::string result(std::min<uint64_t>(Number(3), kResultMax), '\0');
    const OStatus status = services_->ControlPrimitive(
        Id(), static_cast<OPrimitiveRequest>(Number(2)), param.empty() ? nullptr : param.data(),
        param.size(), result.empty() ? nullptr : result.data(), result.size());
    return {status, {}, result};
  }

  Answer SetCdt() {
    const auto region = static_cast<MemoryRegionID>(Number(1));
    char* const base = system_->regions().BaseOf(region);
    if (base != nullptr)
      std::memcpy(base, question_.bytes.data(),
                  std::min(question_.bytes.size(), system_->regions().SizeOf(region)));
    return {services_->SetCdtVectorData(region)};
  }

  Answer ServePower() {
    switch (static_cast<RobotCall>(Number(0))) {
      case RobotCall::kMotorPower:
        return {services_->SetMotorPower(static_cast<OPower>(Number(1)))};
      case RobotCall::kGetBootCondition:
        return WithBytes<OBootCondition>(
            [this](OBootCondition* value) { return services_->GetBootCondition(value); });
      case RobotCall::kPowerStatus:
        return WithBytes<OPowerStatus>(
            [this](OPowerStatus* value) { return services_->GetPowerStatus(value); });
      case RobotCall::kShutdown: {
        OBootCondition condition{};
        Copy(question_.bytes, &condition);
        return {services_->Shutdown(condition)};
      }
      case RobotCall::kObservePower: {
        OPowerStatus notify{};
        Copy(question_.bytes, &notify);
        return {services_->ObservePowerStatus(notify, Entry())};
      }
      default:
        return {services_->UnobservePowerStatus(Entry())};
    }
  }

  Answer ServeClock() {
    switch (static_cast<RobotCall>(Number(0))) {
      case RobotCall::kSetTime: {
        OTime time{};
        Copy(question_.bytes, &time);
        return {services_->SetTime(time)};
      }
      case RobotCall::kGetTime:
        return WithBytes<OTime>([this](OTime* value) { return services_->GetTime(value); });
      case RobotCall::kSetTimeDifference:
        return {services_->SetTimeDifference(static_cast<sbyte>(Number(1)))};
      case RobotCall::kGetTimeDifference: {
        sbyte hours = 0;
        const OStatus status = services_->GetTimeDifference(&hours);
        return {status, {static_cast<uint64_t>(hours)}};
      }
      case RobotCall::kSetVolume:
        return {services_->SetVolumeSwitch(static_cast<OVolumeSwitch>(Number(1)))};
      default: {
        OVolumeSwitch volume{};
        const OStatus status = services_->GetVolumeSwitch(&volume);
        return {status, {static_cast<uint64_t>(volume)}};
      }
    }
  }

  Answer ServeSyncKeys() {
    const auto key = static_cast<OVRSyncKey>(Number(1));
    OVRSyncKey first = ovrsynckeyUNDEF;
    OVRSyncKey second = ovrsynckeyUNDEF;
    switch (static_cast<RobotCall>(Number(0))) {
      case RobotCall::kNewSyncKey: {
        const OStatus status = services_->NewSyncKey(&first);
        return {status, {static_cast<uint64_t>(first)}};
      }
      case RobotCall::kCancelSyncKey:
        return {services_->CancelSyncKey(key)};
      default: {
        const OStatus status = services_->DivideSyncKey(key, &first, &second);
        return {status, {static_cast<uint64_t>(first), static_cast<uint64_t>(second)}};
      }
    }
  }

  System* const system_;
  RobotServices* const services_;
  const Question& question_;
};

}  // namespace

bool IsSetCdt(const Question& question) {
  return !question.numbers.empty() &&
         question.numbers[0] == static_cast<uint64_t>(RobotCall::kSetCdt);
}

Answer ServeRobotCall(System* system, int robot, const Question& question) {
  return RobotCallServer(system, robot, question).Serve();
}

}  // namespace openr_host
