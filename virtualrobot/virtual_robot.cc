#include "virtualrobot/virtual_robot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "runtime/base/hasher.h"
#include "runtime/core/current.h"
#include "runtime/core/system.h"
#include "virtualrobot/sound/audio_comm.h"
#include "virtualrobot/virtual_robot_comm.h"

namespace openr_host {
namespace {

Rng NoiseOf(int robot, uint64_t seed) { return {seed, fmt::format("robot{}/sensors", robot)}; }

}  // namespace

VirtualRobot::VirtualRobot(System* system, int robot, const RobotModel& model,
                           std::unique_ptr<Body> body, VirtualRobotOptions options)
    : system_(system),
      robot_(robot),
      model_(model),
      body_(std::move(body)),
      primitives_(model),
      devices_(model),
      power_(system, options.battery),
      sensors_(model, primitives_, NoiseOf(robot, system->options().seed)),
      watch_(model, devices_),
      speaker_(std::move(options.speaker)),
      microphone_(std::move(options.microphone), primitives_.IdOf(model.microphone_locator),
                  model.microphone_frames),
      camera_(std::move(options.camera), model.camera, primitives_.IdOf(model.camera.locator)),
      safe_posture_(model) {}

VirtualRobot::~VirtualRobot() = default;

bool VirtualRobot::FinishFrame() {
  body_->Advance(devices_.Commands(power_.motor_power()));
  const bool complete = sensors_.Sample(frame_, *body_, devices_);
  ++frame_;
  power_.Update();
  WatchLoad();
  return complete;
}

void VirtualRobot::WatchLoad() {
  const int joint = watch_.OverloadedJoint(body_->state());
  if (joint < 0) return;
  system_->AddFinding(
      Severity::kError,
      fmt::format("PPM::PWM Limit Over!! Motor:{} ({}); MECHA_LOAD_HIGH. SHUTDOWN.: asked for 78 % "
                  "of its drive or more for 30 s, the robot shuts down",
                  joint, model_.joints[static_cast<size_t>(joint)].locator));
  if (!system_->options().strict) return;
  system_->Shutdown(robot_,
                    {EndKind::kStrict, fmt::format("motor {} was at its limit for 30 s", joint)});
}

void VirtualRobot::Warn(std::string text) {
  system_->AddFinding(Severity::kWarning, std::move(text));
}

void VirtualRobot::LookAtServos() {
  std::vector<std::string> problems;
  watch_.ServosChanged(body_->state(), power_.motor_power(), &problems);
  for (std::string& problem : problems) Warn(std::move(problem));
}

OStatus VirtualRobot::OpenPrimitive(const char* locator, OPrimitiveID* id) {
  *id = primitives_.IdOf(locator);
  if (*id == oprimitiveID_UNDEF) return oNOT_FOUND;
  ++primitives_.Find(*id)->open_count;
  return oSUCCESS;
}

OStatus VirtualRobot::ClosePrimitive(OPrimitiveID id) {
  Primitive* const primitive = primitives_.Find(id);
  if (primitive == nullptr || !primitive->opened()) return oINVALID_PRIMITIVE_ID;
  --primitive->open_count;
  return oSUCCESS;
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
    if (primitive->kind != PrimitiveKind::kJoint || !primitive->opened()) continue;
    const OStatus one = function(primitive->index);
    if (one != oSUCCESS) status = one;
  }
  return status;
}

OStatus VirtualRobot::EnableJointGain(OPrimitiveID id) {
  const OStatus status = ForJoints(id, [this](int joint) { return devices_.EnableGain(joint); });
  LookAtServos();
  return status;
}

OStatus VirtualRobot::DisableJointGain(OPrimitiveID id) {
  const OStatus status = ForJoints(id, [this](int joint) { return devices_.DisableGain(joint); });
  LookAtServos();
  return status;
}

