// Schedules that write down where they leave the canonical order.
//
// What may be chosen, and why the robot could do the same, is in docs/exploring.md.
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

// Deviations where another process sees them, too.
struct DeviationLog {
  static constexpr uint64_t kMax = 1'000'000;
  uint64_t count;
  Deviation entries[kMax];
};

// What a schedule may change.
struct Vary {
  bool starts = true;   // the order of DoStart
  bool ties = true;     // who is first of several objects with a message due
  bool delays = true;   // objects that are slow to hear
  bool network = true;  // what comes from the network comes later
  bool costs = true;    // the jitter of a cost file
  bool frames = true;   // the number of the robot's first frame
};

// Finds out what is being asked, keeps every object's messages in order, and writes down the
// answers that are not the canonical one.
class ExploreSchedule : public Schedule {
 public:
  explicit ExploreSchedule(const System& system);

  size_t Choose(Question question, const std::vector<ObjectId>& candidates) final;
  int64_t ExtraDelayUs(const Message& message, int64_t now_us, int64_t delay_us) final;

  // What a call of a handler takes more, or less: within range_us to both sides.
  int64_t CostJitterUs(const Object& object, uint32_t selector, int64_t range_us);

  // The number of the first frame of `robot`, in a run of so many frames.
  int64_t FirstFrame(int robot, int64_t frames);

  const std::vector<Deviation>& deviations() const { return deviations_; }
  // Writes to `log` as well; null: nowhere else.
  void set_log(DeviationLog* log) { log_ = log; }

 protected:
  // `spot` has everything but the answer.
  virtual size_t PickOf(const Deviation& spot, const std::vector<ObjectId>& candidates) = 0;
  virtual int64_t PickDelayUs(const Deviation& spot, bool from_network) = 0;
  virtual int64_t PickCostUs(const Deviation& spot, int64_t range_us) = 0;
  virtual int64_t PickFrame(const Deviation& spot, int64_t frames) = 0;
  // Every message that is posted.
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
  uint64_t tie_count_ = 0;                                              // at tie_time_us_
  std::map<std::tuple<ObjectId, ObjectId, uint32_t>, Stream> streams_;  // sender, target, selector
  std::map<std::pair<ObjectId, uint32_t>, uint64_t> calls_;
  std::vector<int64_t> last_due_us_;  // by receiver, of messages that did not come from outside
  std::vector<int8_t> is_network_;    // by object; -1: not looked at
  std::vector<Deviation> deviations_;
  DeviationLog* log_ = nullptr;
};

// Draws from a seed.  Seeds differ in temper too: some disturb a little, some all the time, some
// make one object slow.  Seed 1 is the canonical order.
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

  Rng order_, delay_, cost_, frame_;  // of their own, so that switching one off leaves the others
  double start_rate_ = 0, tie_rate_ = 0, delay_rate_ = 0, network_rate_ = 0, cost_rate_ = 0,
         frame_rate_ = 0;
  int64_t delay_max_us_ = 1;
  ObjectId slow_ = kNoObject;  // who is delayed often
};

// Plays deviations again; those whose spot does not come are left out.
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
