// The system object with the services Effector, Sensor and FbkImageSensor.  This object is the
// clock of the robot: Frame() runs every 8 ms.  Frame n lasts from n * 8 ms to (n + 1) * 8 ms, and
// Frame() runs at its end.
#pragma once

#include <string>
#include <vector>

#include "runtime/core/code_object.h"
#include "virtualrobot/comm/command_queue.h"
#include "virtualrobot/power/protection.h"
#include "virtualrobot/vectors/region_reference.h"

namespace openr_host {

class OVirtualRobotAudioComm;
struct RobotParts;

class OVirtualRobotComm : public CodeObject {
 public:
  // Makes the object for the parts of `robot`, which must outlive the object.
  explicit OVirtualRobotComm(RobotParts* robot);
  ~OVirtualRobotComm() override;

  // Sets the object that plays and records the robot's sound.  In each frame of 8 ms, this
  // OVirtualRobotComm tells that object to do its work for the frame.  Null: no sound is played or
  // recorded.
  void set_sound(OVirtualRobotAudioComm* sound) { sound_ = sound; }

  OStatus DoStart(const OSystemEvent& event) override;
  OStatus DoDestroy(const OSystemEvent& event) override;
  void HashState(Hasher* hasher) const override;

 private:
  void NotifyEffector(const ONotifyEvent& event);
  void Frame();
  void PostNextFrame();
  void ReportOverload();
  void Protect(Protection::Reason reason);
  // Adds a warning for each text in `problems`, about the object that has `subject`.
  void Report(const SubjectID& subject, std::vector<std::string> problems);

  RobotParts& robot_;
  OVirtualRobotAudioComm* sound_ = nullptr;
  OObserver* effector_;
  OSubject* sensor_;
  OSubject* image_;
  RegionReference exposed_;  // the image that the camera is reading out of its sensor
  Selector frame_;
  bool running_ = false;
  // Queues of command vectors, one for each sender, in the order in which the senders sent their
  // first command vectors.
  std::vector<CommandQueue> queues_;
};

}  // namespace openr_host
