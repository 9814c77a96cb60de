// Orders the robot leaves open, doors in front of handlers, handlers that take time.
#include "runtime/core/schedule.h"

#include <OPENR/RCRegion.h>
#include <gtest/gtest.h>
#include <sError.h>

#include <map>
#include <memory>
#include <set>

#include "runtime/core/cpu.h"
#include "runtime/core/dispatcher.h"
#include "tests/runtime/core/recorder.h"

namespace openr_host {
namespace {

// Always the last candidate; refuses and delays what it is told to.
class LastFirst : public Schedule {
 public:
  size_t Choose(Question, const std::vector<ObjectId>& candidates) override {
    ++choices;
    return candidates.size() - 1;
  }
  int64_t ExtraDelayUs(const Message&, int64_t, int64_t) override { return delay_us; }
  bool Refuses(const Message&) override { return refuse; }

  int choices = 0;
  int64_t delay_us = 0;
  bool refuse = false;
};

class ScheduleTest : public testing::Test {
 protected:
  ScheduleTest() { Restart({}); }

  void Restart(SystemOptions options) {
    log.clear();
    objects.clear();
    system = std::make_unique<System>(std::move(options));
    system->AddRobot("ERS-210", nullptr);
    for (const char* name : {"a", "b", "c"})
      objects[name] = system->AddObject<Recorder>(0, name, &log);
  }

  // Two messages for each, posted in the order a b c a b c.
  Log RunTies() {
    for (int value = 1; value <= 2; ++value) {
      for (const auto& [name, object] : objects) PostTo(object, value);
    }
    system->RunFor(1000);
    return log;
  }

  Log log;
  std::unique_ptr<System> system;
  std::map<std::string, Recorder*> objects;
};

TEST_F(ScheduleTest, WithoutOneMessagesGoByNumber) {
  EXPECT_EQ(RunTies(), (Log{"a:1@0", "b:1@0", "c:1@0", "a:2@0", "b:2@0", "c:2@0"}));
}

TEST_F(ScheduleTest, ItChoosesTheReceiverAndKeepsTheOrderOfEach) {
  LastFirst schedule;
  system->set_schedule(&schedule);
  EXPECT_EQ(RunTies(), (Log{"c:1@0", "c:2@0", "b:1@0", "b:2@0", "a:1@0", "a:2@0"}));
  EXPECT_EQ(schedule.choices, 4);  // with one receiver left nothing is to be chosen
}

TEST_F(ScheduleTest, PrioritiesHold) {
  LastFirst schedule;
  system->set_schedule(&schedule);
  objects["a"]->host().set_priority(144);
  EXPECT_EQ(RunTies(), (Log{"a:1@0", "a:2@0", "c:1@0", "c:2@0", "b:1@0", "b:2@0"}));
}

TEST_F(ScheduleTest, SeedOneIsTheCanonicalOrder) {
  const Log canonical = RunTies();
  Restart({.seed = 1});
  EXPECT_EQ(RunTies(), canonical);
}

TEST_F(ScheduleTest, SeedsDrawOrdersOfTheirOwnAndRepeatThem) {
  std::set<Log> orders;
  std::set<uint64_t> hashes;
  for (uint64_t seed = 2; seed < 12; ++seed) {
    Restart({.seed = seed});
    const Log order = RunTies();
    const uint64_t hash = system->trace_hash();
    orders.insert(order);
    hashes.insert(hash);
    Restart({.seed = seed});
    EXPECT_EQ(RunTies(), order) << seed;
    EXPECT_EQ(system->trace_hash(), hash) << seed;
  }
  EXPECT_GT(orders.size(), 5u);
  EXPECT_EQ(hashes.size(), orders.size());
}

TEST_F(ScheduleTest, ASeedChangesOrdersButDelaysNothing) {
  SeedSchedule schedule(7);
  system->set_schedule(&schedule);
  for (const std::string& entry : RunTies()) EXPECT_EQ(entry.substr(entry.find('@')), "@0");
  EXPECT_EQ(log.size(), 6u);
}

TEST_F(ScheduleTest, ItDelaysAndRefuses) {
  LastFirst schedule;
  system->set_schedule(&schedule);
  schedule.delay_us = 250;
  EXPECT_EQ(PostTo(objects["a"], 1, 100), sSUCCESS);
  schedule.refuse = true;
  EXPECT_EQ(PostTo(objects["a"], 2), sFULLMSGQENTRY);
  system->RunFor(1000);
  EXPECT_EQ(log, (Log{"a:1@350"}));
}

class StartProbe : public CodeObject {
 public:
  explicit StartProbe(Log* log) : log_(log) {}
  OStatus DoInit(const OSystemEvent&) override { return Note("init"); }
  OStatus DoStart(const OSystemEvent&) override { return Note("start"); }

