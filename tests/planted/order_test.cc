// Faults that the default order hides: found by exploring, shortened, and replayed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/planted/planted.h"

namespace openr_host::order_test {
namespace {

using testing::HasSubstr;

// ---- Start order

class Client : public Actor {
 public:
  Client() {
    in_ = AddObserver("Client.Settings.Number.O", [this](const ONotifyEvent&) {
      Say("configured");
      in_->AssertReady();
    });
  }
  OStatus DoStart(const OSystemEvent&) override { return in_->AssertReady(); }

 private:
  OObserver* in_;
};

// Fault: sends its settings in DoStart if the client is ready, and otherwise never.
class Settings : public Actor {
 public:
  Settings() { out_ = AddSubject("Settings.Out.Number.S"); }
  OStatus DoStart(const OSystemEvent&) override {
    if (out_->IsReady()) Send(out_, 1);
    return oSUCCESS;
  }

 private:
  OSubject* out_;
};

ExplorePlan StartOrderPlan() {
  const auto build = [](System* system) {
    system->AddObject<Client>(0, "client");
    system->AddObject<Settings>(0, "settings");
    Wire(system, "Settings.Out.Number.S", "Client.Settings.Number.O");
  };
  return PlanOf(SceneOf(build), {"eventually within 1s objects.client.state == configured"});
}

TEST(PlantedOrderTest, TheStartOrderBugIsMissedByTheDefaultOrderAndFoundByExploring) {
  EXPECT_EQ(InDefaultOrder(StartOrderPlan()).property, "");
  const Broken broken = InRandomOrders(StartOrderPlan());
  EXPECT_NE(broken.property, "");
  ASSERT_EQ(broken.deviations, 1u) << broken.failure.dump(1);
  EXPECT_EQ(broken.failure["deviations"][0]["kind"], "start");
  EXPECT_EQ(broken.failure["deviations"][0]["object"], "settings");
}

TEST(PlantedOrderTest, TheStartOrderBugIsFoundAmongAllOrders) {
  const Broken broken = InAllOrders(StartOrderPlan());
  EXPECT_EQ(broken.deviations, 1u);
}

// ---- Ties

// Wakes both of its observers every 100 ms.
class Clock : public Actor {
 public:
  Clock() {
    tick_ = AddSubject("Clock.Tick.Number.S");
    next_ = AddExtra("Next", [this](void*) { Tick(); });
  }
  OStatus DoStart(const OSystemEvent&) override {
    Post(host().id, next_, 100'000);
    return oSUCCESS;
  }

 private:
  void Tick() {
    Send(tick_, ++number_);
    Post(host().id, next_, 100'000);
  }
  OSubject* tick_;
  Selector next_;
  int number_ = 0;
};

// Passes on every tick with its own sign.
class Half : public Actor {
 public:
  Half(const std::string& name, int sign) {
    out_ = AddSubject(name + ".Out.Number.S");
    in_ = AddObserver(name + ".In.Number.O", [this, sign](const ONotifyEvent& event) {
      Send(out_, sign * NumberIn(event));
      in_->AssertReady();
    });
  }
  OStatus DoStart(const OSystemEvent&) override { return in_->AssertReady(); }

 private:
  OSubject* out_;
  OObserver* in_;
};

// Fault: takes it for granted that the left half of a tick comes first.
class Joiner : public Actor {
 public:
  Joiner() {
    left_ = AddObserver("Joiner.Left.Number.O", [this](const ONotifyEvent& event) {
      last_left_ = NumberIn(event);
      left_->AssertReady();
    });
    right_ = AddObserver("Joiner.Right.Number.O", [this](const ONotifyEvent& event) {
      if (last_left_ != -NumberIn(event)) Say("halves do not match");
      right_->AssertReady();
    });
  }
  OStatus DoStart(const OSystemEvent&) override {
    left_->AssertReady();
    return right_->AssertReady();
  }

 private:
  OObserver* left_;
  OObserver* right_;
  int last_left_ = 0;
};

ExplorePlan TiePlan() {
  const auto build = [](System* system) {
    system->AddObject<Clock>(0, "clock");
    system->AddObject<Half>(0, "left", "Left", 1);
    system->AddObject<Half>(0, "right", "Right", -1);
    system->AddObject<Joiner>(0, "joiner");
    Wire(system, "Clock.Tick.Number.S", "Left.In.Number.O");
    Wire(system, "Clock.Tick.Number.S", "Right.In.Number.O");
    Wire(system, "Left.Out.Number.S", "Joiner.Left.Number.O");
    Wire(system, "Right.Out.Number.S", "Joiner.Right.Number.O");
  };
  ExplorePlan plan = PlanOf(SceneOf(build), {"always objects.joiner.state != halves do not match"});
  plan.run.vary = {.starts = false, .delays = false};
  return plan;
}

TEST(PlantedOrderTest, TheTieBugIsMissedByTheDefaultOrderAndFoundByExploring) {
  EXPECT_EQ(InDefaultOrder(TiePlan()).property, "");
  const Broken broken = InRandomOrders(TiePlan());
  ASSERT_EQ(broken.deviations, 1u) << broken.failure.dump(1);
  EXPECT_EQ(broken.failure["deviations"][0]["kind"], "tie");
  EXPECT_EQ(broken.failure["deviations"][0]["object"], "right");
}

TEST(PlantedOrderTest, AFailureReplaysFromItsDeviations) {
  const ExplorePlan plan = TiePlan();
  const Broken broken = InRandomOrders(plan);
  const Json again =
      ReplayDeviations(plan, broken.failure["deviations"], broken.failure["seed"].get<uint64_t>());
  EXPECT_EQ(again["broken"]["text"], broken.text);
  EXPECT_EQ(again["broken"]["time_us"], broken.failure["time_us"]);
  EXPECT_EQ(again["tail"], broken.failure["tail"]);
}

TEST(PlantedOrderTest, TheTieBugIsFoundAmongAllOrders) {
  ExplorePlan plan = TiePlan();
  plan.run.for_us = 150'000;
  const Broken broken = InAllOrders(plan);
  EXPECT_EQ(broken.failure["deviations"].back()["kind"], "tie") << broken.failure.dump(1);
}

// ---- Slow observers

// Fault: gives up when the answer takes longer than 20 ms.
class ShortOfTime : public Actor {
 public:
  ShortOfTime() {
    ask_ = AddSubject("Client.Ask.Number.S");
    answered_ = AddObserver("Client.Answer.Number.O", [this](const ONotifyEvent&) {
      has_answer_ = true;
      answered_->AssertReady();
    });
    begin_ = AddExtra("Begin", [this](void*) {
      Send(ask_, 1);
      Post(host().id, check_, 20'000);
    });
    check_ = AddExtra("Check", [this](void*) { Say(has_answer_ ? "answered" : "gave up"); });
  }
  OStatus DoStart(const OSystemEvent&) override {
    Post(host().id, begin_, 500'000);
    return answered_->AssertReady();
  }

 private:
  OSubject* ask_;
  OObserver* answered_;
  Selector begin_, check_;
  bool has_answer_ = false;
};

class Server : public Actor {
 public:
  Server() {
    answer_ = AddSubject("Server.Answer.Number.S");
    ask_ = AddObserver("Server.Ask.Number.O", [this](const ONotifyEvent& event) {
      Send(answer_, NumberIn(event));
      ask_->AssertReady();
    });
  }
  OStatus DoStart(const OSystemEvent&) override { return ask_->AssertReady(); }

 private:
  OSubject* answer_;
  OObserver* ask_;
};

TEST(PlantedOrderTest, AnAnswerThatIsExpectedTooSoonIsFoundWithASlowObject) {
  const auto build = [](System* system) {
    system->AddObject<ShortOfTime>(0, "client");
    system->AddObject<Server>(0, "server");
    Wire(system, "Client.Ask.Number.S", "Server.Ask.Number.O");
    Wire(system, "Server.Answer.Number.S", "Client.Answer.Number.O");
  };
  const ExplorePlan plan = PlanOf(SceneOf(build), {"always objects.client.state != gave up"});
  EXPECT_EQ(InDefaultOrder(plan).property, "");
  const Broken broken = InRandomOrders(plan);
  ASSERT_EQ(broken.deviations, 1u) << broken.failure.dump(1);
  const Json& delay = broken.failure["deviations"][0];
  EXPECT_EQ(delay["kind"], "delay");
  // Halved as long as it still breaks.
  EXPECT_GE(delay["us"].get<int64_t>(), 20'000);
  EXPECT_LT(delay["us"].get<int64_t>(), 40'001);
}

}  // namespace
}  // namespace openr_host::order_test
