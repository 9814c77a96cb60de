// A fault that makes the dog fall, in one order of starts only.
#include <gtest/gtest.h>

#include "openr/simulation/simulation.h"
#include "tests/planted/planted.h"

namespace openr_host::fall_test {
namespace {

constexpr int64_t kPushUs = 16'000'000;  // the dog has stood by then

class Cautious : public Actor {
 public:
  Cautious() { in_ = AddObserver("Cautious.Word.Number.O"); }
  OStatus DoStart(const OSystemEvent&) override { return in_->AssertReady(); }

 private:
  OObserver* in_;
};

// Fault: if the other object is not ready when this one starts, pushes the dog over, and otherwise
// never.
class Clumsy : public Actor {
 public:
  Clumsy() { out_ = AddSubject("Clumsy.Out.Number.S"); }
  OStatus DoStart(const OSystemEvent&) override {
    if (!out_->IsReady()) system().inputs().AddAt(kPushUs, 0, "push 0 20 0 for 400ms");
    return oSUCCESS;
  }

 private:
  OSubject* out_;
};

ExplorePlan FallPlan(const std::string& property) {
  SimulationOptions options;
  options.stick = OPENR_STICK;
  options.body = "ode";
  options.console = [](std::string_view) {};
  const auto prepare = [options] {
    PreparedRun prepared = PrepareSimulation(options);
    prepared.system->AddObject<Cautious>(0, "cautious");
    prepared.system->AddObject<Clumsy>(0, "clumsy");
    Wire(prepared.system, "Clumsy.Out.Number.S", "Cautious.Word.Number.O");
    return prepared;
  };
  ExplorePlan plan = PlanOf(prepare, {property});
  plan.run.for_us = kPushUs + 2'000'000;
  plan.limits.handler_us = 10'000'000;  // the physical body may be slow with sanitizers
  return plan;
}

TEST(PlantedFallTest, AFallIsMissedByTheDefaultOrderAndFoundByExploring) {
  EXPECT_EQ(InDefaultOrder(FallPlan("not-fallen")).property, "");
  const Broken broken = InRandomOrders(FallPlan("not-fallen"));
  EXPECT_EQ(broken.property, "not-fallen");
  EXPECT_EQ(broken.text, "robot 0 has stood, and leans more than 45 degrees now");
  ASSERT_EQ(broken.deviations, 1u) << broken.failure.dump(1);
  EXPECT_EQ(broken.failure["deviations"][0]["kind"], "start");
}

TEST(PlantedFallTest, ADogThatLiesAtTheEndIsFoundAsWell) {
  EXPECT_EQ(InDefaultOrder(FallPlan("standing")).property, "");
  const Broken broken = InRandomOrders(FallPlan("standing"));
  EXPECT_EQ(broken.property, "standing");
  EXPECT_EQ(broken.text, "robot 0 does not stand");
}

}  // namespace
}  // namespace openr_host::fall_test