 private:
  OStatus Note(const char* what) {
    log_->push_back(host().name + " " + what);
    return oSUCCESS;
  }
  Log* const log_;
};

TEST_F(ScheduleTest, StartsMayComeInAnyOrderInitsMayNot) {
  LastFirst schedule;
  System boot;
  boot.AddRobot("ERS-210", nullptr);
  for (const char* name : {"x", "y", "z"}) boot.AddObject<StartProbe>(0, name, &log);
  boot.set_schedule(&schedule);
  boot.Boot();
  boot.RunFor(1000);
  EXPECT_EQ(log, (Log{"x init", "y init", "z init", "z start", "y start", "x start"}));
}

class KeepFor : public Gate {
 public:
  OwnedMessage Admit(OwnedMessage message) override {
    if (message->target == kept_for) kept.push_back(std::move(message));
    return message;
  }
  void ForEach(const std::function<void(const Message&)>& visit) const override {
    for (const OwnedMessage& message : kept) visit(*message);
  }
  ObjectId kept_for = kNoObject;
  std::vector<OwnedMessage> kept;
};

TEST_F(ScheduleTest, AGateKeepsMessagesUntilTheyAreReadmitted) {
  KeepFor gate;
  gate.kept_for = objects["a"]->host().id;
  system->dispatcher().set_gate(&gate);
  EXPECT_EQ(RunTies(), (Log{"b:1@0", "c:1@0", "b:2@0", "c:2@0"}));
  ASSERT_EQ(gate.kept.size(), 2u);
  gate.kept_for = kNoObject;
  log.clear();
  for (size_t i = 2; i > 0; --i) system->Readmit(std::move(gate.kept[i - 1]));
  system->RunFor(1000);
  EXPECT_EQ(log, (Log{"a:1@1000", "a:2@1000"}));
}

TEST_F(ScheduleTest, AGateOfARunThatHadNoneKeepsMessages) {
  RunTies();
  log.clear();
  KeepFor gate;
  gate.kept_for = objects["a"]->host().id;
  system->dispatcher().set_gate(&gate);
  EXPECT_EQ(RunTies(), (Log{"b:1@1000", "c:1@1000", "b:2@1000", "c:2@1000"}));
  system->dispatcher().set_gate(nullptr);
  log.clear();
  PostTo(objects["a"], 3);
  system->RunFor(1000);
  EXPECT_EQ(log, (Log{"a:3@2000"}));
  gate.kept.clear();
}

// The same for every handler.
class FixedCost : public CostModel {
 public:
  explicit FixedCost(int64_t cost_us) : cost_us_(cost_us) {}
  int64_t CostUs(const Object&, uint32_t) override { return cost_us_; }

