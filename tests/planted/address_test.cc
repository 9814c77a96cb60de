// A fault that two runs in one process do not show: data that depend on where memory lies.
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>

#include "tests/planted/planted.h"

namespace openr_host::address_test {
namespace {

constexpr char kOut[] = "Sender.Out.Number.S";
constexpr char kIn[] = "Receiver.In.Number.O";

// Fault: takes the address of what it has allocated for a number.
class Labeller : public Actor {
 public:
  Labeller() {
    out_ = AddSubject(kOut, [this](const OReadyEvent&) {
      Send(out_, static_cast<int>(reinterpret_cast<intptr_t>(label_.get())));
    });
  }

 private:
  OSubject* out_;
  const std::unique_ptr<int> label_ = std::make_unique<int>();
};

class Receiver : public Actor {
 public:
  Receiver() {
    in_ = AddObserver(kIn, [](const ONotifyEvent&) {});
  }
  OStatus DoStart(const OSystemEvent&) override { return in_->AssertReady(); }

 private:
  OObserver* in_;
};

TEST(PlantedAddressTest, WhatDependsOnAnAddressIsFoundByAProcessWithItsMemoryElsewhere) {
  ExplorePlan plan = PlanOf(SceneOf([](System* system) {
                              system->AddObject<Labeller>(0, "labeller");
                              system->AddObject<Receiver>(0, "receiver");
                              Wire(system, kOut, kIn);
                            }),
                            {"no-errors"});
  plan.runs = 3;
  const Json result = VerifySeeds(plan);
  EXPECT_EQ(result["runs"], 3);
  EXPECT_EQ(result["differences"], 0);
  EXPECT_EQ(result["address_dependent"], 3);
}

}  // namespace
}  // namespace openr_host::address_test
