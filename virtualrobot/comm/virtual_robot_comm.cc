#include "virtualrobot/comm/virtual_robot_comm.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "runtime/base/hasher.h"
#include "runtime/core/api.h"
#include "runtime/core/system.h"
#include "virtualrobot/comm/audio_comm.h"
#include "virtualrobot/comm/listeners.h"
#include "virtualrobot/robot/robot_parts.h"

namespace openr_host {

OVirtualRobotComm::OVirtualRobotComm(RobotParts* robot) : robot_(*robot) {
  effector_ = AddObserver("OVirtualRobotComm.Effector.OCommandVectorData.O",
                          [this](const ONotifyEvent& event) { NotifyEffector(event); });
  sensor_ = AddSubject("OVirtualRobotComm.Sensor.OSensorFrameVectorData.S");
  frame_ = AddExtra("Frame", [this](void*) { Frame(); });
  image_ = AddSubject("OVirtualRobotComm.FbkImageSensor.OFbkImageVectorData.S");
  // Accepts connections to the service Alert but never sends, because the service is obsolete on
  // the robot.
  AddSubject("OVirtualRobotComm.Alert.OPrimitiveMapData.S");
  host().set_post_class(MessageClass::kVector);
}

OVirtualRobotComm::~OVirtualRobotComm() = default;

OStatus OVirtualRobotComm::DoStart(const OSystemEvent&) {
  robot_.faults.ReportMissingLimbs();
  running_ = true;
  effector_->AssertReady();
  PostNextFrame();
  return oSUCCESS;
}

OStatus OVirtualRobotComm::DoDestroy(const OSystemEvent&) {
  running_ = false;
  // Gives back the regions of command vectors (queues_) and of the camera's image (exposed_),
  // because no object reads them after this object is destroyed, and only this object can give them
  // back.
  queues_.clear();
  exposed_.Release();
  return oSUCCESS;
}

void OVirtualRobotComm::PostNextFrame() {
  OwnedMessage message = system().NewMessage(host().id, frame_);
  message->message_class = MessageClass::kFrame;
  const int64_t frame_us = system().frame_us();
  const int64_t next = (system().now_us() / frame_us + 1) * frame_us;
  system().Post(std::move(message), next - system().now_us());
}

// Runs everything that happens at the boundary between two frames.  The order of the steps is the
// order in which objects receive their messages, so a change of the order changes all runs.
void OVirtualRobotComm::Frame() {
  // 1. End the frame that is over: simulate 8 ms in which the set points of the joints and the
  // hands of people move the body, then sample the sensors.
  robot_.shared_frame->End(system().now_us());
  std::vector<Protection::Reason> reasons = robot_.NoteFrame(true);
  const bool is_vector_complete = robot_.sensors.Sample(robot_.frame, *robot_.body, robot_.devices);
  const int64_t frame = ++robot_.frame;  // number of the frame that begins
  robot_.power.Update();
  ReportOverload();
  for (Protection::Reason& reason : reasons) Protect(std::move(reason));

  // 2. Release the command vectors that are over, so that their subjects may send the next ones.
  for (CommandQueue& queue : queues_) {
    while (queue.ReleaseFinished(frame)) effector_->AssertReady(queue.subject());
  }

  // 3. Apply the commands of the frame that begins.  All queues announce the synchronisation key of
  // their first waiting vector before any vector starts, because the vectors among which a key is
  // divided (OPENR::DivideSyncKey()) start together.
  for (CommandQueue& queue : queues_) queue.AnnounceFirst();
  if (sound_ != nullptr) sound_->AnnounceFirst();
  for (CommandQueue& queue : queues_) {
    std::vector<std::string> problems;
    queue.Apply(frame, &problems);
    Report(queue.subject(), std::move(problems));
  }
  robot_.safe_posture.Apply(frame, &robot_.devices);
  robot_.targets.DoFrame();

  // 4. Send the sensor vector, when it has the samples of four frames.
  if (is_vector_complete && HasListener(*sensor_)) {
    SendToListeners(sensor_, robot_.sensors.MakeVector(robot_.optional));
  }

  // 5. Send the image that was taken before, and take the next image.  So an image is sent 4 or 5
  // frames after it was taken.  No source says how much time the camera needs to read out an image.
  // But Sony's sample BallTrackingHead expects images that are 4 to 8 frames old: it looks up the
  // joint angles of the moment of the image in the two newest sensor vectors (robot.md, 14).  These
  // vectors have the samples of 8 frames, and the newest sample is 1 to 4 frames old.
  if (image_->NumberOfObservers() > 0 && robot_.camera.Due(frame)) {
    if (exposed_) SendToListeners(image_, exposed_.get());
    exposed_.Release();
    if (HasListener(*image_)) {
      std::string problem;
      exposed_ = RegionReference(robot_.camera.MakeVector(frame, *robot_.body, &problem));
      if (!problem.empty()) system().AddFinding(Severity::kError, "camera: " + problem);
    }
  }

  // 6. If sound is to be played or recorded, post the message whose handler does this.
  if (sound_ != nullptr) sound_->WakeIfNeeded();
  if (running_) PostNextFrame();
}

// Checks whether the drives of motors have been 78 % of their limits or more for 30 s
// (JointWatch::NoteFrame()).  For each such motor, adds an error finding about the robot's program,
// because a real robot shuts down in this case.
void OVirtualRobotComm::ReportOverload() {
  for (const int joint : robot_.watch.NoteFrame(robot_.body->state())) {
    Protect({fmt::format(
                 "PPM::PWM Limit Over!! Motor:{} ({}); MECHA_LOAD_HIGH. SHUTDOWN.: asked for 78 "
                 "% of its drive or more for 30 s, the robot shuts down",
                 joint, robot_.model.joints[static_cast<size_t>(joint)].locator),
             fmt::format("motor {} was at its limit for 30 s", joint)});
  }
}

// Adds an error finding about the reason for which a real robot would shut down now to protect
// itself, such as too much current.  The simulated robot shuts down only with --strict, so that a
// run without --strict can be examined further.
void OVirtualRobotComm::Protect(Protection::Reason reason) {
  system().AddFinding(Severity::kError, std::move(reason.finding));
  if (!system().options().strict) return;
  system().Shutdown(robot_.robot_index, {EndKind::kStrict, std::move(reason.end)});
}

void OVirtualRobotComm::NotifyEffector(const ONotifyEvent& event) {
  const SubjectID subject = event.SenderID().GetSubjectID();
  auto queue = std::find_if(queues_.begin(), queues_.end(),
                            [&](const CommandQueue& each) { return each.subject() == subject; });
  if (queue == queues_.end()) {
    queues_.push_back(CommandQueue(subject, &robot_));
    queue = queues_.end() - 1;
  }
  std::vector<std::string> problems;
  for (int i = 0; i < event.NumOfData(); ++i) {
    if (queue->Add(event.RCData(i))) continue;
    problems.push_back(fmt::format(
        "Effector: more than {} command vectors of one subject wait; the newest is dropped",
        CommandQueue::kMax));
  }
  Report(subject, std::move(problems));
}

void OVirtualRobotComm::Report(const SubjectID& subject, std::vector<std::string> problems) {
  const Object* const sender = system().object(ObjectIdOf(subject.GetOID()));
  for (std::string& problem : problems) {
    system().AddFindingAbout(sender, Severity::kWarning, std::move(problem));
  }
}

void OVirtualRobotComm::HashState(Hasher* hasher) const {
  for (const CommandQueue& queue : queues_) queue.HashState(hasher);
}

}  // namespace openr_host
