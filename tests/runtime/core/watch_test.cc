// Tests of findings about ready, notify and received data, and of programs that get none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/core/stalls.h"
#include "tests/runtime/core/probe.h"

namespace openr_host {
namespace {

using testing::HasSubstr;

class WatchTest : public testing::Test {
 protected:
  WatchTest() { Restart({}); }

  void Restart(SystemOptions options) {
    system = std::make_unique<System>(std::move(options));
    system->AddRobot("ERS-210", nullptr);
    sender = system->AddObject<SubjectProbe>(0, "sender");
    receiver = system->AddObject<ObserverProbe>(0, "receiver");
    system->Connect({0, "Sender.Out.Number.S", "Receiver.In.Number.O", "test"});
  }
  void Boot() {
    system->Boot();
    system->RunFor(1000);
  }
  void AssertReady() {
    RunAs(receiver, [&] { receiver->in->AssertReady(); });
    system->RunFor(1000);
  }
  void Send(int value) {
    RunAs(sender, [&] { sender->Send(value); });
    system->RunFor(1000);
  }
  const std::vector<Finding>& findings() const { return system->findings().all(); }
  std::vector<std::string> Stalls(int64_t least_us = kStallUs) const {
    std::vector<std::string> texts;
    for (const Stall& stall : FindStalls(*system, least_us)) texts.push_back(stall.text);
    return texts;
  }

