// The system object with the services Effector, Sensor and FbkImageSensor.  It is the clock of the
// robot: Frame() runs every 8 ms, from n * 8 ms to (n + 1) * 8 ms for frame n, and is posted for
// the end of the frame.
#pragma once

#include <string>
#include <vector>

#include "runtime/core/code_object.h"
#include "virtualrobot/command_queue.h"
#include "virtualrobot/region_reference.h"

namespace openr_host {

class OVirtualRobotAudioComm;
struct RobotParts;

class OVirtualRobotComm : public CodeObject {
 public:
  // `robot` must outlive the object.
  explicit OVirtualRobotComm(RobotParts* robot);
  ~OVirtualRobotComm() override;

  // The object that plays and records sound in the same frames.  Null: there is none.
  void set_sound(OVirtualRobotAudioComm* sound) { sound_ = sound; }

  OStatus DoStart(const OSystemEvent& event) override;
  OStatus DoDestroy(const OSystemEvent& event) override;
  void HashState(Hasher* hasher) const override;

 private:
  void NotifyEffector(const ONotifyEvent& event);
  void Frame();
  void PostNextFrame();
  void ReportOverload();
  // Adds a warning about the object of `subject` for each problem.
  void Report(const SubjectID& subject, std::vector<std::string> problems);

  RobotParts& robot_;
  OVirtualRobotAudioComm* sound_ = nullptr;
  OObserver* effector_;
  OSubject* sensor_;
  OSubject* image_;
  RegionReference exposed_;  // the image that is being read out of the camera's sensor
  Selector frame_;
  bool running_ = false;
  std::vector<CommandQueue> queues_;  // one for each subject, in the order of their first vectors
};

}  // namespace openr_host
