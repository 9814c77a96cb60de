// Tests of subjects, observers and regions as measured on the original library (measured.md,
// section 1); each test is for one line of that section.
#include <gtest/gtest.h>

#include "runtime/core/rcregion_pool.h"
#include "tests/runtime/core/probe.h"

namespace openr_host {
namespace {

using Events = std::vector<std::string>;

class ReadyNotifyTest : public testing::Test {
 protected:
  ReadyNotifyTest() {
    system.AddRobot("ERS-210", nullptr);
    sender = system.AddObject<SubjectProbe>(0, "sender");
    receiver = system.AddObject<ObserverProbe>(0, "receiver");
    Wire("Sender.Out.Number.S", "Receiver.In.Number.O");
  }
  void Wire(const std::string& subject, const std::string& observer) {
    system.Connect({0, subject, observer, "test"});
  }
  void Boot() {
    system.Boot();
    Settle();
  }
  void Settle() { system.RunFor(1000); }
  void AssertReady() {
    RunAs(receiver, [&] { receiver->in->AssertReady(); });
    Settle();
  }
  void Send(int value) {
    RunAs(sender, [&] { EXPECT_EQ(sender->Send(value), oSUCCESS); });
    Settle();
  }

  System system;
  SubjectProbe* sender;
  ObserverProbe* receiver;
};

TEST_F(ReadyNotifyTest, NotifyToAReadyObserverArrivesAndClearsTheFlag) {
  Boot();
  AssertReady();
  RunAs(sender, [&] {
    EXPECT_EQ(sender->out->IsReady(), 1);
    sender->Send(7);
    EXPECT_EQ(sender->out->IsReady(), 0);
  });
  Settle();
  EXPECT_EQ(receiver->events, Events{"7"});
}

// The subject would take such bytes for addresses of regions.
TEST_F(ReadyNotifyTest, BytesSentToTheEntryOfASubjectAreRefused) {
  Boot();
  RunAs(receiver, [&] {
    const Selector ready = sender->out->GetID().GetSelector();
    OwnedMessage message = system.NewMessage(sender->host().id, ready);
    std::memset(message->payload, 0x41, 64);
    message->size = 64;
    EXPECT_EQ(system.Post(std::move(message)), 0);
  });
  Settle();
  ASSERT_EQ(system.findings().all().size(), 1u);
  EXPECT_NE(system.findings().all()[0].text.find("no notification and no ready"),
            std::string::npos);
  AssertReady();
  Send(7);
  EXPECT_EQ(receiver->events, Events{"7"});
}

TEST_F(ReadyNotifyTest, EverythingSetSinceTheLastNotifyIsOneEvent) {
  Boot();
  AssertReady();
  RunAs(sender, [&] {
    for (int value : {1, 2, 3}) sender->out->SetData(&value, sizeof value);
    sender->out->NotifyObservers();
  });
  Settle();
  EXPECT_EQ(receiver->events, Events{"1,2,3"});
  EXPECT_EQ(receiver->notify_counts, std::vector<int>{1});
}

TEST_F(ReadyNotifyTest, ReadyIsAFlagNotACounter) {
  Boot();
  AssertReady();
  AssertReady();
  EXPECT_EQ(sender->readies, (Events{"ready:1", "ready:1"}));
  Send(1);
  Send(2);
  EXPECT_EQ(receiver->events, Events{"1"});
}

TEST_F(ReadyNotifyTest, OfManyNotifiesToAnUnreadyObserverTheLatestWins) {
  receiver->on_notify = [&](const ONotifyEvent&) {};
  Boot();
  AssertReady();
  for (int value = 1; value <= 40; ++value) Send(value);
  EXPECT_EQ(receiver->events, Events{"1"});
  AssertReady();
  EXPECT_EQ(receiver->events, (Events{"1", "40"}));
}

TEST_F(ReadyNotifyTest, PendingDataGoOutBeforeTheReadyCallback) {
  Boot();
  Send(5);
  AssertReady();
  EXPECT_EQ(sender->readies, Events{"ready:0"});
  EXPECT_EQ(receiver->events, Events{"5"});
}

TEST_F(ReadyNotifyTest, TwoObserversOfOneSubjectCanSeeDifferentSequences) {
  ObserverProbe* late = system.AddObject<ObserverProbe>(0, "late", "Late.In.Number.O");
  Wire("Sender.Out.Number.S", "Late.In.Number.O");
  Boot();
  AssertReady();
  for (int value = 1; value <= 5; ++value) Send(value);
  AssertReady();
  RunAs(late, [&] { late->in->AssertReady(); });
  Settle();
  EXPECT_EQ(receiver->events, (Events{"1", "5"}));
  EXPECT_EQ(late->events, Events{"5"});
}

TEST_F(ReadyNotifyTest, DataNotifiedInDoStartBeforeAnybodyIsReadySurvive) {
  sender->on_start = [&] {
    sender->Send(1);
    sender->Send(2);
  };
  Boot();
  EXPECT_EQ(receiver->events, Events{});
  AssertReady();
  EXPECT_EQ(receiver->events, Events{"2"});
}

TEST_F(ReadyNotifyTest, NotifyWithNothingSetSendsNothingAndKeepsTheFlag) {
  Boot();
  AssertReady();
  RunAs(sender, [&] { EXPECT_EQ(sender->out->NotifyObservers(), oSUCCESS); });
  Settle();
  EXPECT_EQ(receiver->events, Events{});
  RunAs(sender, [&] { EXPECT_EQ(sender->out->IsReady(), 1); });
}

TEST_F(ReadyNotifyTest, TheFourteenthDatumThrowsAwayTheOldestAndReturns28) {
  Boot();
  AssertReady();
  RunAs(sender, [&] {
    for (int value = 1; value <= 13; ++value) {
      EXPECT_EQ(sender->out->SetData(&value, sizeof value), oSUCCESS);
    }
    const int value = 14;
    EXPECT_EQ(sender->out->SetData(&value, sizeof value), 28u);
    sender->out->NotifyObservers();
  });
  Settle();
  EXPECT_EQ(receiver->events, Events{"2,3,4,5,6,7,8,9,10,11,12,13,14"});
}

TEST_F(ReadyNotifyTest, ASubjectWithoutConnectionAcceptsEverything) {
  SubjectProbe* alone = system.AddObject<SubjectProbe>(0, "alone", "Alone.Out.Number.S");
  Boot();
  RunAs(alone, [&] {
    EXPECT_EQ(alone->Send(1), oSUCCESS);
    EXPECT_EQ(alone->out->IsReady(), 0);
    EXPECT_EQ(alone->out->NumberOfObservers(), 0);
  });
}

TEST_F(ReadyNotifyTest, DeassertReachesTheSubjectAndLaterNotifiesStayPending) {
  Boot();
  AssertReady();
  RunAs(receiver, [&] { receiver->in->DeassertReady(); });
  Settle();
  EXPECT_EQ(sender->readies, (Events{"ready:1", "deassert"}));
  Send(9);
  EXPECT_EQ(receiver->events, Events{});
  AssertReady();
  EXPECT_EQ(receiver->events, Events{"9"});
}

TEST_F(ReadyNotifyTest, IsReadyCountsReadyObservers) {
  ObserverProbe* second = system.AddObject<ObserverProbe>(0, "second", "Second.In.Number.O");
  Wire("Sender.Out.Number.S", "Second.In.Number.O");
  Boot();
  AssertReady();
  RunAs(sender, [&] { EXPECT_EQ(sender->out->IsAllReady(), 0); });
  RunAs(second, [&] { second->in->AssertReady(); });
  Settle();
  RunAs(sender, [&] {
    EXPECT_EQ(sender->out->IsReady(), 2);
    EXPECT_EQ(sender->out->IsAllReady(), 2);
    EXPECT_EQ(sender->out->IsReady(receiver->in->GetID()), 1);
    EXPECT_EQ(sender->out->ReadyStatus(second->in->GetID()), 1);
  });
}

TEST_F(ReadyNotifyTest, WithMaxFourPendingNotifiesAreOneEvent) {
  RunAs(receiver, [&] { receiver->in->SetBufCtrlParam(0, 1, 4); });
  Boot();
  for (int value = 1; value <= 5; ++value) Send(value);
  AssertReady();
  EXPECT_EQ(receiver->events, Events{"2,3,4,5"});
  EXPECT_EQ(receiver->notify_counts, std::vector<int>{4});
}

TEST_F(ReadyNotifyTest, WithMinThreeNothingIsSentBeforeThreeAreCollected) {
  RunAs(receiver, [&] { receiver->in->SetBufCtrlParam(0, 3, 4); });
  Boot();
  AssertReady();
  Send(1);
  Send(2);
  EXPECT_EQ(receiver->events, Events{});
  Send(3);
  EXPECT_EQ(receiver->events, Events{"1,2,3"});
  AssertReady();
  Send(4);
  EXPECT_EQ(receiver->events, Events{"1,2,3"});
}

TEST_F(ReadyNotifyTest, WithSkipOneEverySecondNotifyIsDropped) {
  RunAs(receiver, [&] { receiver->in->SetSkip(1); });
  receiver->on_notify = [&](const ONotifyEvent& event) {
    receiver->in->AssertReady(event.SenderID());
  };
  Boot();
  AssertReady();
  for (int value = 1; value <= 5; ++value) Send(value);
  EXPECT_EQ(receiver->events, (Events{"2", "4"}));
}

TEST_F(ReadyNotifyTest, WithSkipTwoEveryThirdNotifyArrives) {
  RunAs(receiver, [&] { receiver->in->SetSkip(2); });
  receiver->on_notify = [&](const ONotifyEvent& event) {
    receiver->in->AssertReady(event.SenderID());
  };
  Boot();
  AssertReady();
  for (int value = 1; value <= 7; ++value) Send(value);
  EXPECT_EQ(receiver->events, (Events{"3", "6"}));
}

// AddressSanitizer ends a program that asks for so much memory.
#if !defined(__SANITIZE_ADDRESS__)
TEST_F(ReadyNotifyTest, DataForWhichThereIsNoMemoryLeaveNoRegion) {
  constexpr size_t kTooMany = size_t{1} << 40;  // bytes
  const auto count_regions = [] {
    int count = 0;
    RCRegionPool::Visit([](const void*, size_t) {}, [&](const RCRegion*) { ++count; });
    return count;
  };
  Boot();
  RunAs(sender, [&] {
    const int before = count_regions();
    EXPECT_EQ(sender->out->SetData("", kTooMany), oNO_MEMORY);
    EXPECT_EQ(sender->out->SetData(sender->out->begin()->GetObserverID(), "", kTooMany),
              oNO_MEMORY);
    EXPECT_EQ(count_regions(), before);
  });
}
#endif

TEST_F(ReadyNotifyTest, NoRegionIsNoData) {
  Boot();
  RunAs(sender, [&] {
    EXPECT_EQ(sender->out->SetData(static_cast<RCRegion*>(nullptr)), oINVALID_ARG);
    EXPECT_EQ(sender->out->SetData(receiver->in->GetID(), static_cast<RCRegion*>(nullptr)),
              oINVALID_ARG);
    EXPECT_EQ(sender->out->RemainBuffer(), 13u);
  });
}

TEST_F(ReadyNotifyTest, SetNotifyUnitSizeIsRefusedOnceConnected) {
  RunAs(sender, [&] { EXPECT_EQ(sender->out->SetNotifyUnitSize(3), oSUCCESS); });
  Boot();
  RunAs(sender, [&] { EXPECT_NE(sender->out->SetNotifyUnitSize(2), oSUCCESS); });
}

// ---- reference counts

TEST_F(ReadyNotifyTest, SetDataAddsOneReferencePerObserverAndNotifyNone) {
  system.AddObject<ObserverProbe>(0, "second", "Second.In.Number.O");
  Wire("Sender.Out.Number.S", "Second.In.Number.O");
  Boot();
  RunAs(sender, [&] {
    RCRegion* region = new RCRegion(sizeof(int));
    EXPECT_EQ(region->NumberOfReference(), 1);
    sender->out->SetData(region);
    EXPECT_EQ(region->NumberOfReference(), 3);
    sender->out->NotifyObservers();
    EXPECT_EQ(region->NumberOfReference(), 3);
    sender->out->ClearBuffer();
    EXPECT_EQ(region->NumberOfReference(), 1);
    region->RemoveReference();
  });
}

TEST_F(ReadyNotifyTest, AReplacedPendingRegionIsReleasedAtOnce) {
  Boot();
  RunAs(sender, [&] {
    RCRegion* first = new RCRegion(sizeof(int));
    RCRegion* second = new RCRegion(sizeof(int));
    sender->out->SetData(first);
    sender->out->NotifyObservers();
    EXPECT_EQ(first->NumberOfReference(), 2);
    sender->out->SetData(second);
    sender->out->NotifyObservers();
    EXPECT_EQ(first->NumberOfReference(), 1);
    EXPECT_EQ(second->NumberOfReference(), 2);
    sender->out->ClearBuffer();
    first->RemoveReference();
    second->RemoveReference();
  });
}

TEST_F(ReadyNotifyTest, ADeliveredRegionIsReleasedByTheNextReadyBeforeTheCallback) {
  Boot();
  AssertReady();
  RCRegion* region = nullptr;
  RunAs(sender, [&] {
    region = new RCRegion(sizeof(int));
    sender->out->SetData(region);
    sender->out->NotifyObservers();
  });
  Settle();
  EXPECT_EQ(region->NumberOfReference(),
            2);  // the handler has returned, but ready was not asserted
  int in_callback = 0;
  sender->on_ready = [&](const OReadyEvent&) { in_callback = region->NumberOfReference(); };
  AssertReady();
  EXPECT_EQ(in_callback, 1);
  RunAs(sender, [&] { region->RemoveReference(); });
}

TEST_F(ReadyNotifyTest, InTheObserverAReceivedRegionShowsOneReference) {
  int references = 0;
  receiver->on_notify = [&](const ONotifyEvent& event) {
    references = event.RCData(0)->NumberOfReference();
  };
  Boot();
  AssertReady();
  Send(1);
  EXPECT_EQ(references, 1);
}

TEST_F(ReadyNotifyTest, ARegionTheObserverKeepsComesBackWithALaterReady) {
  RCRegion* kept = nullptr;
  receiver->on_notify = [&](const ONotifyEvent& event) {
    kept = event.RCData(0);
    kept->AddReference();
    receiver->in->AssertReady();
  };
  Boot();
  AssertReady();
  RCRegion* region = nullptr;
  RunAs(sender, [&] {
    region = new RCRegion(sizeof(int));
    sender->out->SetData(region);
    sender->out->NotifyObservers();
  });
  Settle();
  EXPECT_EQ(region->NumberOfReference(), 2);  // the observer still has the region
  RunAs(receiver, [&] { kept->RemoveReference(); });
  AssertReady();
  EXPECT_EQ(region->NumberOfReference(), 1);
  RunAs(sender, [&] { region->RemoveReference(); });
}

TEST_F(ReadyNotifyTest, ASharedRegionIsNotCopied) {
  const void* seen = nullptr;
  receiver->on_notify = [&](const ONotifyEvent& event) { seen = event.Data(0); };
  Boot();
  AssertReady();
  RCRegion* region = nullptr;
  RunAs(sender, [&] {
    region = new RCRegion(4096);
    sender->out->SetData(region);
    sender->out->NotifyObservers();
  });
  Settle();
  EXPECT_EQ(seen, region->Base());
  RunAs(sender, [&] {
    sender->out->ClearBuffer();
    region->RemoveReference();
  });
}

// ---- connections

TEST_F(ReadyNotifyTest, AnUnknownServiceIsReportedWithTheNearestNameAndTheOtherLinesHold) {
  Wire("Sender.Outt.Number.S", "Receiver.In.Number.O");
  Boot();
  AssertReady();
  Send(3);
  EXPECT_EQ(receiver->events, Events{"3"});
  ASSERT_EQ(system.findings().all().size(), 1u);
  EXPECT_NE(system.findings().all()[0].text.find(
                "Sender.Outt.Number.S NOT FOUND; did you mean 'Sender.Out.Number.S'?"),
            std::string::npos)
      << system.findings().all()[0].text;
}

TEST_F(ReadyNotifyTest, AServiceThatALostObjectHasNotRegisteredIsNotReported) {
  Wire("Sender.Outt.Number.S", "Receiver.In.Number.O");
  sender->host().set_lost(true);
  Boot();
  EXPECT_TRUE(system.findings().all().empty());
}

TEST_F(ReadyNotifyTest, ManySubjectsMayFeedOneObserverWithReadinessOfTheirOwn) {
  SubjectProbe* other = system.AddObject<SubjectProbe>(0, "other", "Other.Out.Number.S");
  Wire("Other.Out.Number.S", "Receiver.In.Number.O");
  receiver->on_notify = [&](const ONotifyEvent& event) {
    receiver->in->AssertReady(event.SenderID());
  };
  Boot();
  AssertReady();
  Send(1);
  RunAs(other, [&] { other->Send(100); });
  Settle();
  Send(2);
  EXPECT_EQ(receiver->events, (Events{"1", "100", "2"}));
  EXPECT_EQ(other->readies.size(), 2u);
}

class SelfConnected : public SubjectProbe {
 public:
  SelfConnected() : SubjectProbe("Self.Out.Number.S") {
    in = AddObserver("Self.In.Number.O", [this](const ONotifyEvent& event) {
      received += event.NumOfData();
      in->AssertReady();
    });
  }
  OObserver* in;
  int received = 0;
};

TEST(SelfConnectionTest, ASubjectAndAnObserverOfOneObjectCanBeConnected) {
  System system;
  system.AddRobot("ERS-210", nullptr);
  SelfConnected* self = system.AddObject<SelfConnected>(0, "self");
  system.Connect({0, "Self.Out.Number.S", "Self.In.Number.O", "test"});
  system.Boot();
  system.RunFor(1000);
  RunAs(self, [&] {
    self->in->AssertReady();
    self->Send(1);
  });
  system.RunFor(1000);
  EXPECT_EQ(self->received, 1);
  EXPECT_TRUE(system.findings().all().empty());
}

}  // namespace
}  // namespace openr_host