 private:
  const int64_t cost_us_;
};

class CpuTest : public ScheduleTest {
 protected:
  CpuTest() { Restart({.cost = std::make_shared<FixedCost>(100)}); }
};

TEST_F(CpuTest, OneHandlerAtATimeHasTheProcessor) {
  EXPECT_EQ(RunTies(), (Log{"a:1@0", "b:1@100", "c:1@200", "a:2@300", "b:2@400", "c:2@500"}));
}

TEST_F(CpuTest, WhatAHandlerPostsLeavesAtItsEnd) {
  objects["a"]->on_message = [&](int) { PostTo(objects["b"], 7); };
  PostTo(objects["a"], 1);
  system->RunFor(1000);
  EXPECT_EQ(log, (Log{"a:1@0", "b:7@100"}));
}

TEST_F(CpuTest, HigherPriorityTakesTheProcessorAndLengthensTheOther) {
  objects["c"]->host().set_priority(144);
  objects["a"]->on_message = [&](int) { PostTo(objects["b"], 7); };
  PostTo(objects["a"], 1);
  PostTo(objects["c"], 2, 30);
  system->RunFor(1000);
  EXPECT_EQ(log, (Log{"a:1@0", "c:2@30", "b:7@200"}));
}

TEST_F(CpuTest, EqualPriorityWaits) {
  PostTo(objects["a"], 1);
  PostTo(objects["c"], 2, 30);
  system->RunFor(1000);
  EXPECT_EQ(log, (Log{"a:1@0", "c:2@100"}));
}

TEST_F(CpuTest, ASecondMessageWaitsForItsObject) {
  objects["c"]->host().set_priority(144);
  PostTo(objects["c"], 1);
  PostTo(objects["c"], 2, 10);
  PostTo(objects["a"], 3, 20);
  system->RunFor(1000);
  EXPECT_EQ(log, (Log{"c:1@0", "c:2@100", "a:3@200"}));
}

TEST_F(CpuTest, SystemObjectsAreNotBoundToIt) {
  objects["c"]->host().set_system(true);
  PostTo(objects["a"], 1);
  PostTo(objects["c"], 2, 30);
  system->RunFor(1000);
  EXPECT_EQ(log, (Log{"a:1@0", "c:2@30"}));
}

TEST_F(CpuTest, RobotsHaveProcessorsOfTheirOwn) {
  const int second = system->AddRobot("ERS-210", nullptr);
  Recorder* const other = system->AddObject<Recorder>(second, "d", &log);
  PostTo(objects["a"], 1);
  PostTo(other, 2, 10);
  system->RunFor(1000);
  EXPECT_EQ(log, (Log{"a:1@0", "d:2@10"}));
}

// The event is that of another object, so it does not wait until the handler's messages leave.
TEST_F(CpuTest, ATimeEventComesWhileTheHandlerThatHasTheProcessorWaits) {
  Recorder* const waits = objects["a"];
  Recorder* const answers = objects["b"];
  Recorder* const timed = objects["c"];
  timed->host().set_system(true);
  const ObjectId id = timed->host().id;
  const int seven = 7;
  const auto* const bytes = reinterpret_cast<const unsigned char*>(&seven);
  system->time_events().AddTimed({id, id, timed->entry, {bytes, bytes + sizeof seven}}, 50, 0);
  waits->on_message = [&](int value) {
    int answer = 0;
    system->requests().Call(answers->host().id, answers->entry, &value, sizeof value, &answer,
                            sizeof answer);
  };
  answers->on_message = [&](int value) {
    system->requests().Reply(system->requests().TakeTicket(), &value, sizeof value);
  };
  PostTo(waits, 1);
  system->RunFor(1000);
  EXPECT_EQ(log, (Log{"a:1@0", "c:7@50", "b:1@100"}));
}

// Handlers of the object "busy" take time.
class BusyCosts : public CostModel {
 public:
  int64_t CostUs(const Object& object, uint32_t selector) override {
    return object.name == "busy" && selector >= oentryBASE ? 100 : 0;
  }
};

// The queue of a receiver is full when the processor time of the sender's handler is over.
class LateRefusalTest : public testing::Test {
 protected:
  LateRefusalTest() : system_({.strict = true, .cost = std::make_shared<BusyCosts>()}) {
    system_.AddRobot("ERS-210", nullptr);
  }
  // `most`: the largest number of notifications in one message; `least` of them must have come.
  void Start(const char* sender, const char* receiver, size_t least = 1, size_t most = 1) {
    sender_ = system_.AddObject<SubjectProbe>(0, sender);
    receiver_ = system_.AddObject<ObserverProbe>(0, receiver);
    RunAs(receiver_, [=, this] { receiver_->in->SetBufCtrlParam(0, least, most); });
    system_.Connect({0, "Sender.Out.Number.S", "Receiver.In.Number.O", "test"});
    system_.Boot();
    system_.RunFor(1000);
    RunAs(receiver_, [this] { receiver_->in->AssertReady(); });
  }

