// The robot as the functions of OPENR:: see it.  This class answers the calls of objects about
// primitives (joints, sensors, lights ...), gains, power and time.  OVirtualRobotComm runs the
// frames of 8 ms (virtual_robot_comm.cc).
//
//   RobotModel model = LoadRobotModel(".../ers210.json");
//   AddVirtualRobot(&system, dog, model, MakeOdeBody(model, World()),
//                   {.speaker = OpenSpeakerFile("bark.wav")});
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "runtime/core/robot_services.h"
#include "virtualrobot/robot/robot_parts.h"

namespace openr_host {

class VirtualRobot : public RobotServices {
 public:
  // Makes robot number `robot` of `system`.  `system` and `model` must outlive the robot.
  VirtualRobot(System* system, int robot, const RobotModel& model, std::unique_ptr<Body> body,
               VirtualRobotOptions options = {});
  ~VirtualRobot() override;

  // ---- Functions for the command-line program, for tests and for pictures of the robot
  const RobotModel& model() const { return parts_.model; }
  const Body& body() const { return *parts_.body; }
  Body& body() { return *parts_.body; }
  const Devices& devices() const { return parts_.devices; }
  const Speaker& speaker() const { return parts_.speaker; }
  Power& power() { return parts_.power; }
  const OSensorValue& sensor(int index) const { return parts_.sensors.Latest(index); }

  // Virtual time that a robot with a boot timer needs to boot, in addition to the time of its
  // timer.  The time that the real robot needs is not known; the number is our choice, and long
  // enough for the body to lie still.
  static constexpr int64_t kBootUs = 3'000'000;

  // Returns the number of frames completed since the last boot.
  int64_t frame() const { return parts_.frame - parts_.first_frame; }

  // Sets the number of the first frame, to simulate a robot that has been on for days.  REQUIRES:
  // no frame has run yet.
  void set_first_frame(int64_t frame);

  // Returns whether the camera completed an image with the newest frame.
  bool HasNewImage() const { return parts_.camera.Due(parts_.frame); }

  // Writes the image that the camera has just completed to `picture` (see
  // CameraDevice::CopyPicture()).
  std::string CopyPicture(Picture* picture) {
    return parts_.camera.CopyPicture(parts_.frame, *parts_.body, picture);
  }

  // Writes to `colours` a picture that shows what the camera's colour detection finds in the image
  // that the camera has just completed (see CameraDevice::CopyColours()).
  std::string CopyColours(Picture* colours) {
    return parts_.camera.CopyColours(parts_.frame, *parts_.body, colours);
  }

  // Completes the file of the speaker at the end of the run.  Returns "", or an error "FILE: cannot
  // be written: reason".
  std::string CloseFiles() { return parts_.speaker.Close(); }

  // Presses the pause button, as a person would on the robot's back (see Power::PressPause()).
  void PressPause() { parts_.power.PressPause(); }

  // Starts to move the joints of `object`, which has crashed, to a safe posture (see SafePosture).
  void OnCommanderLost(ObjectId object) {
    parts_.safe_posture.OnCommanderLost(object, parts_.frame);
  }
  void OnCommanderBack(ObjectId object) { parts_.safe_posture.OnCommanderBack(object); }

  // Returns the parts of this robot, for OVirtualRobotComm and OVirtualRobotAudioComm.
  RobotParts& parts() { return parts_; }

  // ---- Implementation of RobotServices
  OPENR_ROBOT_CALLS(OPENR_OVERRIDE_CALL, OPENR_OVERRIDE_CALL)
  std::optional<int64_t> TimeOffUs() const override;
  void SwitchOff() override;
  void RunFrameWhileOff() override;
  void Reseed(uint64_t seed) override;
  void HashState(Hasher* hasher) const override;

 private:
  // Calls `function` with the index of joint `id`, or of every opened joint when `id` is
  // oprimitiveID_UNDEF.
  template <typename Function>
  OStatus ForJoints(OPrimitiveID id, Function function);

  // Called after a change of gains or motor power.  Adds a warning for each servo that has become
  // active by this change, if its joint is far from the set point or no set point was sent yet.
  void CheckServos();

  // Returns the primitive that `function` of OPENR:: reads; null when primitive `id` has no sensor.
  // Warns when no object has opened the primitive, because on the robot the value of such a
  // primitive means nothing.
  const Primitive* Readable(OPrimitiveID id, const char* function);

  RobotParts parts_;
  int timed_restarts_ = 0;  // how often objects asked, in this run, for a restart after a wait
};

// Adds the two system objects of `robot`, OVirtualRobotComm and OVirtualRobotAudioComm, to its
// system.  Called when the robot is made, and at each later boot.
void AddSystemObjects(VirtualRobot* robot);

// Gives robot number `robot` of `system` a body and its two system objects, OVirtualRobotComm and
// OVirtualRobotAudioComm.  `model` must outlive the system.
VirtualRobot* AddVirtualRobot(System* system, int robot, const RobotModel& model,
                              std::unique_ptr<Body> body, VirtualRobotOptions options = {});

}  // namespace openr_host