OStatus VirtualRobot::SetJointGain(OPrimitiveID id, const word gains[6]) {
  GainWords words;
  std::copy_n(gains, 6, words.begin());
  const OStatus status = ForJoints(id, [&](int joint) { return devices_.SetGain(joint, words); });
  LookAtServos();
  return status;
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
  const OStatus status = ForJoints(id, [&](int joint) -> OStatus {
    const auto& registered = devices_.joints[static_cast<size_t>(joint)].registered;
    return registered ? devices_.SetGain(joint, *registered) : oFAIL;
  });
  LookAtServos();
  return status;
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

const Primitive* VirtualRobot::Readable(OPrimitiveID id, const char* function) {
  const Primitive* const primitive = primitives_.Find(id);
  if (primitive == nullptr || primitive->sensor < 0) return nullptr;
  if (!primitive->opened()) {
    Warn(fmt::format("{}({}): nobody opened it; on the robot its value means nothing", function,
                     primitive->locator));
  }
  if (frame() == 0) sensors_.SampleNow(*body_, devices_);  // asked before the first frame is over
  return primitive;
}

OStatus VirtualRobot::GetJointValue(OPrimitiveID id, OJointValue* value) {
  const Primitive* const primitive = Readable(id, "GetJointValue");
  if (primitive == nullptr || primitive->kind != PrimitiveKind::kJoint)
    return oINVALID_PRIMITIVE_ID;
  std::memcpy(static_cast<void*>(value), &sensors_.Latest(primitive->sensor), sizeof *value);
  return oSUCCESS;
}

OStatus VirtualRobot::GetSensorValue(OPrimitiveID id, OSensorValue* value) {
  const Primitive* const primitive = Readable(id, "GetSensorValue");
  if (primitive == nullptr) return oINVALID_PRIMITIVE_ID;
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

// All or nothing: a table that is wrong leaves the others as they were.
OStatus VirtualRobot::SetCdtVectorData(MemoryRegionID id) {
  RegionTable& regions = system_->regions();
  if (regions.SizeOf(id) < sizeof(OCdtVectorData)) return oFAIL;
  auto* const vector = reinterpret_cast<OCdtVectorData*>(regions.BaseOf(id));
  if (vector->vectorInfo.type != odataCDT_VECTOR) return oINVALID_DATA_TYPE;
  if (vector->vectorInfo.numData > ocdtNUM_CHANNELS) return oINVALID_ARG;
  ColourTables tables = camera_.tables();
  for (longword i = 0; i < vector->vectorInfo.numData; ++i) {
    const OCdtInfo& info = *vector->GetInfo(static_cast<int>(i));
    const Primitive* const primitive = primitives_.Find(info.primitiveID);
    if (primitive == nullptr || primitive->kind != PrimitiveKind::kCamera)
      return oINVALID_PRIMITIVE_ID;
    if (!tables.Set(info)) return oINVALID_ARG;
  }
  camera_.tables() = tables;
  return oSUCCESS;
}

OStatus VirtualRobot::SetMotorPower(OPower power) {
  power_.SetMotorPower(power);
  LookAtServos();
  return oSUCCESS;
}

OStatus VirtualRobot::GetBootCondition(OBootCondition* condition) {
  *condition = power_.boot_condition;
  return oSUCCESS;
}

// Before System::Shutdown(), which knows neither button nor battery.
OStatus VirtualRobot::Shutdown(const OBootCondition& condition) {
  power_.next_boot = condition;
  const std::string who = t_current.object == nullptr ? "an object" : t_current.object->name;
  if (power_.pause()) {
    system_->NoteEnd(robot_,
                     {EndKind::kPause, who + " shut the robot down after the pause button"});
  } else if (power_.is_battery_low()) {
    system_->NoteEnd(robot_,
                     {EndKind::kBattery, fmt::format("{} shut the robot down with {} % left in its "
                                                     "battery; --battery 100% keeps it full",
                                                     who, power_.remaining_percent())});
  }
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
  power_.SetTimeDifference(time.GetTimeDif());
  return oSUCCESS;
}

OStatus VirtualRobot::GetTime(OTime* time) {
  *time = OTime(power_.Clock(), power_.time_difference());
  return oSUCCESS;
}

OStatus VirtualRobot::SetTimeDifference(sbyte hours) {
  if (hours < -12 || hours > 12) return oFAIL;
  power_.SetTimeDifference(hours);
  return oSUCCESS;
}

OStatus VirtualRobot::GetTimeDifference(sbyte* hours) {
  *hours = power_.time_difference();
  return oSUCCESS;
}

OStatus VirtualRobot::SetVolumeSwitch(OVolumeSwitch volume) {
  if (volume > ovolumeSW3) return oFAIL;
  power_.SetVolume(volume);
  return oSUCCESS;
}

OStatus VirtualRobot::GetVolumeSwitch(OVolumeSwitch* volume) {
  *volume = power_.volume();
  return oSUCCESS;
}

void VirtualRobot::Reseed(uint64_t seed) { sensors_.set_noise(NoiseOf(robot_, seed)); }

void VirtualRobot::HashState(Hasher* hasher) const {
  hasher->Add(model_.content_hash);
  hasher->Add(frame_);
  body_->HashState(hasher);
  primitives_.HashState(hasher);
  devices_.HashState(hasher);
  power_.HashState(hasher);
  sensors_.HashState(hasher);
  sync_keys_.HashState(hasher);
  optional_.HashState(hasher);
  watch_.HashState(hasher);
  speaker_.HashState(hasher);
  microphone_.HashState(hasher);
  camera_.HashState(hasher);
  safe_posture_.HashState(hasher);
}

VirtualRobot* AddVirtualRobot(System* system, int robot, const RobotModel& model,
                              std::unique_ptr<Body> body, VirtualRobotOptions options) {
  auto services =
      std::make_unique<VirtualRobot>(system, robot, model, std::move(body), std::move(options));
  VirtualRobot* const result = services.get();
  system->robot(robot).services = std::move(services);
  auto* const comm = system->AddObject<OVirtualRobotComm>(robot, "OVirtualRobotComm", result);
  comm->host().is_system = true;
  auto* const sound =
      system->AddObject<OVirtualRobotAudioComm>(robot, "OVirtualRobotAudioComm", result);
  sound->host().is_system = true;
  comm->set_sound(sound);
  return result;
}

}  // namespace openr_host
