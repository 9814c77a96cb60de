// The robot behind OPENR::, OVirtualRobotComm and OVirtualRobotAudioComm: devices, power,
// sound, camera and a body.
//
//   RobotModel model = LoadRobotModel(".../ers210.json");
//   AddVirtualRobot(&system, dog, model, MakeOdeBody(model, World()),
//                   {.speaker = OpenSpeakerFile("bark.wav")});
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "runtime/core/robot_services.h"
#include "virtualrobot/body.h"
#include "virtualrobot/camera/camera.h"
#include "virtualrobot/camera/image_source.h"
#include "virtualrobot/devices.h"
#include "virtualrobot/joint_watch.h"
#include "virtualrobot/optional_bytes.h"
#include "virtualrobot/power.h"
#include "virtualrobot/primitive_table.h"
#include "virtualrobot/safe_posture.h"
#include "virtualrobot/sensor_source.h"
#include "virtualrobot/sound/microphone.h"
#include "virtualrobot/sound/sound_sink.h"
#include "virtualrobot/sound/sound_source.h"
#include "virtualrobot/sound/speaker.h"
#include "virtualrobot/sync_keys.h"

namespace openr_host {

// What a robot is connected with; nothing has to be.
struct VirtualRobotOptions {
  std::unique_ptr<SoundSink> speaker;       // null: its sound goes nowhere
  std::unique_ptr<SoundSource> microphone;  // null: silence
  std::unique_ptr<ImageSource> camera;      // null: the test pattern
  Battery battery;                          // full at boot, and drains
};

class VirtualRobot : public RobotServices {
 public:
  // `model` must outlive the robot.
  VirtualRobot(System* system, int robot, const RobotModel& model, std::unique_ptr<Body> body,
               VirtualRobotOptions options = {});
  ~VirtualRobot() override;

  // ---- for the program, tests and pictures
  const RobotModel& model() const { return model_; }
  const Body& body() const { return *body_; }
  Body& body() { return *body_; }
  const Devices& devices() const { return devices_; }
  const Speaker& speaker() const { return speaker_; }
  Power& power() { return power_; }
  int64_t frame() const { return frame_ - first_frame_; }  // frames completed since boot
  // The number of the first frame, as on a robot that has been on for days.  REQUIRES: before
  // Boot().
  void set_first_frame(int64_t frame) { frame_ = first_frame_ = frame; }
  const OSensorValue& sensor(int index) const { return sensors_.Latest(index); }
  // Whether the camera has completed an image with the newest frame, and what it shows: see
  // CameraDevice::Look().
  bool ImageIsDue() const { return camera_.Due(frame_); }
  std::string Look(Picture* picture) { return camera_.Look(frame_, *body_, picture); }
  // The run is over: the file of the speaker is complete.  "FILE: cannot be written: why", or "".
  std::string CloseFiles() { return speaker_.Close(); }

  // Sticks objects' pause button in: see Power::PressPause().
  void PressPause() { power_.PressPause(); }

  // An object that sent command vectors is gone; see SafePosture.
  void CommanderIsGone(ObjectId object) { safe_posture_.CommanderIsGone(object, frame_); }
  void CommanderIsBack(ObjectId object) { safe_posture_.CommanderIsBack(object); }

  // ---- RobotServices
  OStatus OpenPrimitive(const char* locator, OPrimitiveID* id) override;
  OStatus ClosePrimitive(OPrimitiveID id) override;
  OStatus ControlPrimitive(OPrimitiveID id, OPrimitiveRequest request, void* param,
                           size_t param_size, void* result, size_t result_size) override;
  OStatus EnableJointGain(OPrimitiveID id) override;
  OStatus DisableJointGain(OPrimitiveID id) override;
  OStatus SetJointGain(OPrimitiveID id, const word gains[6]) override;
  OStatus GetJointGain(OPrimitiveID id, word gains[6]) override;
  OStatus RegisterDefaultJointGain(OPrimitiveID id, const word gains[6]) override;
  OStatus SetDefaultJointGain(OPrimitiveID id) override;
  OStatus GetDefaultJointGain(OPrimitiveID id, word gains[6]) override;
  OStatus GetJointValue(OPrimitiveID id, OJointValue* value) override;
  OStatus GetSensorValue(OPrimitiveID id, OSensorValue* value) override;
  OStatus NewSyncKey(OVRSyncKey* key) override;
  OStatus CancelSyncKey(OVRSyncKey key) override;
  OStatus DivideSyncKey(OVRSyncKey key, OVRSyncKey* key1, OVRSyncKey* key2) override;
  OStatus SetCdtVectorData(MemoryRegionID id) override;
  OStatus SetMotorPower(OPower power) override;
  OStatus GetBootCondition(OBootCondition* condition) override;
  OStatus Shutdown(const OBootCondition& condition) override;
  OStatus GetPowerStatus(OPowerStatus* status) override;
  OStatus ObservePowerStatus(const OPowerStatus& notify, const OServiceEntry& entry) override;
  OStatus UnobservePowerStatus(const OServiceEntry& entry) override;
  OStatus SetTime(const OTime& time) override;
  OStatus GetTime(OTime* time) override;
  OStatus SetTimeDifference(sbyte hours) override;
  OStatus GetTimeDifference(sbyte* hours) override;
  OStatus SetVolumeSwitch(OVolumeSwitch volume) override;
  OStatus GetVolumeSwitch(OVolumeSwitch* volume) override;
  void Reseed(uint64_t seed) override;
  void HashState(Hasher* hasher) const override;

 private:
  friend class OVirtualRobotComm;
  friend class OVirtualRobotAudioComm;
  friend struct PrimitiveRequests;  // of ControlPrimitive()

  // Runs the frame that ends now: body, samples.  True when a sensor vector is complete.
  bool FinishFrame();

  // What has been pushing for too long makes the robot shut down.
  void WatchLoad();

  // For one joint, or for all opened ones when `id` is oprimitiveID_UNDEF.
  template <typename Function>
  OStatus ForJoints(OPrimitiveID id, Function function);

  // After a change of gains or motor power.
  void LookAtServos();
  // A finding about the object that called.
  void Warn(std::string text);
  // Reading a primitive that nobody opened means nothing on the robot.
  const Primitive* Readable(OPrimitiveID id, const char* function);

  System* const system_;
  const int robot_;
  const RobotModel& model_;
  std::unique_ptr<Body> body_;
  PrimitiveTable primitives_;
  Devices devices_;
  Power power_;
  SensorSource sensors_;
  SyncKeys sync_keys_;
  OptionalBytes optional_;
  JointWatch watch_;
  Speaker speaker_;
  Microphone microphone_;
  CameraDevice camera_;
  SafePosture safe_posture_;
  int64_t first_frame_ = 0;
  int64_t frame_ = 0;
};

// Gives robot `robot` of `system` a body and the objects that stand for it.
// `model` must outlive the system.
VirtualRobot* AddVirtualRobot(System* system, int robot, const RobotModel& model,
                              std::unique_ptr<Body> body, VirtualRobotOptions options = {});

}  // namespace openr_host
