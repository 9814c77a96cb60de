// OVirtualRobotComm: the Effector and Sensor services.
#include <fmt/format.h>

#include "runtime/core/hasher.h"
#include "runtime/core/system.h"
#include "virtualrobot/virtual_robot.h"

namespace openr_host {
namespace {

// One event can carry this many vectors, so a subject may queue them in one go.
constexpr size_t kEffectorBuffer = MAX_NUM_DATA;

}  // namespace

OVirtualRobotComm::OVirtualRobotComm(VirtualRobot* robot) : robot_(robot) {
  effector_ = AddObserver("OVirtualRobotComm.Effector.OCommandVectorData.O",
                          [this](const ONotifyEvent& event) { NotifyEffector(event); });
  effector_->SetBufCtrlParam(0, 1, kEffectorBuffer);
  sensor_ = AddSubject("OVirtualRobotComm.Sensor.OSensorFrameVectorData.S");
  frame_ = AddExtra("Frame", [this](void*) { Frame(); });
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
  const int64_t next = (system().now_us() / kFrameUs + 1) * kFrameUs;
  system().Post(message, next - system().now_us());
}

void OVirtualRobotComm::Frame() {
  const bool vector_complete = robot_->FinishFrame();
  FinishVectors();
  ApplyCommands();
  if (vector_complete && sensor_->NumberOfObservers() > 0) {
    sensor_->SetData(robot_->sensors_.MakeVector());
    sensor_->NotifyObservers();
  }
  if (running_) PostNextFrame();
}

void OVirtualRobotComm::FinishVectors() {
  for (Source& source : sources_) {
    while (RCRegion* const region = source.queue.TakeFinished(robot_->frame_)) {
      region->RemoveReference();
      effector_->AssertReady(source.subject);
    }
  }
}

void OVirtualRobotComm::ApplyCommands() {
  std::vector<std::string> problems;
  for (Source& source : sources_) source.queue.Announce(&robot_->sync_keys_);
  for (Source& source : sources_) {
    source.queue.Apply(robot_->frame_, &robot_->primitives_, &robot_->devices_, &robot_->sync_keys_,
                       &problems);
  }
  for (std::string& problem : problems) system().AddFinding(Severity::kWarning, std::move(problem));
}

void OVirtualRobotComm::NotifyEffector(const ONotifyEvent& event) {
  const SubjectID subject = event.SenderID().GetSubjectID();
  auto source = std::find_if(sources_.begin(), sources_.end(),
                             [&](const Source& each) { return each.subject == subject; });
  if (source == sources_.end()) source = sources_.insert(sources_.end(), Source{subject, {}});
  for (int i = 0; i < event.NumOfData(); ++i) {
    RCRegion* const region = event.RCData(i);
    region->AddReference();
    if (source->queue.Add(region)) continue;
    region->RemoveReference();
    system().AddFinding(
        Severity::kWarning,
        fmt::format("Effector: more than {} command vectors of one subject wait; the newest is "
                    "dropped",
                    CommandQueue::kMax));
  }
}

void OVirtualRobotComm::HashState(Hasher* hasher) const {
  for (const Source& source : sources_) source.queue.HashState(hasher);
}

}  // namespace openr_host
