// Exploring the default stick: nothing breaks, every seed repeats itself, the number of processes
// does not show.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <set>

#include "openr/explore/explore_cost.h"
#include "openr/explore/failing_run.h"
#include "tests/planted/planted.h"

namespace openr_host {
namespace {

ExplorePlan StickPlan(const std::string& body = "ideal", bool guard = false,
                      const std::string& cost = "") {
  SimulationOptions options;
  options.stick = OPENR_STICK;
  options.body = body;
  options.guard_regions = guard;
  options.cost_file = cost;
  options.console = [](std::string_view) {};
  ExplorePlan plan;
  plan.prepare_run = [options] { return PrepareSimulation(options); };
  plan.runs = 20;
  return plan;
}

TEST(ExplorerTest, TwentySeedsOfTheDefaultStickRepeatThemselvesAndBreakNothing) {
  ExplorePlan plan = StickPlan();
  plan.run.properties.names = {"default", "standing"};
  const Json result = VerifySeeds(plan);
  EXPECT_EQ(result["runs"], 20);
  EXPECT_EQ(result["differences"], 0) << result["different_seeds"];
  EXPECT_EQ(result["broken"], 0) << result.value("failure", Json()).dump(1);
}

TEST(ExplorerTest, SeedsOnThePhysicalBodyRepeatThemselves) {
  ExplorePlan plan = StickPlan("ode");
  plan.runs = 2;
  plan.first_seed = 2;
  EXPECT_EQ(VerifySeeds(plan)["differences"], 0);
}

// The second run of a seed ends when the first run has broken a property, but its first frame and
// its faults are those of the first run.
TEST(ExplorerTest, SeedsThatBreakAPropertyEarlyRepeatThemselves) {
  ExplorePlan plan = StickPlan();
  plan.run.for_us = 2'000'000;
  plan.run.vary.faults = 3;
  plan.run.properties.names = {"always messages < 300"};
  plan.stop_at_first = false;
  plan.shorten_runs = 0;
  const Json result = VerifySeeds(plan);
  EXPECT_EQ(result["broken"], 20);
  EXPECT_EQ(result["differences"], 0) << result["different_seeds"];
}

TEST(ExplorerTest, OneProcessAndTwoComeToTheSame) {
  ExplorePlan plan = StickPlan();
  const Json one = ExploreSeeds(plan);
  plan.jobs = 2;
  EXPECT_EQ(ExploreSeeds(plan), one);
}

// The hash of a run in a copy of an explorer process is that of a run in this process, in one
// piece.
TEST(ExplorerTest, ACopiedProcessComesToTheSameAsAPlainRun) {
  const ExplorePlan plan = StickPlan();
  ExplorerProcesses pool(plan.prepare_run, plan.run, plan.limits, 1);
  const Json copied = pool.RunOne({{"seed", 1}});
  const PreparedRun prepared = plan.prepare_run();
  prepared.system->Boot();
  prepared.system->RunUntil(plan.run.for_us);
  EXPECT_EQ(copied["trace"], fmt::format("{:016x}", prepared.system->trace_hash()));
  EXPECT_EQ(copied["state"], fmt::format("{:016x}", prepared.system->state_hash()));
}

TEST(ExplorerTest, SeedsGiveOrdersOfTheirOwn) {
  ExplorePlan plan = StickPlan();
  plan.run.for_us = 1'000'000;
  plan.run.vary = {.delays = false, .network = false, .frames = false};
  ExplorerProcesses pool(plan.prepare_run, plan.run, plan.limits, 1);
  std::set<std::string> traces;
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    traces.insert(pool.RunOne({{"seed", seed}})["trace"].get<std::string>());
  }
  EXPECT_GT(traces.size(), 10u);
}

TEST(ExplorerTest, WatchingReceivedDataBreaksNothing) {
  ExplorePlan plan = StickPlan("ideal", true);
  plan.runs = 5;
  const Json result = ExploreSeeds(plan);
  EXPECT_EQ(result["broken"], 0) << result.value("failure", Json()).dump(1);
}

TEST(ExplorerTest, HandlersThatTakeTimeBreakNothing) {
  const std::string cost = std::string(OPENR_MODEL_DIR) + "/ers210.cost";
  ExplorePlan plan = StickPlan("ideal", false, cost);
  plan.runs = 5;
  plan.run.properties.names = {"default", "standing"};
  const Json result = VerifySeeds(plan);
  EXPECT_EQ(result["differences"], 0);
  EXPECT_EQ(result["broken"], 0) << result.value("failure", Json()).dump(1);
}

TEST(ExplorerTest, ARandomRunIsRepeatedByItsDeviations) {
  const ExplorePlan plan = StickPlan();
  ExplorerProcesses pool(plan.prepare_run, plan.run, plan.limits, 1);
  for (uint64_t seed = 2; seed < 6; ++seed) {
    const Json random = pool.RunOne({{"seed", seed}, {"deviations", true}});
    const Json scripted = pool.RunOne({{"seed", seed}, {"script", random["deviations"]}});
    EXPECT_EQ(scripted["trace"], random["trace"]) << seed;
    EXPECT_EQ(scripted["state"], random["state"]) << seed;
  }
}

// The run was killed because it did not end in time, so nobody knows the time of its failure.
TEST(ExplorerTest, AFailureWithoutATimeIsRepeatedForTheWholeLength) {
  const Json answer = {{"broken",
                        {{"property", kHandlersReturn},
                         {"time_us", nullptr},
                         {"message", nullptr},
                         {"text", "the run did not end within 120 s of real time"}}}};
  FailingRun run(StickPlan().prepare_run, Json::array(), 1, 16'000, answer);
  EXPECT_EQ(run.length_us(), 16'000);
  run.RunUntil(run.length_us());
  EXPECT_EQ(run.EndReason(),
            "the run is over; the property 'handlers-return' is broken: the run did not end within "
            "120 s of real time");
}

TEST(ExplorerTest, AStickThatDoesNotBootIsAnError) {
  ExplorePlan plan = StickPlan();
  plan.prepare_run = [] {
    PreparedRun prepared;
    prepared.problem = "the robot does not boot";
    return prepared;
  };
  EXPECT_THROW(ExploreSeeds(plan), std::runtime_error);
}

TEST(ExplorerTest, AQuantityThatIsNotThereIsAnErrorAndNoFailure) {
  ExplorePlan plan = StickPlan();
  plan.run.properties.names = {"always objects.JointMovr.state != failed"};
  try {
    ExploreSeeds(plan);
    FAIL() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(),
                 "--property:1: no object of robot 0 'JointMovr'; did you mean 'JointMover'?\n"
                 "always objects.JointMovr.state != failed\n"
                 "       ^");
  }
}

// Forbids all descriptors to the process that has made the copy in which this object runs, so that
// poll() fails in that process.
class DescriptorTaker : public Actor {
 public:
  OStatus DoStart(const OSystemEvent&) override {
    const rlimit none = {0, 0};
    return prlimit(getppid(), RLIMIT_NOFILE, &none, nullptr) == 0 ? oSUCCESS : oFAIL;
  }
};

TEST(ExplorerTest, AnAnswerThatCannotBeReadIsAnErrorAndNoFailure) {
  const auto build = [](System* system) { system->AddObject<DescriptorTaker>(0, "taker"); };
  const ExplorePlan plan = PlanOf(SceneOf(build));
  ExplorerProcesses pool(plan.prepare_run, plan.run, plan.limits, 1);
  try {
    const Json answer = pool.RunOne({{"seed", 1}});
    FAIL() << answer.dump(1);
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "cannot read the result of a run: Invalid argument");
  }
}

}  // namespace
}  // namespace openr_host
