// Faults that make somebody wait for ever.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "openr/explore/explore_cost.h"
#include "tests/planted/planted.h"

namespace openr_host::waiting_test {
namespace {

using testing::HasSubstr;

// ---- Deadlock

// Half of a pair that asks the other half, with Call(), whenever it is told to.
class Partner : public Actor {
 public:
  Partner() {
    go = AddExtra("Go", [this](void*) {
      Say("asking");
      int answer = 0;
      system().requests().Call(other->host().id, other->ask, &answer, sizeof answer, &answer,
                               sizeof answer);
      Say("answered");
    });
    ask = AddExtra("Ask", [this](void*) {
      const int answer = 1;
      system().requests().Reply(system().requests().TakeTicket(), &answer, sizeof answer);
    });
  }
  Partner* other = nullptr;
  Selector go, ask;
};

// Tells one of the pair directly, the other one by way of a relay.
class Conductor : public Actor {
 public:
  explicit Conductor(Partner* first) : first_(first) {
    begin_ = AddExtra("Begin", [this](void*) {
      Post(first_->host().id, first_->go);
      Post(relay, relay_entry);
    });
  }
  OStatus DoStart(const OSystemEvent&) override {
    Post(host().id, begin_, 100'000);
    return oSUCCESS;
  }
  ObjectId relay = kNoObject;
  Selector relay_entry = 0;

 private:
  Partner* const first_;
  Selector begin_;
};

class Relay : public Actor {
 public:
  explicit Relay(Partner* target) {
    entry = AddExtra("PassOn", [this, target](void*) { Post(target->host().id, target->go); });
  }
  Selector entry;
};

ExplorePlan DeadlockPlan() {
  const auto build = [](System* system) {
    auto* const first = system->AddObject<Partner>(0, "first");
    auto* const second = system->AddObject<Partner>(0, "second");
    first->other = second;
    second->other = first;
    auto* const conductor = system->AddObject<Conductor>(0, "conductor", first);
    auto* const relay = system->AddObject<Relay>(0, "relay", second);
    conductor->relay = relay->host().id;
    conductor->relay_entry = relay->entry;
  };
  return PlanOf(SceneOf(build));
}

TEST(PlantedWaitingTest, ADeadlockOfTwoIsMissedByTheDefaultOrderAndFoundByExploring) {
  EXPECT_EQ(InDefaultOrder(DeadlockPlan()).text, "");
  const Broken broken = InRandomOrders(DeadlockPlan());
  EXPECT_EQ(broken.property, "not-stuck");
  EXPECT_THAT(broken.failure["waits"].dump(),
              AllOf(HasSubstr("first waits for the answer of second (Ask)"),
                    HasSubstr("second waits for the answer of first (Ask)")));
}

TEST(PlantedWaitingTest, TheDeadlockIsFoundAmongAllOrders) {
  EXPECT_EQ(InAllOrders(DeadlockPlan()).property, "not-stuck");
}

// ---- Starvation

// Fault: has a high priority and work all the time.
class Hog : public Actor {
 public:
  Hog() {
    host().set_priority(144);
    work_ = AddExtra("Work", [this](void*) { Post(host().id, work_); });
  }
  OStatus DoStart(const OSystemEvent&) override {
    Post(host().id, work_, 10'000);
    return oSUCCESS;
  }

 private:
  Selector work_;
};

class Meek : public Actor {
 public:
  Meek() {
    tick_ = AddExtra("Tick", [this](void*) { Post(host().id, tick_, 8'000); });
  }
  OStatus DoStart(const OSystemEvent&) override {
    Post(host().id, tick_, 8'000);
    return oSUCCESS;
  }

 private:
  Selector tick_;
};

PreparedRun StarvingScene() {
  auto cost = std::make_shared<ExploredCost>(ParseCostConfig("test", "* Work 1000\n").config);
  SystemOptions options;
  options.cost = cost;
  PreparedRun prepared = SceneOf(
      [](System* system) {
        system->AddObject<Meek>(0, "meek");
        system->AddObject<Hog>(0, "hog");
      },
      options)();
  prepared.cost = cost.get();
  return prepared;
}

TEST(PlantedWaitingTest, AnObjectThatGetsNoProcessorTimeIsNamed) {
  const Broken broken = InDefaultOrder(PlanOf(&StarvingScene));
  EXPECT_EQ(broken.property, "every-ready-answered");
  EXPECT_THAT(broken.text, HasSubstr("meek waits for the processor since t=0.016 s"));
}

// ---- Handlers and messages without end

class Endless : public Actor {
 public:
  Endless() {
    work_ = AddExtra("Work", [this](void*) {
      while (goes_on_) {
      }
    });
  }
  OStatus DoStart(const OSystemEvent&) override {
    Post(host().id, work_, 10'000);
    return oSUCCESS;
  }

 private:
  volatile bool goes_on_ = true;
  Selector work_;
};

TEST(PlantedWaitingTest, AHandlerWithoutEndIsEndedAndNamed) {
  const auto build = [](System* system) { system->AddObject<Endless>(0, "endless"); };
  const Broken broken = InDefaultOrder(PlanOf(SceneOf(build)));
  EXPECT_EQ(broken.property, "handlers-return");
  EXPECT_THAT(broken.text, HasSubstr("endless"));
}

// Fault: two that answer each other at once, for ever.
class Chatter : public Actor {
 public:
  explicit Chatter(const std::string& name) {
    out_ = AddSubject(name + ".Out.Number.S");
    in_ = AddObserver(name + ".In.Number.O", [this](const ONotifyEvent& event) {
      in_->AssertReady();
      Send(out_, NumberIn(event) + 1);
    });
    begin_ = AddExtra("Begin", [this](void*) { Send(out_, 1); });
  }
  OStatus DoStart(const OSystemEvent&) override {
    Post(host().id, begin_, 10'000);
    return in_->AssertReady();
  }

 private:
  OSubject* out_;
  OObserver* in_;
  Selector begin_;
};

TEST(PlantedWaitingTest, MessagesThatStopTheClockAreAFinding) {
  const auto build = [](System* system) {
    system->AddObject<Chatter>(0, "a", "A");
    system->AddObject<Chatter>(0, "b", "B");
    Wire(system, "A.Out.Number.S", "B.In.Number.O");
    Wire(system, "B.Out.Number.S", "A.In.Number.O");
  };
  ExplorePlan plan = PlanOf(SceneOf(build), {"no-warnings"});
  plan.run.for_us = 20'000;
  EXPECT_THAT(InDefaultOrder(plan).text, HasSubstr("messages without the clock moving"));
}

}  // namespace
}  // namespace openr_host::waiting_test
