// Schedules for exploration.  A schedule chooses between the orders of messages that the robot
// allows.  It writes down each choice that leaves the canonical order, the order of a run without
// exploration.
//
// docs/exploring.md says what may be chosen, and why the real robot could do the same.
#pragma once

#include <cstdint>
#include <map>
#include <tuple>
#include <vector>

#include "openr/explore/deviation.h"
#include "runtime/base/rng.h"
#include "runtime/core/schedule.h"

namespace openr_host {

class Object;
class System;

// A list of deviations in memory that two processes share.  The process of a run writes the list,
// and its parent process can read it even if the run crashes.  The list has a fixed size, so
// deviations after the first kMax are left out.
struct DeviationLog {
  static constexpr uint64_t kMax = 1'000'000;
  uint64_t count;
  Deviation entries[kMax];
};

// The kinds of choices that a schedule may make.  For a kind that is false, the schedule makes the
// same choices as a run without exploration.
struct ScheduleChoices {
  bool starts = true;  // true: the schedule chooses the order in which objects get DoStart
  // True: the schedule chooses the order of objects that have messages due at the same time.
  bool ties = true;
  bool delays = true;   // true: the schedule delays messages to objects
  bool network = true;  // true: the schedule delays data from the network
  // True: the schedule chooses the jitter, the random part, of the handlers' processor times.
  bool costs = true;
  bool frames = true;  // true: the schedule chooses the number of the robot's first frame
  int faults = 0;      // number of faults that the robots of a run get
};

// Base class of the schedules for exploration.  For each choice it finds the place in the run and
// lets the derived class choose.  It writes down each choice that is not the canonical one (index
// 0, no delay).  When it delays a message, it keeps the order of the messages to each object.
class ExploreSchedule : public Schedule {
 public:
  explicit ExploreSchedule(const System& system);

  size_t Choose(Question question, const std::vector<ObjectId>& candidates) final;
  int64_t ExtraDelayUs(const Message& message, int64_t now_us, int64_t delay_us) final;

  // Returns the difference between the processor time of this call of a handler and the time in the
  // cost file.  The difference lies between -range_us and range_us.
  int64_t CostJitterUs(const Object& object, uint32_t selector, int64_t range_us);

  // Returns the number of the first frame (8 ms) of `robot` in a run of `frames` frames.  Without
  // exploration the number is 0.  A number near the largest frame number makes the frame counter
  // begin again at 0 during the run; on a real robot this happens only after 24.8 days.
  int64_t FirstFrame(int robot, int64_t frames);

  // Returns the faults that `robots` robots get in a run of the length `for_us`, in order of time.
  std::vector<Deviation> Faults(int robots, int64_t for_us);

  const std::vector<Deviation>& deviations() const { return deviations_; }
  // Sets a log that gets a copy of each deviation, so that another process can read the deviations
  // after a crash of this process.  Null means that there is no log.
  void set_log(DeviationLog* log) { log_ = log; }

 protected:
  // Each function with the argument `spot` makes one choice.  `spot` says where in the run the
  // choice is; its field for the result is not set yet (`object` for PickOf(), `us` for the
  // others).  PickOf() returns the index of the chosen candidate, PickFrame() the number of the
  // first frame, the others a time that is added.  The result 0 is always the choice of a run
  // without exploration.
  virtual size_t PickOf(const Deviation& spot, const std::vector<ObjectId>& candidates) = 0;
  virtual int64_t PickDelayUs(const Deviation& spot, bool from_network) = 0;
  virtual int64_t PickCostUs(const Deviation& spot, int64_t range_us) = 0;
  virtual int64_t PickFrame(const Deviation& spot, int64_t frames) = 0;
  virtual std::vector<Deviation> PickFaults(int /*robots*/, int64_t /*for_us*/) { return {}; }
  // Called for every message when it is posted, that is, sent.  Derived classes override it if
  // their choices depend on the senders and receivers of messages.
  virtual void OnPost(const Message&) {}

  const System& system() const { return system_; }

