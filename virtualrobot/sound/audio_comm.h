// The system object OVirtualRobotAudioComm, with the services Speaker and Mic.
//
// This object has no clock of its own.  OVirtualRobotComm, which runs the frames of the robot,
// wakes it in frames in which there is sound to play or to record, after command vectors have
// started.  So sound and motion with parts of one synchronisation key begin in the same frame, and
// a robot without sound costs nothing.
#pragma once

#include "runtime/core/code_object.h"
#include "virtualrobot/sound/sound_queue.h"

namespace openr_host {

struct RobotParts;

class OVirtualRobotAudioComm : public CodeObject {
 public:
  explicit OVirtualRobotAudioComm(RobotParts* robot);
  ~OVirtualRobotAudioComm() override;

  OStatus DoStart(const OSystemEvent& event) override;
  OStatus DoDestroy(const OSystemEvent& event) override;
  void HashState(Hasher* hasher) const override;

  // Called by OVirtualRobotComm in every frame.  See SoundQueue::AnnounceFirst().
  void AnnounceFirst();

  // Called by OVirtualRobotComm at the end of every frame: posts the message that runs Frame(), if
  // there is sound to play or to record.
  void WakeIfNeeded();

 private:
  void NotifySpeaker(const ONotifyEvent& event);
  void Frame();

  // Asserts ready to the subjects of vectors that are over.
  void GiveReadies();
  void PlayFrame();

  RobotParts& robot_;
  OObserver* speaker_;
  OSubject* mic_;
  Selector frame_;
  bool running_ = false;
  SoundQueue queue_;
};

}  // namespace openr_host
