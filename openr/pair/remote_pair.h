// RemotePair: two robots that a client controls together.  One robot can follow the other.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "openr/pair/lag_meter.h"
#include "openr/remote/connection.h"

namespace openr_host {

namespace remote = openr::remote;

// The two robots of a pair.  In the panel the first robot is a simulated one, the second robot is
// any other robot.
enum PairSide { kFirst = 0, kSecond = 1 };

// The robot of a pair that follows the other robot, or no robot.
enum class Follow { kNone, kFirst, kSecond };

struct PairOptions {
  remote::Options connection;         // options of the connections to both robots
  int period = RC_FRAMES_PER_VECTOR;  // number of frames between two sensor values
  // Whether a robot that follows goes straight to each position (TRACK) instead of within its
  // limits of speed and acceleration (MOVE).  The index is a PairSide.
  bool tracks[2] = {true, false};
  // Whether the first robot may be silent for a long time without an error.  A simulated robot may,
  // because people can pause a simulation.
  bool first_may_pause = false;
};

// The way in which a person wants two robots to move together.  The settings may change at any
// time.
struct PairSettings {
  Follow follow = Follow::kNone;
  // True: the first robot follows the key frames of the second robot's motions.
  bool follows_motions = true;
};

// The state of both robots, to be shown to a person.
struct PairStatus {
  Follow follow = Follow::kNone;
  std::optional<double> round_trip_ms[2];  // times from a request to its answer; index: PairSide
  // The time by which the joints of the robot that follows lag behind the joints of the other
  // robot, as LagMeter has measured it; nullopt if the lag cannot be measured, for instance because
  // nothing moves.
  std::optional<int64_t> lag_ms;
  std::string state[2];            // state of each robot's JointMover; "": not known
  std::vector<int32_t> joints[2];  // measured positions of each robot's joints, in 0.01 degree
  std::string motion;              // file of the motion that the second robot plays
  int key_frame = -1;
  uint64_t key_frames = 0;  // number of key frames that were sent to the first robot
  // Reason why a robot has refused the last positions; "": the robot has not refused them.
  std::string refusal[2];
};

// Passes the settings of a person, and the request to end the pair, from other threads to the
// thread that runs RemotePair::Run().
class PairControl {
 public:
  PairControl();
  ~PairControl();
  PairControl(const PairControl&) = delete;
  PairControl& operator=(const PairControl&) = delete;

  void SetSettings(const PairSettings& settings);
  void End();

  PairSettings settings() const;
  bool is_ended() const;
  // Returns a descriptor that becomes readable when SetSettings() or End() is called.
  // ClearDescriptor() resets it.
  int descriptor() const { return descriptor_; }
  void ClearDescriptor() const;

 private:
  const int descriptor_;
  mutable std::mutex mutex_;
  PairSettings settings_;
  bool is_ended_ = false;
};

// A client of the remote controls of both robots, to be used in one thread.  Waits for answers only
// in its constructor and in the functions that prepare the pair.  Run() serves both robots at once
// and does not wait for answers.
class RemotePair {
 public:
  // Connects to both robots.  Throws remote::Error if a robot cannot be reached.  Throws
  // std::runtime_error with the difference if the robots have different joints.
  RemotePair(const remote::Address& first, const remote::Address& second,
             const PairOptions& options);
  ~RemotePair();

  const std::vector<RcDescription>& joints() const { return joints_; }
  const RcInfo& info(PairSide side) const { return sides_[side].info; }

  // Gives the joints of the first robot the limits of speed and acceleration that the joints of the
  // second robot have.  Returns these limits.
  std::vector<RcJointState> CopyLimits();
  // Switches lights and ears of both robots off.
  void ResetLights();

  // Serves both robots until `control` ends the pair.  Calls `tell` with the status of the pair
  // several times a second.  Throws remote::Error when a connection is lost; the text of the error
  // begins with the address of the robot.
  void Run(PairControl* control, const std::function<void(const PairStatus&)>& tell);

 private:
  // A remote-control request that was sent to a robot and not answered yet.
  struct PendingRequest {
    int64_t time_ms = 0;
    size_t calls = 0;  // number of commands of a batch; 0: the request is no batch
  };

  struct Side {
    std::string address;
    std::unique_ptr<remote::Connection> robot;
    RcInfo info;
    int64_t heard_ms = 0;  // time of the last packet from this robot
    int64_t asked_ms = 0;  // time of the last request with which the round trip was measured
    std::map<remote::RequestId, PendingRequest> pending;  // requests without an answer yet
    std::deque<int64_t> trips_ms;                         // times of the last round trips, in ms
    // The goals (joint positions) that were sent last to this robot; empty: none.
    std::vector<int32_t> sent;
    uint32_t goal_frame = 0;  // frame in which the other robot had the goals in `sent`
    int state = -1;           // state of the robot's JointMover (MoverState); -1: not known
    bool tracks = false;
  };

  void CheckJoints(const remote::Address& first, const remote::Address& second);
  std::vector<remote::Answer> SetAll(PairSide side, const std::vector<remote::Call>& calls);
  void Wait(const PairControl& control);
  void Serve(PairSide side);
  void HandleEvent(PairSide side, const remote::Event& event);
  void HandleAnswers(PairSide side);
  void HandleAnswer(PairSide side, const remote::Answer& answer, const PendingRequest& pending);
  int64_t SentMs(PairSide side) const;
  void HandleSensors(PairSide side, const remote::Event& event);
  void HandleSetValues(const remote::Event& event);
  bool Lead(PairSide leader, uint32_t frame, const std::vector<int32_t>& goals);
  void MeasureRoundTrip(PairSide side);
  void CheckAlive(PairSide side) const;
  void ApplySettings(const PairSettings& settings);

  const PairOptions options_;
  std::vector<RcDescription> joints_;
  Side sides_[2];
  PairSettings settings_;
  PairStatus status_;
  LagMeter lag_;
  int64_t now_ms_ = 0;
};

}  // namespace openr_host
