// Random schedules stay within what the robot allows, and scripts repeat them.
#include "openr/explore/explore_schedule.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "tests/planted/planted.h"
#include "tests/runtime/core/recorder.h"

namespace openr_host {
namespace {

// Sends numbered messages to each of the others at odd times.
class Talker : public Actor {
 public:
  Talker(std::vector<Recorder*> targets, int count) : targets_(std::move(targets)), left_(count) {
    next_ = AddExtra("Next", [this](void*) {
      for (Recorder* target : targets_) PostTo(target, left_);
      if (--left_ > 0) Post(host().id, next_, 1'000 * (1 + left_ % 3));
    });
  }
  OStatus DoStart(const OSystemEvent&) override {
    Post(host().id, next_, 10'000);
    return oSUCCESS;
  }

 private:
  const std::vector<Recorder*> targets_;
  int left_;
  Selector next_;
};

struct Talk {
  explicit Talk(uint64_t seed, const ScheduleChoices& vary = {}) {
    Build();
    Run(std::make_unique<RandomSchedule>(system, seed, vary));
  }
  explicit Talk(const std::vector<Deviation>& script) {
    Build();
    Run(std::make_unique<ScriptedSchedule>(system, script));
  }

  void Build() {
    system.AddRobot("ERS-210", nullptr);
    std::vector<Recorder*> targets;
    for (const char* name : {"a", "b", "c"}) {
      targets.push_back(system.AddObject<Recorder>(0, name, &log));
    }
    system.AddObject<Talker>(0, "x", targets, 100);
    system.AddObject<Talker>(0, "y", targets, 100);
  }
  void Run(std::unique_ptr<ExploreSchedule> schedule) {
    system.set_schedule(schedule.get());
    system.trace().AddSink([this](const TraceRecord& record, const Message&) {
      numbers[record.target].push_back(record.number);
    });
    system.Boot();
    system.RunFor(2'000'000);
    deviations = schedule->deviations();
  }

  Log log;
  System system;
  std::map<ObjectId, std::vector<uint64_t>> numbers;  // as delivered, by receiver
  std::vector<Deviation> deviations;
};

TEST(ExploreScheduleTest, SeedOneIsTheCanonicalOrder) {
  const Talk talk(1);
  EXPECT_TRUE(talk.deviations.empty());
}

TEST(ExploreScheduleTest, EveryObjectHearsInTheOrderOfSending) {
  for (uint64_t seed = 2; seed < 30; ++seed) {
    const Talk talk(seed);
    for (const auto& [target, numbers] : talk.numbers) {
      if (talk.system.object(target)->is_system()) continue;
      // Answers and what comes by an object's own clock have numbers of their own time.
      if (talk.system.object(target)->name > "c") continue;
      EXPECT_TRUE(std::is_sorted(numbers.begin(), numbers.end())) << "seed " << seed;
    }
  }
}

TEST(ExploreScheduleTest, SeedsDifferAndRepeat) {
  std::set<Log> logs;
  for (uint64_t seed = 1; seed < 12; ++seed) {
    const Talk talk(seed);
    logs.insert(talk.log);
    EXPECT_EQ(Talk(seed).log, talk.log) << seed;
  }
  EXPECT_GT(logs.size(), 8u);
}

TEST(ExploreScheduleTest, AScriptRepeatsARandomRun) {
  for (uint64_t seed = 2; seed < 12; ++seed) {
    Talk random(seed);
    Talk scripted(random.deviations);
    EXPECT_EQ(scripted.log, random.log) << seed;
    EXPECT_EQ(scripted.deviations, random.deviations) << seed;
    EXPECT_EQ(scripted.system.trace_hash(), random.system.trace_hash()) << seed;
  }
}

TEST(ExploreScheduleTest, WhatIsSwitchedOffStaysCanonical) {
  ScheduleChoices vary{.starts = false, .ties = false, .delays = false};
  std::set<Deviation::Kind> kinds;
  const auto look = [&] {
    kinds.clear();
    for (uint64_t seed = 2; seed < 12; ++seed) {
      for (const Deviation& deviation : Talk(seed, vary).deviations) kinds.insert(deviation.kind);
    }
  };
  look();
  EXPECT_TRUE(kinds.empty());
  vary.ties = true;
  look();
  EXPECT_EQ(kinds, std::set<Deviation::Kind>{Deviation::Kind::kTie});
  vary = {.starts = false, .ties = false};
  look();
  EXPECT_EQ(kinds, std::set<Deviation::Kind>{Deviation::Kind::kDelay});
}

TEST(ExploreScheduleTest, DeviationsSurviveJson) {
  const Talk talk(3);
  for (const Deviation& deviation : talk.deviations) {
    const Json json = DeviationToJson(deviation, talk.system);
    EXPECT_EQ(DeviationFromJson(json, talk.system), deviation) << json;
  }
  EXPECT_FALSE(talk.deviations.empty());
}

TEST(ExploreScheduleTest, AFaultOfNoRobotOrBeforeTheRunIsRefused) {
  const Talk talk(1);
  const Json fault = {{"kind", "fault"}, {"time_us", 8000}, {"nth", 0}, {"robot", 0}, {"us", 57}};
  EXPECT_EQ(DeviationFromJson(fault, talk.system).us, 57);
  const std::pair<const char*, int64_t> wrongs[] = {
      {"robot", -1}, {"robot", talk.system.robot_count()}, {"time_us", -8000}};
  for (const auto& [field, value] : wrongs) {
    Json wrong = fault;
    wrong[field] = value;
    EXPECT_THROW(DeviationFromJson(wrong, talk.system), std::runtime_error) << wrong;
  }
}

TEST(ExploreScheduleTest, AScheduleOfAnotherGraphIsRefused) {
  const Talk talk(1);
  const Json json = {{"kind", "tie"}, {"time_us", 8}, {"nth", 0}, {"robot", 0}, {"object", "z"}};
  EXPECT_THROW(DeviationFromJson(json, talk.system), std::runtime_error);
}

}  // namespace
}  // namespace openr_host
