#include "virtualrobot/virtual_robot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "runtime/base/assert.h"
#include "runtime/base/spelling.h"
#include "runtime/config/line_file.h"
#include "runtime/core/current.h"
#include "runtime/core/debugger_locators.h"
#include "runtime/core/system.h"
#include "runtime/stick/memory_stick.h"
#include "virtualrobot/comm/audio_comm.h"
#include "virtualrobot/comm/virtual_robot_comm.h"
#include "virtualrobot/primitive_requests.h"

namespace openr_host {

VirtualRobot::VirtualRobot(System* system, int robot, const RobotModel& model,
                           std::unique_ptr<Body> body, VirtualRobotOptions options)
    : parts_(system, robot, model, std::move(body), std::move(options)) {
  // Stores the locators of the primitives where debuggers find them.  Only robot 0 does this,
  // because all robots of a run are of one model and have the same locators.
  if (robot == 0) SetLocatorsForDebugger(parts_.primitives.Lines());
}

VirtualRobot::~VirtualRobot() = default;

void VirtualRobot::set_first_frame(int64_t frame) {
  ASSERT(this->frame() == 0, "{} frames have run", this->frame());
  parts_.frame = parts_.first_frame = frame;
}

void VirtualRobot::CheckServos() {
  std::vector<std::string> problems;
  parts_.watch.ServosChanged(parts_.body->state(), parts_.power.motor_power(), &problems);
  for (std::string& problem : problems) parts_.Warn(std::move(problem));
}

OStatus VirtualRobot::OpenPrimitive(const char* locator, OPrimitiveID* id) {
  *id = parts_.primitives.IdOf(locator);
  if (*id == oprimitiveID_UNDEF) return oNOT_FOUND;
  Primitive* const primitive = parts_.primitives.Find(*id);
  // Returns oNOT_FOUND for a missing part, because an ERS-7 with a broken part logged status 6,
  // which is oNOT_FOUND (field-notes.md 5.4).
  if (primitive->is_missing) {
    *id = oprimitiveID_UNDEF;
    return oNOT_FOUND;
  }
  ++primitive->open_count;
  return oSUCCESS;
}

OStatus VirtualRobot::ClosePrimitive(OPrimitiveID id) {
  Primitive* const primitive = parts_.primitives.Find(id);
  if (primitive == nullptr || !primitive->opened()) return oINVALID_PRIMITIVE_ID;
  --primitive->open_count;
  ASSERT(primitive->open_count >= 0, "{}: {}", primitive->locator, primitive->open_count);
  return oSUCCESS;
}

template <typename Function>
OStatus VirtualRobot::ForJoints(OPrimitiveID id, Function function) {
  if (id != oprimitiveID_UNDEF) {
    const Primitive* const primitive = parts_.primitives.Find(id);
    if (primitive == nullptr || primitive->kind != PrimitiveKind::kJoint)
      return oINVALID_PRIMITIVE_ID;
    return function(primitive->index);
  }
  OStatus status = oSUCCESS;
  for (const Sensor& sensor : parts_.model.sensors) {
    const Primitive* const primitive =
        parts_.primitives.Find(parts_.primitives.IdOf(sensor.locator));
    if (primitive->kind != PrimitiveKind::kJoint || !primitive->opened()) continue;
    const OStatus one = function(primitive->index);
    if (one != oSUCCESS) status = one;
  }
  return status;
}

OStatus VirtualRobot::EnableJointGain(OPrimitiveID id) {
  const OStatus status =
      ForJoints(id, [this](int joint) { return parts_.devices.EnableGain(joint); });
  CheckServos();
  return status;
}

OStatus VirtualRobot::DisableJointGain(OPrimitiveID id) {
  const OStatus status =
      ForJoints(id, [this](int joint) { return parts_.devices.DisableGain(joint); });
  CheckServos();
  return status;
}

OStatus VirtualRobot::SetJointGain(OPrimitiveID id, const word gains[6]) {
  GainWords words;
  std::copy_n(gains, 6, words.begin());
  const OStatus status =
      ForJoints(id, [&](int joint) { return parts_.devices.SetGain(joint, words); });
  CheckServos();
  return status;
}

OStatus VirtualRobot::GetJointGain(OPrimitiveID id, word gains[6]) {
  if (id == oprimitiveID_UNDEF) return oINVALID_PRIMITIVE_ID;
  return ForJoints(id, [&](int joint) -> OStatus {
    const JointDevice& device = parts_.devices.joints[static_cast<size_t>(joint)];
    if (!device.gain_enabled) return oGAIN_DISABLED;
    std::copy(device.gains.begin(), device.gains.end(), gains);
    return oSUCCESS;
  });
}

OStatus VirtualRobot::RegisterDefaultJointGain(OPrimitiveID id, const word gains[6]) {
  GainWords words;
  std::copy_n(gains, 6, words.begin());
  return ForJoints(id, [&](int joint) -> OStatus {
    parts_.devices.joints[static_cast<size_t>(joint)].registered = words;
    return oSUCCESS;
  });
}

OStatus VirtualRobot::SetDefaultJointGain(OPrimitiveID id) {
  const OStatus status = ForJoints(id, [&](int joint) -> OStatus {
    const auto& registered = parts_.devices.joints[static_cast<size_t>(joint)].registered;
    return registered ? parts_.devices.SetGain(joint, *registered) : oFAIL;
  });
  CheckServos();
  return status;
}

OStatus VirtualRobot::GetDefaultJointGain(OPrimitiveID id, word gains[6]) {
  if (id == oprimitiveID_UNDEF) return oFAIL;
  const OStatus status = ForJoints(id, [&](int joint) -> OStatus {
    const auto& registered = parts_.devices.joints[static_cast<size_t>(joint)].registered;
    if (!registered) return oFAIL;
    std::copy(registered->begin(), registered->end(), gains);
    return oSUCCESS;
  });
  return status == oSUCCESS ? oSUCCESS : oFAIL;
}

const Primitive* VirtualRobot::Readable(OPrimitiveID id, const char* function) {
  const Primitive* const primitive = parts_.primitives.Find(id);
  if (primitive == nullptr || primitive->sensor < 0) return nullptr;
  if (!primitive->opened()) {
    parts_.Warn(fmt::format("{}({}): nobody opened it; on the robot its value means nothing",
                            function, primitive->locator));
  }
  // During the first frame there is no sample yet, so the sensors are sampled now.
  if (frame() == 0) parts_.sensors.SampleNow(*parts_.body, parts_.devices);
  return primitive;
}

OStatus VirtualRobot::GetJointValue(OPrimitiveID id, OJointValue* value) {
  const Primitive* const primitive = Readable(id, "GetJointValue");
  if (primitive == nullptr || primitive->kind != PrimitiveKind::kJoint)
    return oINVALID_PRIMITIVE_ID;
  std::memcpy(static_cast<void*>(value), &parts_.sensors.Latest(primitive->sensor), sizeof *value);
  return oSUCCESS;
}

OStatus VirtualRobot::GetSensorValue(OPrimitiveID id, OSensorValue* value) {
  const Primitive* const primitive = Readable(id, "GetSensorValue");
  if (primitive == nullptr) return oINVALID_PRIMITIVE_ID;
  *value = parts_.sensors.Latest(primitive->sensor);
  return oSUCCESS;
}

OStatus VirtualRobot::ControlPrimitive(OPrimitiveID id, OPrimitiveRequest request, void* param,
                                       size_t param_size, void* result, size_t result_size) {
  return CarryOutRequest(this, id, request, param, param_size, result, result_size);
}

OStatus VirtualRobot::NewSyncKey(OVRSyncKey* key) {
  *key = parts_.sync_keys.New();
  return *key == ovrsynckeyUNDEF ? oNO_SYNC_KEY : oSUCCESS;
}

OStatus VirtualRobot::CancelSyncKey(OVRSyncKey key) {
  return parts_.sync_keys.Cancel(key) ? oSUCCESS : oINVALID_SYNC_KEY;
}

OStatus VirtualRobot::DivideSyncKey(OVRSyncKey key, OVRSyncKey* key1, OVRSyncKey* key2) {
  if (parts_.sync_keys.Divide(key, key1, key2)) return oSUCCESS;
  *key1 = *key2 = ovrsynckeyUNDEF;
  return oFAIL;
}

// Gives the camera the colour tables of a vector that an object has filled.  `id` identifies the
// region of this vector.  If one of the tables is wrong, refuses the whole vector and leaves the
// camera's earlier tables unchanged.
OStatus VirtualRobot::SetCdtVectorData(MemoryRegionID id) {
  RegionTable& regions = parts_.system.regions();
  if (regions.SizeOf(id) < sizeof(OCdtVectorData)) return oFAIL;
  auto* const vector = reinterpret_cast<OCdtVectorData*>(regions.BaseOf(id));
  if (vector->vectorInfo.type != odataCDT_VECTOR) return oINVALID_DATA_TYPE;
  if (vector->vectorInfo.numData > ocdtNUM_CHANNELS) return oINVALID_ARG;
  ColourTables tables = parts_.camera.tables();
  for (longword i = 0; i < vector->vectorInfo.numData; ++i) {
    const OCdtInfo& info = *vector->GetInfo(static_cast<int>(i));
    const Primitive* const primitive = parts_.primitives.Find(info.primitiveID);
    if (primitive == nullptr || primitive->kind != PrimitiveKind::kCamera)
      return oINVALID_PRIMITIVE_ID;
    if (!tables.Set(info)) return oINVALID_ARG;
  }
  parts_.camera.tables() = tables;
  return oSUCCESS;
}

OStatus VirtualRobot::SetMotorPower(OPower power) {
  parts_.power.SetMotorPower(power);
  CheckServos();
  return oSUCCESS;
}

OStatus VirtualRobot::GetBootCondition(OBootCondition* condition) {
  *condition = parts_.power.boot_condition;
  return oSUCCESS;
}

// Shuts the robot down.  First records the reason if it is the pause button or a low battery,
// because System::Shutdown() does not know these two reasons.
OStatus VirtualRobot::Shutdown(const OBootCondition& condition) {
  parts_.power.next_boot = condition;
  // A timed restart is a shutdown after which the boot timer starts the robot again some time
  // later. Adds a note at the second timed restart of a run, because one developer's robot did only
  // the first.  On that robot, only restarts without a waiting time were reliable
  // (field-notes.md 5.13).
  const bool is_timed = (condition.bitmap & obcbBOOT_TIMER) != 0 && condition.bootTime > 0;
  if (is_timed && ++timed_restarts_ == 2) {
    parts_.system.AddFinding(
        Severity::kNote,
        "a timed restart again: one developer's robot did it only once, and only a restart at once "
        "(a time of 0 s) was reliable (field-notes.md 5.13); here it works each time");
  }
  const std::string who = t_current.object == nullptr ? "an object" : t_current.object->name;
  if (parts_.power.pause()) {
    parts_.system.robot_table().NoteEnd(
        parts_.robot_index, {EndKind::kPause, who + " shut the robot down after the pause button"});
  } else if (parts_.power.is_battery_low()) {
    parts_.system.robot_table().NoteEnd(
        parts_.robot_index,
        {EndKind::kBattery, fmt::format("{} shut the robot down with {} % left in its "
                                        "battery; --battery 100% keeps it full",
                                        who, parts_.power.remaining_percent())});
  }
  return oSUCCESS;
}

OStatus VirtualRobot::GetPowerStatus(OPowerStatus* status) {
  *status = parts_.power.Status();
  return oSUCCESS;
}

OStatus VirtualRobot::ObservePowerStatus(const OPowerStatus& notify, const OServiceEntry& entry) {
  if (!entry.IsValid()) return oFAIL;
  parts_.power.Observe(notify, entry);
  return oSUCCESS;
}

OStatus VirtualRobot::UnobservePowerStatus(const OServiceEntry& entry) {
  return parts_.power.Unobserve(entry) ? oSUCCESS : oINVALID_ARG;
}

OStatus VirtualRobot::SetTime(const OTime& time) {
  parts_.power.SetClock(time.GetClock());
  parts_.power.SetTimeDifference(time.GetTimeDif());
  return oSUCCESS;
}

OStatus VirtualRobot::GetTime(OTime* time) {
  *time = OTime(parts_.power.Clock(), parts_.power.time_difference());
  return oSUCCESS;
}

OStatus VirtualRobot::SetTimeDifference(sbyte hours) {
  if (hours < -12 || hours > 12) return oFAIL;
  parts_.power.SetTimeDifference(hours);
  return oSUCCESS;
}

OStatus VirtualRobot::GetTimeDifference(sbyte* hours) {
  *hours = parts_.power.time_difference();
  return oSUCCESS;
}

OStatus VirtualRobot::SetVolumeSwitch(OVolumeSwitch volume) {
  if (volume > ovolumeSW3) return oFAIL;
  parts_.power.SetVolume(volume);
  return oSUCCESS;
}

OStatus VirtualRobot::GetVolumeSwitch(OVolumeSwitch* volume) {
  *volume = parts_.power.volume();
  return oSUCCESS;
}

std::optional<int64_t> VirtualRobot::TimeOffUs() const {
  const OBootCondition& boot = parts_.power.next_boot;
  const bool has_timer = (boot.bitmap & obcbBOOT_TIMER) != 0;
  if (!has_timer || boot.bootTimeType != obcbttRELATIVE || boot.bootTime < 0) return {};
  return kBootUs + int64_t{boot.bootTime} * 1'000'000;
}

void VirtualRobot::SwitchOff() { parts_.SwitchOff(); }

void VirtualRobot::RunFrameWhileOff() {
  parts_.shared_frame->End(parts_.system.now_us());
  parts_.NoteFrame(false);
}

void VirtualRobot::Reseed(uint64_t seed) { parts_.Reseed(seed); }

void VirtualRobot::HashState(Hasher* hasher) const { parts_.HashState(hasher); }

namespace {

// The paths on the stick at which VRCOMM.CFG may be.  With the line "JamDetectionHighThreshold" in
// this file, the robot waits longer before it shuts down because of a jammed joint.  Nobody wrote
// down in which of the two folders for configuration files VRCOMM.CFG lies, so both paths are
// tried.
constexpr const char* kJamFiles[] = {"/MS/OPEN-R/MW/CONF/VRCOMM.CFG",
                                     "/MS/OPEN-R/SYSTEM/CONF/VRCOMM.CFG"};
constexpr char kJamKey[] = "JamDetectionHighThreshold";

// Reads from the stick whether the robot is to wait longer before it shuts down because of a jammed
// joint (field-notes.md 7.20).  Only robots that look for jammed joints have this setting.
void ReadJamSetting(RobotParts* parts) {
  MemoryStick* const stick = parts->system.robot(parts->robot_index).stick.get();
  if (stick == nullptr || parts->model.protection.jam_frames == 0) return;
  parts->protection.set_patient(false);
  for (const char* file : kJamFiles) {
    const std::optional<std::string> text = stick->ReadFile(file);
    if (!text) continue;
    std::vector<Diagnostic> ignored;
    const std::vector<RecordLine> lines = ReadRecords(file, *text, parts->model.design, &ignored);
    const bool has_key = std::any_of(lines.begin(), lines.end(), [](const RecordLine& line) {
      return EqualsIgnoringCase(line.words[0].text, kJamKey);
    });
    if (!has_key) continue;
    parts->protection.set_patient(true);
    parts->system.AddFindingAboutRobot(
        parts->robot_index, Severity::kNote,
        fmt::format("{}: {}: a joint may be jammed for {} ms before the robot shuts down (the "
                    "number is chosen: how patient it becomes is not known)",
                    file, kJamKey, parts->protection.jam_frames() * 8));
    return;
  }
}

}  // namespace

void AddSystemObjects(VirtualRobot* robot) {
  RobotParts* const parts = &robot->parts();
  System& system = parts->system;
  ReadJamSetting(parts);
  auto* const comm =
      system.AddObject<OVirtualRobotComm>(parts->robot_index, kVirtualRobotComm, parts);
  comm->host().set_system(true);
  auto* const sound =
      system.AddObject<OVirtualRobotAudioComm>(parts->robot_index, kVirtualRobotAudioComm, parts);
  sound->host().set_system(true);
  comm->set_sound(sound);
}

VirtualRobot* AddVirtualRobot(System* system, int robot, const RobotModel& model,
                              std::unique_ptr<Body> body, VirtualRobotOptions options) {
  auto services =
      std::make_unique<VirtualRobot>(system, robot, model, std::move(body), std::move(options));
  VirtualRobot* const result = services.get();
  system->robot(robot).services = std::move(services);
  AddSystemObjects(result);
  result->parts().hands.AddInputs();
  result->parts().targets.AddInputs();
  result->parts().faults.AddInputs();
  return result;
}

}  // namespace openr_host
