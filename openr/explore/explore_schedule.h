// Schedules that write down where they leave the canonical order.
//
// docs/exploring.md says what may be chosen, and why the robot could do the same.
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

// A list of deviations in memory that another process can read.
struct DeviationLog {
  static constexpr uint64_t kMax = 1'000'000;
  uint64_t count;
  Deviation entries[kMax];
};

// The parts of a run that a schedule may change.
struct Vary {
  bool starts = true;   // the order of DoStart
  bool ties = true;     // which of several objects with a message due is first
  bool delays = true;   // objects hear messages late
  bool network = true;  // data from the network come late
  bool costs = true;    // the jitter of a cost file
  bool frames = true;   // the number of the robot's first frame
};

// Works out which choice is asked for, keeps every object's messages in order, and writes down
// answers that differ from the canonical one.
class ExploreSchedule : public Schedule {
 public:
  explicit ExploreSchedule(const System& system);

  size_t Choose(Question question, const std::vector<ObjectId>& candidates) final;
  int64_t ExtraDelayUs(const Message& message, int64_t now_us, int64_t delay_us) final;

  // Returns how much longer (or shorter, if negative) a call of a handler takes, at most range_us.
  int64_t CostJitterUs(const Object& object, uint32_t selector, int64_t range_us);

  // Returns the number of the first frame of `robot`, in a run of `frames` frames.
  int64_t FirstFrame(int robot, int64_t frames);

  const std::vector<Deviation>& deviations() const { return deviations_; }
  // Sets a log that deviations are written to as well; null means no log.
  void set_log(DeviationLog* log) { log_ = log; }

 protected:
  // Answers the question `spot`, which has all fields but the answer: returns the index of a
  // candidate.
  virtual size_t PickOf(const Deviation& spot, const std::vector<ObjectId>& candidates) = 0;
  virtual int64_t PickDelayUs(const Deviation& spot, bool from_network) = 0;
  virtual int64_t PickCostUs(const Deviation& spot, int64_t range_us) = 0;
  virtual int64_t PickFrame(const Deviation& spot, int64_t frames) = 0;
  // Notes a message.  Called for every message that is posted.
  virtual void SawPost(const Message&) {}

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
  uint64_t tie_count_ = 0;  // number of ties at tie_time_us_
  // By sender, target, selector.
  std::map<std::tuple<ObjectId, ObjectId, uint32_t>, Stream> streams_;
  std::map<std::pair<ObjectId, uint32_t>, uint64_t> calls_;
  std::vector<int64_t> last_due_us_;  // by receiver, for messages from inside the robot
  std::vector<int8_t> is_network_;    // by object; -1: not known yet
  std::vector<Deviation> deviations_;
  DeviationLog* log_ = nullptr;
};

// Draws the answers from a seed.  Seeds also differ in how much they disturb a run: some do so
// rarely, some all the time, and some make one object slow.  Seed 1 is the canonical order.
class RandomSchedule : public ExploreSchedule {
 public:
  RandomSchedule(const System& system, uint64_t seed, const Vary& vary);

 protected:
  size_t PickOf(const Deviation& spot, const std::vector<ObjectId>& candidates) override;
  int64_t PickDelayUs(const Deviation& spot, bool from_network) override;
  int64_t PickCostUs(const Deviation& spot, int64_t range_us) override;
  int64_t PickFrame(const Deviation& spot, int64_t frames) override;

 private:
  bool Happens(Rng* rng, double rate) { return rate > 0 && rng->NextDouble() < rate; }

  // The generators are separate, so that switching one part off does not change the others.
  Rng order_, delay_, cost_, frame_;
  double start_rate_ = 0, tie_rate_ = 0, delay_rate_ = 0, network_rate_ = 0, cost_rate_ = 0,
         frame_rate_ = 0;
  int64_t delay_max_us_ = 1;
  ObjectId slow_ = kNoObject;  // object that is often delayed
};

// Plays deviations again.  Ignores deviations whose place does not occur in the run.
class ScriptedSchedule : public ExploreSchedule {
 public:
  ScriptedSchedule(const System& system, const std::vector<Deviation>& script);

 protected:
  size_t PickOf(const Deviation& spot, const std::vector<ObjectId>& candidates) override;
  int64_t PickDelayUs(const Deviation& spot, bool from_network) override;
  int64_t PickCostUs(const Deviation& spot, int64_t range_us) override;
  int64_t PickFrame(const Deviation& spot, int64_t frames) override;

 private:
  using Spot = std::tuple<Deviation::Kind, int64_t, uint64_t, ObjectId, ObjectId, uint32_t>;
  static Spot SpotOf(const Deviation& deviation);
  const Deviation* Find(const Deviation& spot) const;

  std::map<Spot, Deviation> script_;
};

}  // namespace openr_host
