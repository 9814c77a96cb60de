#include "virtualrobot/virtual_robot_comm.h"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/base/hasher.h"
#include "runtime/core/api.h"
#include "runtime/core/system.h"
#include "virtualrobot/listeners.h"
#include "virtualrobot/sound/audio_comm.h"
#include "virtualrobot/virtual_robot.h"

namespace openr_host {

OVirtualRobotComm::OVirtualRobotComm(VirtualRobot* robot) : robot_(robot) {
  effector_ = AddObserver("OVirtualRobotComm.Effector.OCommandVectorData.O",
                          [this](const ONotifyEvent& event) { NotifyEffector(event); });
  sensor_ = AddSubject("OVirtualRobotComm.Sensor.OSensorFrameVectorData.S");
  frame_ = AddExtra("Frame", [this](void*) { Frame(); });
  image_ = AddSubject("OVirtualRobotComm.FbkImageSensor.OFbkImageVectorData.S");
  AddSubject("OVirtualRobotComm.Alert.OPrimitiveMapData.S");  // obsolete; nothing comes
  host().post_class = MessageClass::kVector;
}

OVirtualRobotComm::~OVirtualRobotComm() = default;

OStatus OVirtualRobotComm::DoStart(const OSystemEvent&) {
  running_ = true;
  effector_->AssertReady();
  PostNextFrame();
  return oSUCCESS;
}

OStatus OVirtualRobotComm::DoDestroy(const OSystemEvent&) {
  running_ = false;
  return oSUCCESS;
}

void OVirtualRobotComm::PostNextFrame() {
  Message* const message = system().NewMessage(host().id, frame_);
  message->message_class = MessageClass::kFrame;
  const int64_t frame_us = system().frame_us();
  const int64_t next = (system().now_us() / frame_us + 1) * frame_us;
  system().Post(message, next - system().now_us());
}

void OVirtualRobotComm::Frame() {
  const bool vector_complete = robot_->FinishFrame();
  FinishVectors();
  ApplyCommands();
  if (vector_complete && HasListener(*sensor_))
    SendToListeners(sensor_, robot_->sensors_.MakeVector(robot_->optional_));
  ReadCamera();
  if (sound_ != nullptr) sound_->WakeIfNeeded();
  if (running_) PostNextFrame();
}

void OVirtualRobotComm::FinishVectors() {
  for (Source& source : sources_) {
    while (source.queue.ReleaseFinished(robot_->frame_)) effector_->AssertReady(source.subject);
  }
}

void OVirtualRobotComm::ApplyCommands() {
  EffectorPort port;
  port.primitives = &robot_->primitives_;
  port.devices = &robot_->devices_;
  port.sync_keys = &robot_->sync_keys_;
  port.optional = &robot_->optional_;
  port.watch = &robot_->watch_;
  port.system = &system();
  port.body = &robot_->body_->state();
  port.motor_power = robot_->power_.motor_power();
  port.motor_power_cut = robot_->power_.pause();
  for (Source& source : sources_) source.queue.Announce(&robot_->sync_keys_);
  if (sound_ != nullptr) sound_->Announce();
  std::vector<std::string> problems;
  for (Source& source : sources_) {
    robot_->devices_.set_commander(ObjectIdOf(source.subject.GetOID()));
    source.queue.Apply(robot_->frame_, port, &problems);
    if (!problems.empty()) Report(source.subject, &problems);
  }
  robot_->safe_posture_.Apply(robot_->frame_, &robot_->devices_);
}

// An image leaves when the next one is taken.  Nobody says how long reading it out takes, but
// BallTrackingHead finds the angles that belong to it in the two newest sensor vectors (robot.md
// 14): it comes 4 to 8 frames after the frame it shows.
void OVirtualRobotComm::ReadCamera() {
  if (image_->NumberOfObservers() == 0 || !robot_->camera_.Due(robot_->frame_)) return;
  SendImage();
  if (!HasListener(*image_)) return;
  std::string problem;
  exposed_ = RegionReference(robot_->camera_.MakeVector(robot_->frame_, *robot_->body_, &problem));
  if (!problem.empty()) system().AddFinding(Severity::kError, "camera: " + problem);
}

void OVirtualRobotComm::SendImage() {
  if (!exposed_) return;
  SendToListeners(image_, exposed_.get());
  exposed_.Release();
}

void OVirtualRobotComm::NotifyEffector(const ONotifyEvent& event) {
  const SubjectID subject = event.SenderID().GetSubjectID();
  auto source = std::find_if(sources_.begin(), sources_.end(),
                             [&](const Source& each) { return each.subject == subject; });
  if (source == sources_.end()) source = sources_.insert(sources_.end(), Source{subject, {}});
  std::vector<std::string> problems;
  for (int i = 0; i < event.NumOfData(); ++i) {
    if (source->queue.Add(event.RCData(i))) continue;
    problems.push_back(fmt::format(
        "Effector: more than {} command vectors of one subject wait; the newest is dropped",
        CommandQueue::kMax));
  }
  Report(subject, &problems);
}

void OVirtualRobotComm::Report(const SubjectID& subject, std::vector<std::string>* problems) {
  const Object* const sender = system().object(ObjectIdOf(subject.GetOID()));
  for (std::string& problem : *problems)
    system().AddFindingAbout(sender, Severity::kWarning, std::move(problem));
  problems->clear();
}

void OVirtualRobotComm::HashState(Hasher* hasher) const {
  for (const Source& source : sources_) source.queue.HashState(hasher);
}

}  // namespace openr_host
