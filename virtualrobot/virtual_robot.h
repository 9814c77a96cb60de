// The robot behind OPENR:: and OVirtualRobotComm: devices, power and a body.
//
//   RobotModel model = LoadRobotModel(".../ers210.json");
//   AddVirtualRobot(&system, dog, model, MakeOdeBody(model, World()));
#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "runtime/core/code_object.h"
#include "runtime/core/robot_services.h"
#include "virtualrobot/body.h"
#include "virtualrobot/command_queue.h"
#include "virtualrobot/devices.h"
#include "virtualrobot/power.h"
#include "virtualrobot/primitive_table.h"
#include "virtualrobot/sensor_source.h"
#include "virtualrobot/sync_keys.h"

namespace openr_host {

class VirtualRobot : public RobotServices {
 public:
  // `model` must outlive the robot.
  VirtualRobot(System* system, int robot, const RobotModel& model, std::unique_ptr<Body> body);
  ~VirtualRobot() override;

  // ---- for the program, tests and pictures
  const RobotModel& model() const { return model_; }
  const Body& body() const { return *body_; }
  Body& body() { return *body_; }
  const Devices& devices() const { return devices_; }
  Power& power() { return power_; }
  int64_t frame() const { return frame_; }  // frames completed since boot
  const OSensorValue& sensor(int index) const { return sensors_.Latest(index); }
  // Sticks objects' pause button in: see Power::PressPause().
  void PressPause() { power_.PressPause(); }

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
  void HashState(Hasher* hasher) const override;

 private:
  friend class OVirtualRobotComm;

  // Runs the frame that ends now: body, samples.  True when a sensor vector is complete.
  bool FinishFrame();

  // For one joint, or for all opened ones when `id` is oprimitiveID_UNDEF.
  template <typename Function>
  OStatus ForJoints(OPrimitiveID id, Function function);

  System* const system_;
  const RobotModel& model_;
  std::unique_ptr<Body> body_;
  PrimitiveTable primitives_;
  Devices devices_;
  Power power_;
  SensorSource sensors_;
  SyncKeys sync_keys_;
  int64_t frame_ = 0;
};

// The system object with the services Effector and Sensor; the clock of the robot.
//
// Frame n lasts from n * 8 ms to (n + 1) * 8 ms.  At its end the body has moved and
// the samples of frame n are taken; then vectors that are over get their ready, and
// the set points of frame n + 1 are put in force.
class OVirtualRobotComm : public CodeObject {
 public:
  explicit OVirtualRobotComm(VirtualRobot* robot);
  ~OVirtualRobotComm() override;

  OStatus DoStart(const OSystemEvent& event) override;
  OStatus DoDestroy(const OSystemEvent& event) override;
  void HashState(Hasher* hasher) const override;

 private:
  struct Source {
    SubjectID subject;
    CommandQueue queue;
  };

  void NotifyEffector(const ONotifyEvent& event);
  void Frame();
  void PostNextFrame();
  void FinishVectors();
  void ApplyCommands();

  VirtualRobot* const robot_;
  OObserver* effector_;
  OSubject* sensor_;
  Selector frame_;
  bool running_ = false;
  std::vector<Source> sources_;  // in order of first appearance
};

// Gives robot `robot` of `system` a body and the objects that stand for it.
// `model` must outlive the system.
VirtualRobot* AddVirtualRobot(System* system, int robot, const RobotModel& model,
                              std::unique_ptr<Body> body);

}  // namespace openr_host
