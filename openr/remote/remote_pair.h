// RemotePair: two robots that are controlled together.  One can follow the other.
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

#include "openr/remote/lag_meter.h"
#include "openr/remote/remote_client.h"

namespace openr_host {

// The two robots of a pair.  In the panel the first one is simulated, the second one is any other.
enum PairSide { kFirst = 0, kSecond = 1 };

enum class Follow { kNone, kFirst, kSecond };  // which robot follows the other one

struct PairOptions {
  int timeout_ms = 3000;
  int period = RC_FRAMES_PER_VECTOR;  // frames between two sensor values
  // Whether a robot that follows goes straight to each position (TRACK), instead of within its
  // limits of speed and acceleration (MOVE).
  bool tracks[2] = {true, false};
  // Whether the first robot may be silent, because people pause a simulation.
  bool first_may_pause = false;
};

// What a person wants of a pair; may change at any time.
struct PairWish {
  Follow follow = Follow::kNone;
  bool follows_motions = true;  // the first robot follows key frames of motions of the second one
};

struct PairStatus {
  Follow follow = Follow::kNone;
  std::optional<double> round_trip_ms[2];  // of a request and its answer, of each robot
  std::optional<int64_t> lag_ms;           // see LagMeter; none while nothing moves
  std::string state[2];                    // of JointMover; "": not known
  std::vector<int32_t> joints[2];          // measured, in 0.01 degree
  std::string motion;                      // file of the motion that the second robot plays
  int key_frame = -1;
  uint64_t key_frames = 0;  // key frames that the first robot has been sent
  std::string refusal[2];   // why a robot has refused the last positions; "": it has not
};

// A wish that several threads share, and the end of the pair.
class PairControl {
 public:
  PairControl();
  ~PairControl();
  PairControl(const PairControl&) = delete;
  PairControl& operator=(const PairControl&) = delete;

  void Wish(const PairWish& wish);
  void End();

  PairWish wish() const;
  bool is_ended() const;
  // Returns a descriptor that can be read after a change, until Heard() is called.
  int descriptor() const { return descriptor_; }
  void Heard() const;

 private:
  const int descriptor_;
  mutable std::mutex mutex_;
  PairWish wish_;
  bool is_ended_ = false;
};

// A plain client of both robots, for one thread.  It waits for an answer only in its constructor
// and in the functions that prepare the pair; in Run() it serves both without waiting for either.
class RemotePair {
 public:
  // Connects to both robots.  Throws std::runtime_error if one cannot be reached or they have
  // different joints, with the difference.
  RemotePair(const RemoteAddress& first, const RemoteAddress& second, const PairOptions& options);
  ~RemotePair();

  const std::vector<RcDescription>& joints() const { return joints_; }
  const RcInfo& info(PairSide side) const { return sides_[side].info; }

  // Gives the first robot the limits of speed and acceleration of the second one, and returns them.
  std::vector<RcJointState> CopyLimits();
  // Switches lights and ears of both robots off.
  void ResetLights();

  // Serves both robots until `control` is ended.  Tells the status several times a second.  Throws
  // RemoteFailure when a connection is lost; the text begins with the address.
  void Run(PairControl* control, const std::function<void(const PairStatus&)>& tell);

 private:
  struct Side {
    std::string address;
    std::unique_ptr<RemoteClient> client;
    RcInfo info;
    int64_t heard_ms = 0;                   // when the last packet has come
    int64_t asked_ms = 0;                   // when the last request for the round trip was sent
    std::map<uint16_t, int64_t> posted_ms;  // requests without an answer, by tag
    std::map<uint16_t, size_t> batches;     // number of requests of those that are batches
    std::deque<int64_t> trips_ms;           // the last round trips
    std::vector<int32_t> sent;              // goals that this robot was sent last; empty: none
    uint32_t goal_frame = 0;                // frame of the other robot that had these goals
    int state = -1;                         // MoverState; -1: not known
    bool tracks = false;
  };

  void CheckJoints(const RemoteAddress& first, const RemoteAddress& second);
  std::vector<RemoteReply> SetAll(PairSide side, const std::vector<RemoteCall>& calls);
  void Wait(const PairControl& control);
  void Serve(PairSide side);
  void TakeEvent(PairSide side, const RemoteEvent& event);
  void TakeReply(PairSide side, const RemotePacket& packet);
  int64_t SentMs(PairSide side) const;
  void TakeSensors(PairSide side, const RemoteEvent& event);
  void TakeSetValues(const RemoteEvent& event);
  void Lead(PairSide leader, uint32_t frame, const std::vector<int32_t>& goals);
  void MeasureRoundTrip(PairSide side);
  void CheckAlive(PairSide side) const;
  void SetWish(const PairWish& wish);

  const PairOptions options_;
  std::vector<RcDescription> joints_;
  Side sides_[2];
  PairWish wish_;
  PairStatus status_;
  LagMeter lag_;
  int64_t now_ms_ = 0;
};

}  // namespace openr_host
