#include "virtualrobot/virtual_robot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "runtime/core/hasher.h"
#include "runtime/core/system.h"

namespace openr_host {

VirtualRobot::VirtualRobot(System* system, int robot, const RobotModel& model,
                           std::unique_ptr<Body> body)
    : system_(system),
      model_(model),
      body_(std::move(body)),
      primitives_(model),
      devices_(model),
      power_(system),
      sensors_(model, primitives_,
               Rng(system->options().seed, fmt::format("robot{}/sensors", robot))) {}

VirtualRobot::~VirtualRobot() = default;

bool VirtualRobot::FinishFrame() {
  body_->Advance(devices_.Commands(power_.motor_power()));
  const bool complete = sensors_.Sample(frame_, *body_, devices_);
  ++frame_;
  power_.Update();
  return complete;
}

OStatus VirtualRobot::OpenPrimitive(const char* locator, OPrimitiveID* id) {
  *id = primitives_.IdOf(locator);
  if (*id == oprimitiveID_UNDEF) return oNOT_FOUND;
  primitives_.Find(*id)->opened = true;
  return oSUCCESS;
}

OStatus VirtualRobot::ClosePrimitive(OPrimitiveID id) {
  return primitives_.Find(id) == nullptr ? oINVALID_PRIMITIVE_ID : oSUCCESS;
}

OStatus VirtualRobot::ControlPrimitive(OPrimitiveID id, OPrimitiveRequest request, void*, size_t,
                                       void* result, size_t result_size) {
  const Primitive* const primitive = primitives_.Find(id);
  if (primitive == nullptr) return oINVALID_PRIMITIVE_ID;
  if (request == oprmreqJOINT2_GET_VALUE && primitive->kind == PrimitiveKind::kJoint &&
      result != nullptr && result_size >= sizeof(OJointValue)) {
    return GetJointValue(id, static_cast<OJointValue*>(result));
  }
  return oINVALID_ARG;
}

template <typename Function>
OStatus VirtualRobot::ForJoints(OPrimitiveID id, Function function) {
  if (id != oprimitiveID_UNDEF) {
    const Primitive* const primitive = primitives_.Find(id);
    if (primitive == nullptr || primitive->kind != PrimitiveKind::kJoint)
      return oINVALID_PRIMITIVE_ID;
    return function(primitive->index);
  }
  OStatus status = oSUCCESS;
  for (const Sensor& sensor : model_.sensors) {
    const Primitive* const primitive = primitives_.Find(primitives_.IdOf(sensor.locator));
    if (primitive->kind != PrimitiveKind::kJoint || !primitive->opened) continue;
    const OStatus one = function(primitive->index);
    if (one != oSUCCESS) status = one;
  }
  return status;
}

OStatus VirtualRobot::EnableJointGain(OPrimitiveID id) {
  return ForJoints(id, [this](int joint) { return devices_.EnableGain(joint); });
}

OStatus VirtualRobot::DisableJointGain(OPrimitiveID id) {
  return ForJoints(id, [this](int joint) { return devices_.DisableGain(joint); });
}

OStatus VirtualRobot::SetJointGain(OPrimitiveID id, const word gains[6]) {
  GainWords words;
  std::copy_n(gains, 6, words.begin());
  return ForJoints(id, [&](int joint) { return devices_.SetGain(joint, words); });
}

OStatus VirtualRobot::GetJointGain(OPrimitiveID id, word gains[6]) {
  if (id == oprimitiveID_UNDEF) return oINVALID_PRIMITIVE_ID;
  return ForJoints(id, [&](int joint) -> OStatus {
    const JointDevice& device = devices_.joints[static_cast<size_t>(joint)];
    if (!device.gain_enabled) return oGAIN_DISABLED;
    std::copy(device.gains.begin(), device.gains.end(), gains);
    return oSUCCESS;
  });
}

OStatus VirtualRobot::RegisterDefaultJointGain(OPrimitiveID id, const word gains[6]) {
  GainWords words;
  std::copy_n(gains, 6, words.begin());
  return ForJoints(id, [&](int joint) -> OStatus {
    devices_.joints[static_cast<size_t>(joint)].registered = words;
    return oSUCCESS;
  });
}

OStatus VirtualRobot::SetDefaultJointGain(OPrimitiveID id) {
  return ForJoints(id, [&](int joint) -> OStatus {
    const auto& registered = devices_.joints[static_cast<size_t>(joint)].registered;
    return registered ? devices_.SetGain(joint, *registered) : oFAIL;
  });
}

OStatus VirtualRobot::GetDefaultJointGain(OPrimitiveID id, word gains[6]) {
  if (id == oprimitiveID_UNDEF) return oFAIL;
  const OStatus status = ForJoints(id, [&](int joint) -> OStatus {
    const auto& registered = devices_.joints[static_cast<size_t>(joint)].registered;
    if (!registered) return oFAIL;
    std::copy(registered->begin(), registered->end(), gains);
    return oSUCCESS;
  });
  return status == oSUCCESS ? oSUCCESS : oFAIL;
}

OStatus VirtualRobot::GetJointValue(OPrimitiveID id, OJointValue* value) {
  const Primitive* const primitive = primitives_.Find(id);
  if (primitive == nullptr || primitive->kind != PrimitiveKind::kJoint)
    return oINVALID_PRIMITIVE_ID;
  if (frame_ == 0) sensors_.SampleNow(*body_, devices_);  // asked before the first frame is over
  std::memcpy(static_cast<void*>(value), &sensors_.Latest(primitive->sensor), sizeof *value);
  return oSUCCESS;
}

OStatus VirtualRobot::GetSensorValue(OPrimitiveID id, OSensorValue* value) {
  const Primitive* const primitive = primitives_.Find(id);
  if (primitive == nullptr || primitive->sensor < 0) return oINVALID_PRIMITIVE_ID;
  if (frame_ == 0) sensors_.SampleNow(*body_, devices_);
  *value = sensors_.Latest(primitive->sensor);
  return oSUCCESS;
}

OStatus VirtualRobot::NewSyncKey(OVRSyncKey* key) {
  *key = sync_keys_.New();
  return *key == ovrsynckeyUNDEF ? oNO_SYNC_KEY : oSUCCESS;
}

OStatus VirtualRobot::CancelSyncKey(OVRSyncKey key) {
  return sync_keys_.Cancel(key) ? oSUCCESS : oINVALID_SYNC_KEY;
}

OStatus VirtualRobot::DivideSyncKey(OVRSyncKey key, OVRSyncKey* key1, OVRSyncKey* key2) {
  if (sync_keys_.Divide(key, key1, key2)) return oSUCCESS;
  *key1 = *key2 = ovrsynckeyUNDEF;
  return oFAIL;
}

OStatus VirtualRobot::SetMotorPower(OPower power) {
  power_.SetMotorPower(power);
  return oSUCCESS;
}

OStatus VirtualRobot::GetBootCondition(OBootCondition* condition) {
  *condition = power_.boot_condition;
  return oSUCCESS;
}

OStatus VirtualRobot::Shutdown(const OBootCondition& condition) {
  power_.next_boot = condition;
  return oSUCCESS;
}

OStatus VirtualRobot::GetPowerStatus(OPowerStatus* status) {
  *status = power_.Status();
  return oSUCCESS;
}

OStatus VirtualRobot::ObservePowerStatus(const OPowerStatus& notify, const OServiceEntry& entry) {
  if (!entry.IsValid()) return oFAIL;
  power_.Observe(notify, entry);
  return oSUCCESS;
}

OStatus VirtualRobot::UnobservePowerStatus(const OServiceEntry& entry) {
  return power_.Unobserve(entry) ? oSUCCESS : oINVALID_ARG;
}

OStatus VirtualRobot::SetTime(const OTime& time) {
  power_.SetClock(time.GetClock());
  power_.set_time_difference(time.GetTimeDif());
  return oSUCCESS;
}

OStatus VirtualRobot::GetTime(OTime* time) {
  *time = OTime(power_.Clock(), power_.time_difference());
  return oSUCCESS;
}

OStatus VirtualRobot::SetTimeDifference(sbyte hours) {
  if (hours < -12 || hours > 12) return oFAIL;
  power_.set_time_difference(hours);
  return oSUCCESS;
}

OStatus VirtualRobot::GetTimeDifference(sbyte* hours) {
  *hours = power_.time_difference();
  return oSUCCESS;
}

OStatus VirtualRobot::SetVolumeSwitch(OVolumeSwitch volume) {
  if (volume > ovolumeSW3) return oFAIL;
  power_.set_volume(volume);
  return oSUCCESS;
}

OStatus VirtualRobot::GetVolumeSwitch(OVolumeSwitch* volume) {
  *volume = power_.volume();
  return oSUCCESS;
}

void VirtualRobot::HashState(Hasher* hasher) const {
  hasher->Add(model_.content_hash);
  hasher->Add(frame_);
  body_->HashState(hasher);
  devices_.HashState(hasher);
  power_.HashState(hasher);
  sensors_.HashState(hasher);
  sync_keys_.HashState(hasher);
}

VirtualRobot* AddVirtualRobot(System* system, int robot, const RobotModel& model,
                              std::unique_ptr<Body> body) {
  auto services = std::make_unique<VirtualRobot>(system, robot, model, std::move(body));
  VirtualRobot* const result = services.get();
  system->robot(robot).services = std::move(services);
  OVirtualRobotComm* const comm =
      system->AddObject<OVirtualRobotComm>(robot, "OVirtualRobotComm", result);
  comm->host().is_system = true;
  return result;
}

}  // namespace openr_host