  System system_;
  SubjectProbe* sender_ = nullptr;
  ObserverProbe* receiver_ = nullptr;
};

TEST_F(LateRefusalTest, ANotificationWaitsForTheNextOne) {
  Start("busy", "receiver");
  sender_->on_ready = [this](const OReadyEvent&) { sender_->Send(1); };
  receiver_->host().set_queue_max(0);
  system_.RunFor(1000);
  EXPECT_EQ(system_.findings().all().size(), 1u);
  EXPECT_EQ(sender_->out->IsReady(), 1);
  receiver_->host().set_queue_max(32);
  RunAs(sender_, [this] { sender_->Send(2); });
  system_.RunFor(1000);
  EXPECT_EQ(receiver_->events, (Log{"1,2"}));
  EXPECT_EQ(receiver_->notify_counts, (std::vector<int>{2}));
}

// The observer asks for one notification at a time, so only the newest waits.
TEST_F(LateRefusalTest, ANotificationIsReplacedByALaterOneOfItsHandler) {
  Start("busy", "receiver");
  sender_->on_ready = [this](const OReadyEvent&) {
    sender_->Send(1);
    sender_->Send(2);
  };
  receiver_->host().set_queue_max(0);
  system_.RunFor(1000);
  EXPECT_EQ(system_.regions().CountOf(sender_->host().id), 1);
  receiver_->host().set_queue_max(32);
  RunAs(sender_, [this] { sender_->Send(3); });
  system_.RunFor(1000);
  EXPECT_EQ(receiver_->events, (Log{"2,3"}));
}

TEST_F(LateRefusalTest, SeveralNotificationsOfAMessageStaySeveral) {
  Start("busy", "receiver", 3, 4);
  sender_->on_ready = [this](const OReadyEvent&) {
    for (int value = 1; value <= 3; ++value) sender_->Send(value);
  };
  receiver_->host().set_queue_max(0);
  system_.RunFor(1000);
  receiver_->host().set_queue_max(32);
  RunAs(sender_, [this] { sender_->Send(4); });
  system_.RunFor(1000);
  EXPECT_EQ(receiver_->events, (Log{"1,2,3,4"}));
  EXPECT_EQ(receiver_->notify_counts, (std::vector<int>{4}));
}

TEST_F(LateRefusalTest, TheRegionsOfAReadyGoBack) {
  Start("sender", "busy");
  system_.RunFor(1000);
  receiver_->on_notify = [this](const ONotifyEvent&) { receiver_->in->AssertReady(); };
  RCRegion* region = nullptr;
  RunAs(sender_, [&] {
    region = new RCRegion(sizeof(int));
    sender_->out->SetData(region);
    sender_->out->NotifyObservers();
  });
  EXPECT_EQ(region->NumberOfReference(), 2);
  sender_->host().set_queue_max(0);
  system_.RunFor(1000);
  EXPECT_EQ(receiver_->events.size(), 1u);
  EXPECT_EQ(region->NumberOfReference(), 1);
  RunAs(sender_, [&] { region->RemoveReference(); });
}

TEST_F(LateRefusalTest, ARequestEndsTheWaitForItsReply) {
  Log log;
  Recorder* const asker = system_.AddObject<Recorder>(0, "busy", &log);
  Recorder* const other = system_.AddObject<Recorder>(0, "other", &log);
  other->host().set_queue_max(0);
  asker->on_message = [&](int value) {
    const int32_t error =
        system_.requests().Call(other->host().id, other->entry, &value, sizeof value, nullptr, 0);
    log.push_back(fmt::format("error {}@{}", error, system_.now_us()));
  };
  PostTo(asker, 1);
  system_.RunFor(1000);
  EXPECT_EQ(log, (Log{"busy:1@0", fmt::format("error {}@100", static_cast<int>(sTIMEOUT))}));
}

TEST_F(CpuTest, SlicingChangesNothing) {
  const Log whole = RunTies();
  const uint64_t hash = system->trace_hash();
  Restart({.cost = std::make_shared<FixedCost>(100)});
  for (int value = 1; value <= 2; ++value) {
    for (const auto& [name, object] : objects) PostTo(object, value);
  }
  for (int slice = 0; slice < 100; ++slice) system->RunFor(10);
  EXPECT_EQ(log, whole);
  EXPECT_EQ(system->trace_hash(), hash);
}

}  // namespace
}  // namespace openr_host