  std::unique_ptr<System> system;
  SubjectProbe* sender;
  ObserverProbe* receiver;
};

// ---- Replaced data

TEST_F(WatchTest, ReplacedDataAreReportedOnceAConnection) {
  Boot();
  for (int i = 0; i < 5; ++i) Send(i);
  ASSERT_EQ(findings().size(), 1u);
  EXPECT_EQ(findings()[0].object, "sender");
  EXPECT_EQ(findings()[0].count, 1u);
  EXPECT_EQ(sender->host().statistics().dropped_count(), 4u);
}

TEST_F(WatchTest, ASystemServiceMayReplaceItsData) {
  sender->host().set_system(true);
  Boot();
  for (int i = 0; i < 5; ++i) Send(i);
  EXPECT_TRUE(findings().empty());
}

TEST_F(WatchTest, WhatASystemServiceWasNotReadyForIsDroppedWithoutAFinding) {
  receiver->host().set_system(true);
  Boot();
  for (int i = 0; i < 5; ++i) Send(i);
  EXPECT_TRUE(findings().empty());
  EXPECT_EQ(sender->host().statistics().dropped_count(), 4u);
}

TEST_F(WatchTest, ALargerBufferKeepsThem) {
  receiver->in->SetBufCtrlParam(0, 1, 5);
  Boot();
  for (int i = 0; i < 5; ++i) Send(i);
  EXPECT_TRUE(findings().empty());
}

// ---- Readies in vain

TEST_F(WatchTest, ReadyAgainAndAgainIsReportedOnce) {
  Boot();
  for (int i = 0; i < 8; ++i) AssertReady();
  EXPECT_TRUE(findings().empty());
  for (int i = 0; i < 8; ++i) AssertReady();
  ASSERT_EQ(findings().size(), 1u);
  EXPECT_EQ(findings()[0].object, "receiver");
  EXPECT_EQ(findings()[0].count, 1u);
}

TEST_F(WatchTest, ANotificationBetweenMakesReadyGood) {
  Boot();
  for (int i = 0; i < 20; ++i) {
    AssertReady();
    AssertReady();
    Send(i);
  }
  EXPECT_TRUE(findings().empty());
}

TEST_F(WatchTest, ANotificationBeginsTheCountOfReadiesAnew) {
  Boot();
  AssertReady();
  Send(1);
  for (int i = 0; i < 8; ++i) AssertReady();
  EXPECT_TRUE(findings().empty());
  AssertReady();
  EXPECT_EQ(findings().size(), 1u);
}

// AssertReady() without argument goes to every subject, also to those that are silent.
TEST_F(WatchTest, ReadyToAllOnceANotificationIsGoodAlsoForSilentSubjects) {
  system->AddObject<SubjectProbe>(0, "silent", "Silent.Out.Number.S");
  system->Connect({0, "Silent.Out.Number.S", "Receiver.In.Number.O", "test"});
  Boot();
  AssertReady();
  receiver->on_notify = [&](const ONotifyEvent&) { receiver->in->AssertReady(); };
  for (int i = 0; i < 40; ++i) Send(i);
  EXPECT_EQ(receiver->events.size(), 40u);
  EXPECT_TRUE(findings().empty());
}

TEST_F(WatchTest, ReadyToAllAgainAndAgainWithoutANotificationIsReportedOfEach) {
  system->AddObject<SubjectProbe>(0, "silent", "Silent.Out.Number.S");
  system->Connect({0, "Silent.Out.Number.S", "Receiver.In.Number.O", "test"});
  Boot();
  for (int i = 0; i < 12; ++i) AssertReady();
  ASSERT_EQ(findings().size(), 2u);
  EXPECT_THAT(findings()[0].text, HasSubstr("Receiver.In.Number.O: asserts ready to sender again"));
  EXPECT_THAT(findings()[1].text, HasSubstr("Receiver.In.Number.O: asserts ready to silent again"));
}

TEST_F(WatchTest, ADeassertBetweenMakesReadyGood) {
  Boot();
  for (int i = 0; i < 20; ++i) {
    AssertReady();
    RunAs(receiver, [&] { receiver->in->DeassertReady(); });
    system->RunFor(1000);
  }
  EXPECT_TRUE(findings().empty());
}

TEST_F(WatchTest, TheCountOfReadiesBeginsAnewAfterADeassert) {
  Boot();
  RunAs(receiver, [&] { receiver->in->DeassertReady(); });
  system->RunFor(1000);
  for (int i = 0; i < 8; ++i) AssertReady();
  EXPECT_TRUE(findings().empty());
  AssertReady();
  EXPECT_EQ(findings().size(), 1u);
}

// ---- Stalls

TEST_F(WatchTest, DataThatWereClearedWaitForNobody) {
  Boot();
  Send(1);
  RunAs(sender, [&] { sender->out->ClearBuffer(); });
  system->RunFor(1'000'000);
  EXPECT_THAT(Stalls(), testing::ElementsAre(HasSubstr("receiver has never asserted ready")));
}

TEST_F(WatchTest, DataThatWaitForReadyAreAStallAfterASecond) {
  Boot();
  Send(1);
  EXPECT_TRUE(Stalls().empty());
  EXPECT_EQ(Stalls(0).size(), 1u);
  system->RunFor(1'000'000);
  EXPECT_THAT(
      Stalls(),
      testing::ElementsAre(HasSubstr("sender waits for ready of receiver on Sender.Out.Number.S")));
}

TEST_F(WatchTest, WhoTookOneNotificationAndLeavesTheNextMayHaveForgotten) {
  Boot();
  AssertReady();
  Send(1);
  Send(2);
  system->RunFor(1'000'000);
  ReportStalls(system.get(), false);
  ASSERT_EQ(findings().size(), 1u);
  EXPECT_EQ(findings()[0].severity, Severity::kWarning);
}

TEST_F(WatchTest, WhoHasAssertedAgainBeforeHasStoppedOnPurpose) {
  Boot();
  AssertReady();
  Send(1);
  AssertReady();
  Send(2);
  Send(3);
  system->RunFor(1'000'000);
  ReportStalls(system.get(), false);
  ASSERT_EQ(findings().size(), 1u);
  EXPECT_EQ(findings()[0].severity, Severity::kNote);
  EXPECT_THAT(findings()[0].text, HasSubstr("sender waits for ready of receiver"));
}

TEST_F(WatchTest, TheRobotWaitsForNobody) {
  sender->host().set_system(true);
  Boot();
  AssertReady();
  Send(1);
  Send(2);
  system->RunFor(1'000'000);
  ReportStalls(system.get(), false);
  ASSERT_EQ(findings().size(), 1u);
  EXPECT_EQ(findings()[0].severity, Severity::kNote);
}

TEST_F(WatchTest, ANotificationWithoutReadyIsAStallAfterASecond) {
  Boot();
  AssertReady();
  Send(1);
  EXPECT_TRUE(Stalls(0).empty());
  system->RunFor(1'000'000);
  EXPECT_THAT(Stalls(), testing::ElementsAre(HasSubstr("receiver has not asserted ready")));
  ReportStalls(system.get(), false);
  EXPECT_TRUE(findings().empty()) << "it may want no more";
  ReportStalls(system.get(), true);
  EXPECT_EQ(findings().size(), 1u);
  AssertReady();
  EXPECT_TRUE(Stalls().empty());
}

TEST_F(WatchTest, WhoNeverAssertsReadyIsNamedThoughNothingWasSent) {
  Boot();
  EXPECT_TRUE(Stalls(0).empty()) << "it may do so later";
  system->RunFor(1'000'000);
  EXPECT_THAT(Stalls(),
              testing::ElementsAre("receiver has never asserted ready to Sender.Out.Number.S"));
  ReportStalls(system.get(), false);
  EXPECT_TRUE(findings().empty()) << "it may want nothing";
}

TEST_F(WatchTest, WhoSaysNotReadyIsNoStall) {
  Boot();
  RunAs(receiver, [&] { receiver->in->DeassertReady(); });
  system->RunFor(1000);
  Send(1);
  system->RunFor(2'000'000);
  EXPECT_TRUE(Stalls().empty());
}

// ---- Guarded data

class GuardTest : public WatchTest {
 protected:
  GuardTest() { Restart({.guard_regions = true}); }
};

TEST_F(GuardTest, DataArriveAsTheyWereSent) {
  receiver->on_notify = [&](const ONotifyEvent&) { receiver->in->AssertReady(); };
  Boot();
  AssertReady();
  Send(7);
  Send(8);
  EXPECT_EQ(receiver->events, (std::vector<std::string>{"7", "8"}));
  EXPECT_TRUE(findings().empty());
}

TEST_F(GuardTest, AReferenceKeepsThemReadable) {
  RCRegion* kept = nullptr;
  receiver->on_notify = [&](const ONotifyEvent& event) {
    if (kept == nullptr) {
      kept = event.RCData(0);
      kept->AddReference();
    }
    receiver->in->AssertReady();
  };
  Boot();
  AssertReady();
  for (int value = 1; value <= 3; ++value) Send(value);
  EXPECT_EQ(*reinterpret_cast<const int*>(kept->Base()), 1);
}

TEST_F(GuardTest, AfterReadyTheyAreGone) {
  receiver->on_notify = [&](const ONotifyEvent& event) {
    const auto* const data = static_cast<const volatile int*>(event.Data(0));
    receiver->in->AssertReady();
    EXPECT_DEATH((void)*data, "");
  };
  Boot();
  AssertReady();
  Send(1);
  EXPECT_EQ(receiver->events.size(), 1u);
}

TEST_F(GuardTest, ChangedDataAreAnErrorOfTheSender) {
  Boot();
  AssertReady();
  RunAs(sender, [&] {
    auto* const region = new RCRegion(sizeof(int));
    sender->out->SetData(region);
    sender->out->NotifyObservers();
    *region->Base() = 1;
  });
  system->RunFor(1000);
  ASSERT_EQ(findings().size(), 1u);
  EXPECT_EQ(findings()[0].severity, Severity::kError);
  EXPECT_EQ(findings()[0].object, "sender");
}

TEST_F(GuardTest, WatchingDoesNotShowInTheHashes) {
  const auto hashes = [this](bool guard) {
    Restart({.guard_regions = guard});
    receiver->on_notify = [&](const ONotifyEvent&) { receiver->in->AssertReady(); };
    Boot();
    AssertReady();
    for (int value = 1; value <= 10; ++value) Send(value);
    return std::make_pair(system->trace_hash(), system->state_hash());
  };
  EXPECT_EQ(hashes(true), hashes(false));
}

}  // namespace
}  // namespace openr_host
