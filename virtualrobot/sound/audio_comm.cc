#include "virtualrobot/sound/audio_comm.h"

#include <fmt/format.h>

#include "runtime/core/api.h"
#include "runtime/core/system.h"
#include "virtualrobot/listeners.h"
#include "virtualrobot/virtual_robot.h"

namespace openr_host {

OVirtualRobotAudioComm::OVirtualRobotAudioComm(VirtualRobot* robot) : robot_(robot) {
  speaker_ = AddObserver("OVirtualRobotAudioComm.Speaker.OSoundVectorData.O",
                         [this](const ONotifyEvent& event) { NotifySpeaker(event); });
  mic_ = AddSubject("OVirtualRobotAudioComm.Mic.OSoundVectorData.S");
  frame_ = AddExtra("Frame", [this](void*) { Frame(); });
  host().post_class = MessageClass::kVector;
}

OVirtualRobotAudioComm::~OVirtualRobotAudioComm() = default;

OStatus OVirtualRobotAudioComm::DoStart(const OSystemEvent&) {
  running_ = true;
  speaker_->AssertReady();
  return oSUCCESS;
}

OStatus OVirtualRobotAudioComm::DoDestroy(const OSystemEvent&) {
  running_ = false;
  return oSUCCESS;
}

void OVirtualRobotAudioComm::Announce() { queue_.Announce(&robot_->sync_keys_); }

void OVirtualRobotAudioComm::WakeIfNeeded() {
  const bool mic_due = robot_->microphone_.Due(robot_->frame_) && HasListener(*mic_);
  if (!running_ || (!queue_.busy() && !mic_due)) return;
  Message* const message = system().NewMessage(host().id, frame_);
  message->message_class = MessageClass::kFrame;
  system().Post(message);
}

void OVirtualRobotAudioComm::Frame() {
  GiveReadies();
  PlayFrame();
  if (robot_->microphone_.Due(robot_->frame_) && HasListener(*mic_)) {
    SendToListeners(mic_, robot_->microphone_.MakeVector(robot_->frame_));
  }
}

void OVirtualRobotAudioComm::GiveReadies() {
  while (const auto subject = queue_.ReleaseFinished()) speaker_->AssertReady(*subject);
}

void OVirtualRobotAudioComm::PlayFrame() {
  if (!queue_.busy()) return;
  const SoundPort port = {&robot_->primitives_, &robot_->speaker_, &robot_->sync_keys_,
                          &robot_->optional_, &system()};
  SoundFrame samples;
  std::vector<SoundProblem> problems;
  const bool plays = queue_.Fill(robot_->frame_, port, &samples, &problems);
  for (SoundProblem& problem : problems) {
    system().AddFindingAbout(system().object(ObjectIdOf(problem.subject.GetOID())),
                             Severity::kWarning, std::move(problem.text));
  }
  if (!plays) return;
  const bool power = robot_->power_.motor_power();
  if (!power && !robot_->power_.pause()) {
    system().AddFinding(Severity::kWarning,
                        "sound is played while motor power is off; the speaker's amplifier has "
                        "none either (OPENR::SetMotorPower(opowerON))");
  }
  const std::string problem = robot_->speaker_.Play(robot_->frame_, samples, power);
  if (!problem.empty()) system().AddFinding(Severity::kError, "Speaker: " + problem);
}

void OVirtualRobotAudioComm::NotifySpeaker(const ONotifyEvent& event) {
  const SubjectID subject = event.SenderID().GetSubjectID();
  for (int i = 0; i < event.NumOfData(); ++i) {
    if (queue_.Add(event.RCData(i), subject)) continue;
    system().AddFindingAbout(system().object(ObjectIdOf(subject.GetOID())), Severity::kWarning,
                             fmt::format("Speaker: more than {} sound vectors wait; the newest is "
                                         "dropped",
                                         SoundQueue::kMax));
  }
}

void OVirtualRobotAudioComm::HashState(Hasher* hasher) const { queue_.HashState(hasher); }

}  // namespace openr_host