 private:
  struct Stream {
    uint64_t count = 0;
    int64_t last_due_us = 0;
  };
  int64_t PickedDelayUs(const Message& message, Stream* stream, bool from_network);
  bool IsNetwork(ObjectId id);
  void Record(Deviation deviation, int64_t us);

  const System& system_;
  uint64_t start_count_ = 0;
  int64_t tie_time_us_ = -1;
  // Number of ties at the time tie_time_us_ so far.  A tie is a moment when several objects have a
  // message due.
  uint64_t tie_count_ = 0;
  // Counts the messages from each sender to each handler of each receiver, because deviations name
  // a message by its number.  The key is sender, receiver and selector (number of the handler).
  // For messages from the network, the value also has the time when the last message reaches the
  // receiver, because the next message must not overtake it.
  std::map<std::tuple<ObjectId, ObjectId, uint32_t>, Stream> streams_;
  // Counts the calls of CostJitterUs() for each handler; the key is the object and the selector of
  // the handler.
  std::map<std::pair<ObjectId, uint32_t>, uint64_t> calls_;
  // For each receiver, by its id: the time at which the last message to this receiver arrives.
  // Messages from the network do not count.
  std::vector<int64_t> last_due_us_;
  // For each object: 1 if the object is the IPStack, whose messages are delayed as data from the
  // network, else 0; -1: not known yet.
  std::vector<int8_t> is_network_;
  std::vector<Deviation> deviations_;
  DeviationLog* log_ = nullptr;
};

// Draws the choices from the random generators of a seed.  The seed also decides how much the run
// is disturbed: for each kind of choice, how often it leaves the canonical order, and whether the
// messages to one object are often delayed.  Seed 1 gives the canonical order, as without
// exploration.
class RandomSchedule : public ExploreSchedule {
 public:
  RandomSchedule(const System& system, uint64_t seed, const ScheduleChoices& vary);

 protected:
  size_t PickOf(const Deviation& spot, const std::vector<ObjectId>& candidates) override;
  int64_t PickDelayUs(const Deviation& spot, bool from_network) override;
  int64_t PickCostUs(const Deviation& spot, int64_t range_us) override;
  int64_t PickFrame(const Deviation& spot, int64_t frames) override;
  std::vector<Deviation> PickFaults(int robots, int64_t for_us) override;

 private:
  bool Happens(Rng* rng, double rate) { return rate > 0 && rng->NextDouble() < rate; }

  // Random generators, one for each kind of choice.  So the choices of one kind do not depend on
  // how many choices of another kind were drawn before.
  Rng order_, delay_, cost_, frame_, fault_;
  double start_rate_ = 0, tie_rate_ = 0, delay_rate_ = 0, network_rate_ = 0, cost_rate_ = 0,
         frame_rate_ = 0;
  int64_t delay_max_us_ = 1;
  int fault_count_ = 0;
  ObjectId slow_ = kNoObject;  // object whose messages are often delayed
};

// Repeats the deviations of a list, and makes the canonical choice everywhere else.  Ignores a
// deviation whose place does not occur in the run.  This happens if some deviations of a run were
// left out of the list, because the run may then not come to the places of the other deviations.
class ScriptedSchedule : public ExploreSchedule {
 public:
  ScriptedSchedule(const System& system, const std::vector<Deviation>& script);

 protected:
  size_t PickOf(const Deviation& spot, const std::vector<ObjectId>& candidates) override;
  int64_t PickDelayUs(const Deviation& spot, bool from_network) override;
  int64_t PickCostUs(const Deviation& spot, int64_t range_us) override;
  int64_t PickFrame(const Deviation& spot, int64_t frames) override;
  std::vector<Deviation> PickFaults(int robots, int64_t for_us) override;

 private:
  using Spot = std::tuple<Deviation::Kind, int64_t, uint64_t, ObjectId, ObjectId, uint32_t>;
  static Spot SpotOf(const Deviation& deviation);
  const Deviation* Find(const Deviation& spot) const;

  std::map<Spot, Deviation> script_;
};

}  // namespace openr_host
