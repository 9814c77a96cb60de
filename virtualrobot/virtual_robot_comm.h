// The system object with the services Effector, Sensor and FbkImageSensor; the clock of
// the robot.
//
// Frame n lasts from n * 8 ms to (n + 1) * 8 ms.  At its end the body has moved and
// the samples of frame n are taken; then vectors that are over get their ready, and
// the set points of frame n + 1 are put in force.
#pragma once

#include <vector>

#include "runtime/core/code_object.h"
#include "virtualrobot/command_queue.h"

namespace openr_host {

class OVirtualRobotAudioComm;
class VirtualRobot;

class OVirtualRobotComm : public CodeObject {
 public:
  explicit OVirtualRobotComm(VirtualRobot* robot);
  ~OVirtualRobotComm() override;

  // The object to be woken in frames in which it has something to do.
  void set_sound(OVirtualRobotAudioComm* sound) { sound_ = sound; }

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
  void ReadCamera();
  void SendImage();
  // Findings about whoever sent the vector.
  void Report(const SubjectID& subject, std::vector<std::string>* problems);

  VirtualRobot* const robot_;
  OVirtualRobotAudioComm* sound_ = nullptr;
  OObserver* effector_;
  OSubject* sensor_;
  OSubject* image_;
  RegionReference exposed_;  // the image that is being read out
  Selector frame_;
  bool running_ = false;
  std::vector<Source> sources_;  // in order of first appearance
};

}  // namespace openr_host
