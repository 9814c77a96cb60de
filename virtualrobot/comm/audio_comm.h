// The system object OVirtualRobotAudioComm, with the services Speaker and Mic.
//
// This object has no clock of its own.  OVirtualRobotComm runs the frames of the robot (8 ms each).
// In each frame in which sound is to be played or recorded, it sends a message to this object after
// command vectors have started.  So a sound and a motion whose vectors have the same
// synchronisation key begin in the same frame, and a robot without sound costs nothing.
#pragma once

#include "runtime/core/code_object.h"
#include "virtualrobot/comm/sound_queue.h"

namespace openr_host {

struct RobotParts;

class OVirtualRobotAudioComm : public CodeObject {
 public:
  explicit OVirtualRobotAudioComm(RobotParts* robot);
  ~OVirtualRobotAudioComm() override;

  OStatus DoStart(const OSystemEvent& event) override;
  OStatus DoDestroy(const OSystemEvent& event) override;
  void HashState(Hasher* hasher) const override;

  // Tells the robot's SyncKeys that the first waiting sound vector could start now, so that vectors
  // with the same synchronisation key start together (see SoundQueue::AnnounceFirst()).
  // OVirtualRobotComm calls this function in every frame.
  void AnnounceFirst();

  // Posts the message that runs Frame(), if sound is to be played or recorded.  OVirtualRobotComm
  // calls this function at the end of every frame.
  void WakeIfNeeded();

 private:
  void NotifySpeaker(const ONotifyEvent& event);
  void Frame();

  // Asserts ready to each subject whose vector is over, so that the subject sends its next vector.
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
