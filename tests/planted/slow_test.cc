// A run that takes too long for the explorer, as on a machine that stands still, is no difference.
#include <gtest/gtest.h>
#include <sys/mman.h>

#include <chrono>
#include <thread>

#include "tests/planted/planted.h"

namespace openr_host::slow_test {
namespace {

// An object that lets its process sleep for longer than the limit of a run.
class Sleeper : public Actor {
 public:
  explicit Sleeper(bool sleeps) : sleeps_(sleeps) {}
  OStatus DoStart(const OSystemEvent&) override {
    if (sleeps_) std::this_thread::sleep_for(std::chrono::minutes(10));
    return oSUCCESS;
  }

 private:
  const bool sleeps_;
};

// Two processes run each seed, and one of the two always sleeps.
TEST(PlantedSlowTest, ASeedWhoseSecondRunTakesTooLongIsNotCompared) {
  void* const memory =
      mmap(nullptr, sizeof(int), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(memory, MAP_FAILED);
  int* const scenes = static_cast<int*>(memory);  // number of processes that have made the scene
  ExplorePlan plan = PlanOf(SceneOf(
      [scenes](System* system) { system->AddObject<Sleeper>(0, "sleeper", (*scenes)++ == 0); }));
  plan.limits.wall_s = 1;
  plan.runs = 1;
  plan.shorten_runs = 0;
  const Json result = VerifySeeds(plan);
  EXPECT_EQ(result["runs"], 1);
  EXPECT_EQ(result["differences"], 0);
  EXPECT_EQ(result["address_dependent"], 0);
  EXPECT_EQ(result["not_compared"], 1);
  EXPECT_EQ(result["not_compared_seeds"], Json({1}));
  munmap(memory, sizeof(int));
}

}  // namespace
}  // namespace openr_host::slow_test
