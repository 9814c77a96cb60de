#include "virtualrobot/comm/audio_comm.h"

#include <fmt/format.h>

#include <utility>

#include "runtime/core/api.h"
#include "runtime/core/system.h"
#include "virtualrobot/comm/listeners.h"
#include "virtualrobot/robot/robot_parts.h"

namespace openr_host {

OVirtualRobotAudioComm::OVirtualRobotAudioComm(RobotParts* robot) : robot_(*robot), queue_(robot) {
  speaker_ = AddObserver("OVirtualRobotAudioComm.Speaker.OSoundVectorData.O",
                         [this](const ONotifyEvent& event) { NotifySpeaker(event); });
  mic_ = AddSubject("OVirtualRobotAudioComm.Mic.OSoundVectorData.S");
  frame_ = AddExtra("Frame", [this](void*) { Frame(); });
  host().set_post_class(MessageClass::kVector);
}

OVirtualRobotAudioComm::~OVirtualRobotAudioComm() = default;

OStatus OVirtualRobotAudioComm::DoStart(const OSystemEvent&) {
  running_ = true;
  speaker_->AssertReady();
  return oSUCCESS;
}

OStatus OVirtualRobotAudioComm::DoDestroy(const OSystemEvent&) {
  running_ = false;
  queue_.Clear();
  return oSUCCESS;
}

void OVirtualRobotAudioComm::AnnounceFirst() { queue_.AnnounceFirst(); }

void OVirtualRobotAudioComm::WakeIfNeeded() {
  const bool mic_due = robot_.microphone.Due(robot_.frame) && HasListener(*mic_);
  if (!running_ || (!queue_.busy() && !mic_due)) return;
  OwnedMessage message = system().NewMessage(host().id, frame_);
  message->message_class = MessageClass::kFrame;
  system().Post(std::move(message));
}

void OVirtualRobotAudioComm::Frame() {
  GiveReadies();
  PlayFrame();
  if (robot_.microphone.Due(robot_.frame) && HasListener(*mic_)) {
    SendToListeners(mic_, robot_.microphone.MakeVector(robot_.frame));
  }
}

void OVirtualRobotAudioComm::GiveReadies() {
  while (const auto subject = queue_.ReleaseFinished()) speaker_->AssertReady(*subject);
}

void OVirtualRobotAudioComm::PlayFrame() {
  if (!queue_.busy()) return;
  SoundFrame samples;
  std::vector<SoundProblem> problems;
  const bool plays = queue_.Fill(robot_.frame, &samples, &problems);
  for (SoundProblem& problem : problems) {
    system().AddFindingAbout(system().object(ObjectIdOf(problem.subject.GetOID())),
                             Severity::kWarning, std::move(problem.text));
  }
  if (!plays) return;
  // Gives no warning about missing motor power after the pause button was pressed.  The speaker's
  // amplifier then has no power, but this is no mistake of the program.
  const bool power = robot_.power.motor_power();
  if (!power && !robot_.power.pause()) {
    system().AddFinding(Severity::kWarning,
                        "sound is played while motor power is off; the speaker's amplifier has "
                        "none either (OPENR::SetMotorPower(opowerON))");
  }
  const std::string problem = robot_.speaker.Play(robot_.frame, samples, power);
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
