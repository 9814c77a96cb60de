#include "openr/pair/remote_pair.h"

#include <fmt/format.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <utility>

#include "MoverState.h"
#include "openr/remote/error.h"
#include "runtime/base/wall_clock.h"

namespace openr_host {
namespace {

constexpr int kTellMs = 200;           // time between two reports of the status
constexpr int64_t kRoundTripMs = 500;  // time between two measurements of the round trip
// The largest number of requests that one robot has not answered yet.  While a robot has so many,
// no positions are sent to it, because newer positions follow.
constexpr size_t kPendingMax = 16;
// The time of silence after which a robot gets no more positions, because it would carry out old
// positions when it goes on.
constexpr int64_t kSilentMs = 500;
// Number of round trips to a robot (request and answer) whose times are kept; the shortest counts
// as the time that the network needs.
constexpr size_t kTripsMax = 32;
// Largest number of events (reports of sensor values or of set values) that are taken from one
// robot before it is the other robot's turn.
constexpr int kEventsMax = 100;
// The smallest change of a joint's goal that is sent to the robot that follows, in 0.01 degree.
constexpr int32_t kChangeMin = 5;
// Number of frames after which the frame numbers of a robot begin again with 0.
constexpr uint32_t kFramesPerTurn = 0x0ffffff1;
// The smallest and the largest number of frames in which the command TRACK moves a joint to its
// goal.
constexpr uint32_t kTrackFramesMin = RC_FRAMES_PER_VECTOR, kTrackFramesMax = 40;
// The largest step of a joint in one frame with the command TRACK, in 0.01 degree.
constexpr uint32_t kTrackStepMax = 400;

PairSide OtherOf(PairSide side) { return side == kFirst ? kSecond : kFirst; }

// Returns a remote-control request that sets a value of the joint `index`; `command` says which
// value.
remote::Call JointCall(int command, size_t index, int32_t value) {
  uint8_t bytes[8];
  RcWriter writer(bytes, sizeof bytes);
  writer.U8(static_cast<Uint32>(index));
  writer.S32(value);
  return {command, {bytes, bytes + writer.Size()}};
}

remote::Call TrackCall(size_t index, int32_t value, uint32_t frames) {
  remote::Call call = JointCall(rcTRACK, index, value);
  call.payload.push_back(static_cast<uint8_t>(frames));
  return call;
}

RcInfo InfoOf(remote::Connection* robot) {
  try {
    return robot->Read<RcInfo>(robot->Request(rcINFO, {}, RC_VERSION_FILES));
  } catch (const remote::Error& error) {
    if (error.status() != rcerrorVERSION) throw;
    throw std::runtime_error(fmt::format(
        "{}: serves version 1 of the remote control only; version 2 is needed to follow a robot",
        robot->address().Text()));
  }
}

}  // namespace

PairControl::PairControl() : descriptor_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {}

PairControl::~PairControl() { close(descriptor_); }

void PairControl::SetSettings(const PairSettings& settings) {
  const std::lock_guard lock(mutex_);
  settings_ = settings;
  eventfd_write(descriptor_, 1);
}

void PairControl::End() {
  const std::lock_guard lock(mutex_);
  is_ended_ = true;
  eventfd_write(descriptor_, 1);
}

PairSettings PairControl::settings() const {
  const std::lock_guard lock(mutex_);
  return settings_;
}

bool PairControl::is_ended() const {
  const std::lock_guard lock(mutex_);
  return is_ended_;
}

void PairControl::ClearDescriptor() const {
  eventfd_t count = 0;
  eventfd_read(descriptor_, &count);
}

RemotePair::RemotePair(const remote::Address& first, const remote::Address& second,
                       const PairOptions& options)
    : options_(options) {
  const remote::Address* const addresses[] = {&first, &second};
  for (const PairSide side : {kFirst, kSecond}) {
    sides_[side].address = addresses[side]->Text();
    sides_[side].robot = std::make_unique<remote::Connection>(*addresses[side], options.connection);
    sides_[side].info = InfoOf(sides_[side].robot.get());
    sides_[side].tracks = options.tracks[side];
  }
  CheckJoints(first, second);
}

RemotePair::~RemotePair() = default;

// Reads the descriptions of both robots.  Throws std::runtime_error if their joints differ.
void RemotePair::CheckJoints(const remote::Address& first, const remote::Address& second) {
  const RcInfo &a = info(kFirst), &b = info(kSecond);
  if (a.design != b.design || a.numJoints != b.numJoints) {
    throw std::runtime_error(
        fmt::format("{} is an {} with {} joints, {} an {} with {}: only robots of one model can be "
                    "controlled together",
                    first.Text(), a.design, a.numJoints, second.Text(), b.design, b.numJoints));
  }
  joints_ = sides_[kFirst].robot->Devices(rcdeviceJOINT);
  const auto& others = sides_[kSecond].robot->Devices(rcdeviceJOINT);
  for (size_t i = 0; i < joints_.size(); ++i) {
    if (i < others.size() && joints_[i].locator == others[i].locator) continue;
    throw std::runtime_error(
        fmt::format("joint {} is {} at {}, but {} at {}", i, joints_[i].locator, first.Text(),
                    i < others.size() ? others[i].locator : "missing", second.Text()));
  }
}

// Sends any number of requests to one robot, in batches, and returns the answers.  Throws
// std::runtime_error for the first request that the robot refuses.
std::vector<remote::Answer> RemotePair::SetAll(PairSide side,
                                               const std::vector<remote::Call>& calls) {
  std::vector<remote::Answer> all;
  for (size_t at = 0; at < calls.size(); at += RC_MAX_BATCH) {
    const size_t end = std::min(calls.size(), at + RC_MAX_BATCH);
    for (remote::Answer& answer : sides_[side].robot->Batch(
             {calls.begin() + static_cast<long>(at), calls.begin() + static_cast<long>(end)})) {
      if (answer.status != rcOK)
        throw std::runtime_error(fmt::format("{}: {}", sides_[side].address, answer.error));
      all.push_back(std::move(answer));
    }
  }
  return all;
}

std::vector<RcJointState> RemotePair::CopyLimits() {
  std::vector<remote::Call> gets, sets;
  for (size_t i = 0; i < joints_.size(); ++i) gets.push_back({rcGET, {static_cast<uint8_t>(i)}});
  std::vector<RcJointState> states;
  for (const remote::Answer& answer : SetAll(kSecond, gets))
    states.push_back(sides_[kSecond].robot->Read<RcJointState>(answer));
  for (size_t i = 0; i < states.size(); ++i) {
    sets.push_back(JointCall(rcSPEED, i, states[i].speed));
    sets.push_back(JointCall(rcACCEL, i, states[i].acceleration));
  }
  SetAll(kFirst, sets);
  return states;
}

void RemotePair::ResetLights() {
  for (const PairSide side : {kFirst, kSecond}) {
    std::vector<remote::Call> calls;
    for (uint8_t i = 0; i < info(side).numLeds; ++i) calls.push_back({rcLED, {i, 0}});
    for (uint8_t i = 0; i < info(side).numEars; ++i) calls.push_back({rcEAR, {i, 0}});
    SetAll(side, calls);
  }
}

void RemotePair::Run(PairControl* control, const std::function<void(const PairStatus&)>& tell) {
  now_ms_ = WallClockMs();
  for (Side& side : sides_) {
    const int period = options_.period;
    const remote::RequestId sensors = side.robot->Send(
        rcSUBSCRIBE,
        {rcstreamSENSORS, static_cast<uint8_t>(period & 255), static_cast<uint8_t>(period >> 8)});
    side.robot->Drop(sensors);
    side.robot->Drop(side.robot->Send(rcSUBSCRIBE, {rcstreamSET_VALUES, 0, 0}));
    side.heard_ms = now_ms_;
  }
  int64_t next_ms = now_ms_;
  while (!control->is_ended()) {
    ApplySettings(control->settings());
    for (const PairSide side : {kFirst, kSecond}) {
      Serve(side);
      MeasureRoundTrip(side);
      CheckAlive(side);
    }
    if (now_ms_ >= next_ms) {
      const bool follows_motion = settings_.follows_motions && status_.key_frame >= 0;
      status_.lag_ms =
          settings_.follow != Follow::kNone || follows_motion ? lag_.LagMs() : std::nullopt;
      tell(status_);
      next_ms = now_ms_ + kTellMs;
    }
    Wait(*control);
  }
}

// Waits until one of the two robots has sent something, or until a person has changed the settings
// or ended the pair; at most kTellMs / 2.
void RemotePair::Wait(const PairControl& control) {
  pollfd waited[] = {{sides_[kFirst].robot->descriptor(), POLLIN, 0},
                     {sides_[kSecond].robot->descriptor(), POLLIN, 0},
                     {control.descriptor(), POLLIN, 0}};
  poll(waited, 3, kTellMs / 2);
  control.ClearDescriptor();
  now_ms_ = WallClockMs();
}

void RemotePair::ApplySettings(const PairSettings& settings) {
  const bool is_other = settings.follow != settings_.follow;
  settings_ = settings;
  if (!is_other) return;
  status_.follow = settings.follow;
  lag_.Clear();
  for (const PairSide side : {kFirst, kSecond}) {
    sides_[side].sent.clear();
    status_.refusal[side].clear();
  }
}

void RemotePair::Serve(PairSide side) {
  // Limits the number of events, because a robot that sends all the time must not keep the other
  // robot waiting.
  for (int i = 0; i < kEventsMax; ++i) {
    const std::optional<remote::Event> event = sides_[side].robot->NextEvent({});
    HandleAnswers(side);
    if (!event) return;
    sides_[side].heard_ms = now_ms_;
    HandleEvent(side, *event);
  }
}

void RemotePair::HandleEvent(PairSide side, const remote::Event& event) {
  if (event.stream == rcstreamSENSORS) {
    HandleSensors(side, event);
  } else if (side == kSecond) {
    HandleSetValues(event);
  }
}

// Handles all answers that have arrived from the robot `side`.
void RemotePair::HandleAnswers(PairSide side) {
  auto& pending = sides_[side].pending;
  for (auto next = pending.begin(); next != pending.end();) {
    const auto here = next++;
    const std::optional<remote::Answer> answer = sides_[side].robot->TakeAnswer(here->first);
    if (!answer) continue;
    const PendingRequest request = here->second;
    pending.erase(here);
    HandleAnswer(side, *answer, request);
  }
}

void RemotePair::HandleAnswer(PairSide side, const remote::Answer& answer,
                              const PendingRequest& pending) {
  Side& own = sides_[side];
  own.heard_ms = now_ms_;
  status_.round_trip_ms[side] = static_cast<double>(now_ms_ - pending.time_ms);
  own.trips_ms.push_back(now_ms_ - pending.time_ms);
  if (own.trips_ms.size() > kTripsMax) own.trips_ms.pop_front();
  if (pending.calls == 0) return;
  status_.refusal[side] = answer.error;
  if (answer.status != rcOK) return;
  for (const remote::Answer& each : own.robot->ReadBatch(answer, pending.calls)) {
    if (each.status == rcOK) continue;
    status_.refusal[side] = each.error;
    // Uses the command MOVE instead of TRACK from now on, because this robot has an earlier
    // version, which does not know TRACK.
    if (each.status == rcerrorUNKNOWN_COMMAND) own.tracks = false;
    own.sent.clear();  // forgets the goals that were sent, so that all positions are sent again
    return;
  }
}

// Returns the time at which the robot sent a packet that has just arrived.  Takes half of the
// shortest round trip as the travel time of the packet, because longer round trips include waiting.
int64_t RemotePair::SentMs(PairSide side) const {
  const std::deque<int64_t>& trips = sides_[side].trips_ms;
  return trips.empty() ? now_ms_ : now_ms_ - *std::min_element(trips.begin(), trips.end()) / 2;
}

void RemotePair::HandleSensors(PairSide side, const remote::Event& event) {
  const auto values = sides_[side].robot->Read<RcSensors>(event);
  sides_[side].state = values.state;
  status_.state[side] = MoverStateName(values.state);
  status_.joints[side] = values.joints;
  const bool plays = status_.key_frame >= 0;
  const bool second_leads = settings_.follow == Follow::kFirst || plays;
  if (side == (second_leads ? kSecond : kFirst)) {
    lag_.AddLeader(SentMs(side), values.joints);
  } else {
    lag_.AddFollower(SentMs(side), values.joints);
  }
  if (settings_.follow == Follow::kSecond && side == kFirst) Lead(side, event.frame, values.joints);
  // Makes the first robot follow the measured positions of the second robot while the second robot
  // goes to the first key frame of a motion, because the second robot reports no key frames yet.
  if (side == kSecond && values.state == moverPREPARE_MTN && settings_.follows_motions &&
      settings_.follow == Follow::kNone)
    Lead(side, event.frame, values.joints);
  // Does not make the first robot follow measured positions while a motion plays, because it then
  // follows the key frames of the motion.
  if (settings_.follow == Follow::kFirst && side == kSecond &&
      !(plays && settings_.follows_motions))
    Lead(side, event.frame, values.joints);
}

// Handles an event with the values that the second robot's object JointMover has set.  If a motion
// plays and the first robot is to follow motions, sends the joint positions in this event to the
// first robot.
void RemotePair::HandleSetValues(const remote::Event& event) {
  const auto values = sides_[kSecond].robot->Read<RcSetValues>(event);
  const bool plays = values.keyFrame >= 0;
  if (plays != (status_.key_frame >= 0)) {
    lag_.Clear();
    sides_[kFirst].sent.clear();
  }
  status_.key_frame = values.keyFrame;
  status_.motion = plays ? values.file : "";
  if (!plays || !settings_.follows_motions) return;
  if (Lead(kSecond, event.frame, values.commanded)) ++status_.key_frames;
}

// Sends goals (joint positions) to the robot that follows.  The leader, the other robot, had these
// goals in its frame `frame`.  Returns false if nothing is sent: the follower does not accept
// commands, is silent, or has reached the goals.
bool RemotePair::Lead(PairSide leader, uint32_t frame, const std::vector<int32_t>& goals) {
  Side& follower = sides_[OtherOf(leader)];
  if (follower.state != moverACCEPTING_COMMANDS || goals.size() != joints_.size()) return false;
  if (now_ms_ - follower.heard_ms > kSilentMs || follower.pending.size() >= kPendingMax)
    return false;
  const bool is_first = follower.sent.empty();
  const uint32_t passed = (frame + kFramesPerTurn - follower.goal_frame) % kFramesPerTurn;
  const std::vector<int32_t>& measured = status_.joints[OtherOf(leader)];
  std::vector<remote::Call> calls;
  for (size_t i = 0; i < goals.size() && calls.size() < RC_MAX_BATCH; ++i) {
    if (!is_first && std::abs(int64_t{goals[i]} - follower.sent[i]) < kChangeMin) continue;
    const auto way =
        static_cast<uint32_t>(i < measured.size() ? std::abs(int64_t{goals[i]} - measured[i]) : 0);
    // Gives the joint one frame more than the number of frames since the last goal, so that the
    // joint does not stop before the next goal comes.
    const uint32_t frames =
        std::clamp(std::max(is_first ? kTrackFramesMax : passed + 1, way / kTrackStepMax),
                   kTrackFramesMin, kTrackFramesMax);
    calls.push_back(follower.tracks ? TrackCall(i, goals[i], frames)
                                    : JointCall(rcMOVE, i, goals[i]));
    if (!is_first) follower.sent[i] = goals[i];
  }
  if (is_first) follower.sent = goals;
  follower.goal_frame = frame;
  if (calls.empty()) return false;
  follower.pending[follower.robot->SendBatch(calls)] = {now_ms_, calls.size()};
  return true;
}

// Asks a robot for its state from time to time.  The time until its answer comes is the round trip.
void RemotePair::MeasureRoundTrip(PairSide side) {
  Side& own = sides_[side];
  if (!own.pending.empty() || now_ms_ - own.asked_ms < kRoundTripMs) return;
  if (now_ms_ - own.heard_ms > kSilentMs) return;
  own.asked_ms = now_ms_;
  own.pending[own.robot->Send(rcINFO)] = {now_ms_, 0};
}

// Throws remote::Error if the robot `side` is silent for too long.
void RemotePair::CheckAlive(PairSide side) const {
  if (side == kFirst && options_.first_may_pause) return;
  const auto timeout_ms = options_.connection.timeout.count();
  if (now_ms_ - sides_[side].heard_ms <= timeout_ms) return;
  throw remote::Error(remote::ErrorCode::kTimeout,
                      fmt::format("{}: silent for {} ms", sides_[side].address, timeout_ms));
}

}  // namespace openr_host
