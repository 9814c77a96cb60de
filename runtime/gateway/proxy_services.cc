#include "runtime/gateway/proxy_services.h"

#include <fmt/format.h>
#include <sError.h>

#include <cstring>
#include <utility>

#include "runtime/core/code_object.h"
#include "runtime/core/image_object.h"
#include "runtime/core/system.h"
#include "runtime/gateway/gateway_stream.h"
#include "runtime/gateway/proxy_client.h"

namespace openr_host {
namespace {

constexpr size_t kGainsBytes = 6 * sizeof(word);

// Returns whether `object` can wait for an answer from the network.  An object whose code runs in
// this process can wait, because its handler can be suspended.  An object whose code runs in a
// worker process (--place, --isolate) cannot: while its handler runs, this process waits for the
// worker and cannot receive an answer from the network.
bool CanWait(const Object* object) {
  return object != nullptr && object->running() != nullptr &&
         (dynamic_cast<const CodeHost*>(object) != nullptr ||
          dynamic_cast<const ImageObject*>(object) != nullptr);
}

template <typename T>
void Copy(const std::string& bytes, T* value) {
  std::memcpy(static_cast<void*>(value), bytes.data(), std::min(bytes.size(), sizeof *value));
}

}  // namespace

ProxyServices::ProxyServices(System* system, ObjectId gateway, uint32_t selector,
                             std::unique_ptr<RobotServices> local)
    : system_(system), gateway_(gateway), selector_(selector), local_(std::move(local)) {}

void ProxyServices::Remove(std::unique_ptr<RobotServices>* services) {
  auto* const proxy = dynamic_cast<ProxyServices*>(services->get());
  if (proxy == nullptr) return;
  // Moves `local_` out of `proxy` first, because the assignment to `*services` below destroys
  // `proxy`.
  std::unique_ptr<RobotServices> local = std::move(proxy->local_);
  *services = std::move(local);
}

bool ProxyServices::Ask(const char* object, uint32_t selector, const std::string& message,
                        size_t reply_size, std::string* reply) {
  if (!CanWait(t_current.object)) {
    system_->AddFinding(Severity::kError,
                        "an OPEN-R call to the robot fails: it needs a handler of an object in the "
                        "run's own process (not a constructor, not --place or --isolate)");
    return false;
  }
  ProxyRequest head{};
  std::strncpy(head.object, object, sizeof head.object - 1);
  head.selector = selector;
  head.reply_size = static_cast<uint32_t>(reply_size);
  head.size = static_cast<uint32_t>(message.size());
  std::string bytes(reinterpret_cast<const char*>(&head), sizeof head);
  bytes += message;
  reply->assign(4 + reply_size, '\0');
  reply->replace(0, 4, EncodeWord(sFAIL));
  const int32_t error = system_->requests().Call(gateway_, selector_, bytes.data(), bytes.size(),
                                                 reply->data(), reply->size());
  if (error != sSUCCESS || WordIn(*reply, 0) != sSUCCESS) return false;
  reply->erase(0, 4);
  return true;
}

OStatus ProxyServices::Control(ControlRequest request, const std::string& param,
                               std::string* result) {
  std::string reply;
  if (!Ask(kVirtualRobot, kControlSelector, ControlMessage(request, param), kControlBytes, &reply))
    return oFAIL;
  if (result != nullptr) *result = reply.substr(kControlParamAt);
  return static_cast<OStatus>(WordIn(reply, 4));
}

OStatus ProxyServices::ControlGains(ControlRequest request, OPrimitiveID id, const word gains[6]) {
  return Control(request,
                 EncodeWord(id) + std::string(reinterpret_cast<const char*>(gains), kGainsBytes));
}

OStatus ProxyServices::ReadGains(ControlRequest request, OPrimitiveID id, word gains[6]) {
  std::string result;
  const OStatus status = Control(request, EncodeWord(id), &result);
  if (status == oSUCCESS) std::memcpy(gains, result.data() + 4, kGainsBytes);
  return status;
}

OStatus ProxyServices::RefuseCall(const char* function) {
  system_->AddFinding(Severity::kWarning,
                      fmt::format("OPENR::{}() is not carried to the robot: Sony's runtime for PCs "
                                  "has no such call (docs/network.md)",
                                  function));
  return oNOT_SUPPORTED;
}

RobotServices& ProxyServices::ServicesFor(const char* function) {
  system_->AddFinding(
      Severity::kWarning,
      fmt::format(
          "OPENR::{}() is not carried to the robot: the layout of its message is not known; "
          "the robot of this run answers (docs/network.md)",
          function));
  return *local_;
}

OStatus ProxyServices::OpenPrimitive(const char* locator, OPrimitiveID* id) {
  std::string message = EncodeWord(kOpenType) + std::string(locator).substr(0, kLocatorBytes - 1);
  message.resize(4 + kLocatorBytes, '\0');
  std::string reply;
  if (!Ask(kVirtualRobot, kOpenSelector, message, kOpenReplyBytes, &reply)) return oFAIL;
  *id = WordIn(reply, 8);
  return static_cast<OStatus>(WordIn(reply, 4));
}

OStatus ProxyServices::ClosePrimitive(OPrimitiveID id) {
  std::string reply;
  const std::string message = EncodeWord(kOpenReplyType) + EncodeWord(0) + EncodeWord(id);
  if (!Ask(kVirtualRobot, kCloseSelector, message, kStatusReplyBytes, &reply)) return oFAIL;
  return static_cast<OStatus>(WordIn(reply, 4));
}

OStatus ProxyServices::ControlPrimitive(OPrimitiveID, OPrimitiveRequest, void*, size_t, void*,
                                        size_t) {
  return RefuseCall("ControlPrimitive");
}

OStatus ProxyServices::EnableJointGain(OPrimitiveID id) {
  return Control(ControlRequest::kEnableGain, EncodeWord(id));
}
OStatus ProxyServices::DisableJointGain(OPrimitiveID id) {
  return Control(ControlRequest::kDisableGain, EncodeWord(id));
}
OStatus ProxyServices::SetJointGain(OPrimitiveID id, const word gains[6]) {
  return ControlGains(ControlRequest::kSetGain, id, gains);
}
OStatus ProxyServices::GetJointGain(OPrimitiveID id, word gains[6]) {
  return ReadGains(ControlRequest::kGetGain, id, gains);
}
OStatus ProxyServices::RegisterDefaultJointGain(OPrimitiveID id, const word gains[6]) {
  return ControlGains(ControlRequest::kRegisterGain, id, gains);
}
OStatus ProxyServices::SetDefaultJointGain(OPrimitiveID id) {
  return Control(ControlRequest::kSetDefaultGain, EncodeWord(id));
}
OStatus ProxyServices::GetDefaultJointGain(OPrimitiveID id, word gains[6]) {
  return ReadGains(ControlRequest::kGetDefaultGain, id, gains);
}

OStatus ProxyServices::GetJointValue(OPrimitiveID id, OJointValue* value) {
  std::string result;
  const OStatus status = Control(ControlRequest::kJointValue, EncodeWord(id), &result);
  if (status == oSUCCESS) Copy(result, value);
  return status;
}
OStatus ProxyServices::GetSensorValue(OPrimitiveID id, OSensorValue* value) {
  std::string result;
  const OStatus status = Control(ControlRequest::kSensorValue, EncodeWord(id), &result);
  if (status == oSUCCESS) Copy(result, value);
  return status;
}

OStatus ProxyServices::NewSyncKey(OVRSyncKey* key) {
  std::string result;
  const OStatus status = Control(ControlRequest::kNewSyncKey, "", &result);
  if (status == oSUCCESS) *key = static_cast<OVRSyncKey>(WordIn(result, 0));
  return status;
}
OStatus ProxyServices::CancelSyncKey(OVRSyncKey key) {
  return Control(ControlRequest::kCancelSyncKey, EncodeWord(key));
}
// Divides a sync key, with which several command vectors start together, into two keys.  Like
// Sony's library, sends no message to the robot for this (binary.md, 4.1).
OStatus ProxyServices::DivideSyncKey(OVRSyncKey key, OVRSyncKey* key1, OVRSyncKey* key2) {
  return local_->DivideSyncKey(key, key1, key2);
}

OStatus ProxyServices::SetCdtVectorData(MemoryRegionID) { return RefuseCall("SetCdtVectorData"); }

OStatus ProxyServices::SetMotorPower(OPower power) {
  std::string reply;
  const std::string message =
      EncodeWord(kPowerType + kMotorPowerSelector) + EncodeWord(power ? 1 : 0);
  if (!Ask(kPowerManager, kMotorPowerSelector, message, kStatusReplyBytes, &reply)) return oFAIL;
  return static_cast<OStatus>(WordIn(reply, 4));
}

OStatus ProxyServices::GetPowerStatus(OPowerStatus* status) {
  std::string reply;
  if (!Ask(kPowerManager, kPowerStatusSelector, "", kPowerStatusBytes, &reply)) return oFAIL;
  Copy(reply.substr(4), status);
  return oSUCCESS;
}

// Shuts down the robot of this run, which stands for the PC, and not the robot to which OPEN-R
// calls go.
OStatus ProxyServices::Shutdown(const OBootCondition& condition) {
  return local_->Shutdown(condition);
}
OStatus ProxyServices::ObservePowerStatus(const OPowerStatus& notify, const OServiceEntry& entry) {
  return local_->ObservePowerStatus(notify, entry);
}
OStatus ProxyServices::UnobservePowerStatus(const OServiceEntry& entry) {
  return local_->UnobservePowerStatus(entry);
}

}  // namespace openr_host
