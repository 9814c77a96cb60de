// core.md section 6.5: the Aperios calls, made by an object built from a stub.cfg.
#include <MCOOP.h>

#include "tests/conformance/conform_fixture.h"

namespace openr_host {
namespace {

// Answers what it is asked, says what it got, or hands the question on.
class Asked : public CodeObject {
 public:
  Asked() {
    AddExtra("Question", [](void* message) {
      const std::string text = static_cast<const char*>(message);
      char answer[] = "42";
      if (text == "answer") Reply(answer, sizeof answer);
    });
  }
};

// Asks Teller, and keeps what it says.
class Asker : public CodeObject {
 public:
  Asker() {
    AddExtra("Go", [this](void* message) {
      char reply[32] = "";
      const sError sent = Call(teller, entry, message, 9, reply, sizeof reply);
      answer = fmt::format("{} {}", sent, reply);
    });
  }
  OID teller;
  Selector entry = UNDEF;
  std::string answer = "(none)";
};

class AperiosConformance : public ConformTest {
 protected:
  void StartWithOthers() {
    ASSERT_TRUE(Load()) << Findings();
    system->AddObject<Asked>(0, "asked");
    asker = system->AddObject<Asker>(0, "asker");
    Boot();
    asker->teller = OID(reinterpret_cast<void*>(uintptr_t{0x80000043}));
    asker->entry = EntryOf("teller", "Ask");
    printed.clear();
  }
  Asker* asker = nullptr;
};

// core.md 6.5, SetTimeEvent: chosen, no source but the header
TEST_F(AperiosConformance, ATimedMessageComesOnceAtItsTime) {
  Start();
  EXPECT_EQ(Answer("timer 30 0"), "T timer 0 id 1\n");
  system->RunFor(28'000);
  EXPECT_EQ(Said(), "");
  system->RunFor(1'000);
  EXPECT_EQ(Said(), "T tick tock\n");
  system->RunFor(100'000);
  EXPECT_EQ(Said(), "");
}

TEST_F(AperiosConformance, APeriodicMessageComesUntilItIsCancelled) {
  Start();
  Tell("timer 10 20");
  Said();
  system->RunFor(9'000);
  EXPECT_EQ(Said(), "T tick tock\n");
  system->RunFor(40'000);
  EXPECT_EQ(Said(), "T tick tock\nT tick tock\n");
  EXPECT_EQ(Answer("cancel"), "T cancel 0 again 26\n");  // sINVALIDEVENTID
  system->RunFor(100'000);
  EXPECT_EQ(Said(), "");
}

TEST_F(AperiosConformance, TimedMessagesAreBounded) {
  Start();
  for (int i = 0; i < 32; ++i) EXPECT_EQ(Answer("timer 900 0"), "T timer 0 id 1\n");
  EXPECT_EQ(Answer("timer 900 0"), "T timer 25 id 1\n");  // sFULLEVENTENTRY
}

TEST_F(AperiosConformance, TimedMessagesArePartOfTheStateAndEndWithTheRobot) {
  Start();
  const uint64_t before = system->state_hash();
  Tell("timer 900 100");
  EXPECT_NE(system->state_hash(), before);
  system->Shutdown(0);
  system->RunFor(2'000'000);
  EXPECT_EQ(Said().find("tick"), std::string::npos);
}

// core.md 6.5, SendWithRBox, Receive and CleanRBox
TEST_F(AperiosConformance, AReplyIsReceivedOnce) {
  StartWithOthers();
  Tell("ask answer 100");
  EXPECT_EQ(Said(), "T unknown object 7\nT send 0 receive 0 '42' 3 twice 21 clean 21\n");
}

TEST_F(AperiosConformance, ReceiveGivesUpAfterItsTimeWithError28) {
  StartWithOthers();
  Tell("ask silence 100");
  EXPECT_EQ(Said(), "T unknown object 7\n");
  Tell("notify");  // waits: the object is not there
  EXPECT_EQ(Said(), "");
  system->RunFor(100'000);
  EXPECT_EQ(Said(), "T send 0 receive 28 '' 0 twice 0 clean 0\nT notify 0\n");
}

TEST_F(AperiosConformance, AReplyEventComesWhenTheReplyIsThere) {
  StartWithOthers();
  Tell("ask later");
  EXPECT_EQ(Said(), "T reply event 0\nT tick can be received\n");
  EXPECT_EQ(Answer("receive"), "T received 0 '42'\n");
  EXPECT_EQ(Answer("cancel"), "T cancel 26 again 26\n");
}

// core.md 6.5, Reply, Return and Delegate
TEST_F(AperiosConformance, ReturnAnswersAndEndsTheMethod) {
  StartWithOthers();
  Post("asker", "Go", "question");
  Settle();
  EXPECT_EQ(asker->answer, "0 an answer");
  EXPECT_EQ(Said(), "T asked question\n");
}

TEST_F(AperiosConformance, ADelegatedRequestIsAnsweredByTheOther) {
  StartWithOthers();
  Post("asker", "Go", "delegate");
  Settle();
  EXPECT_EQ(Said(), "T asked delegate\nT asked handed on\n");
  EXPECT_EQ(asker->answer, "0 an answer");
}

TEST_F(AperiosConformance, ARequestThatCannotBeDelegatedIsAnsweredByTheObjectItself) {
  StartWithOthers();
  Post("asker", "Go", "misguide");
  Settle();
  EXPECT_EQ(Said(), "T asked misguide\nT delegate 16\n");
  EXPECT_EQ(asker->answer, "0 an answer");
}

// core.md 6.5, regions; field-notes.md, 3.1
TEST_F(AperiosConformance, MemoryIsMadeSharedResizedAndDeleted) {
  Start();
  EXPECT_EQ(Answer("memory"),
            "T page 4096 free 1 made 0 same 1 0 41 allow 0 size 0 0 6 detach 0 delete 0 unknown "
            "42\nT private 0 0 5\n");
}

TEST_F(AperiosConformance, ARegionOfAnotherObjectNeedsItsLeaveElseError44) {
  Start();
  RegionShares& shares = system->region_shares();
  const ObjectId owner = IdOf("teller");
  const ObjectId other = IdOf("hearer");
  const uint32_t region = system->regions().New(100, owner);
  EXPECT_EQ(shares.ChangeProtection(other, region, MEMPROTINFO_RW), sPERMISSIONDENIEDSHAREDMEM);
  EXPECT_EQ(shares.Allow(other, region, MEMPROTINFO_RW, other, false), sPERMISSIONDENIEDSHAREDMEM);
  EXPECT_EQ(shares.Allow(owner, region, MEMPROTINFO_R, other, false), sSUCCESS);
  EXPECT_EQ(shares.ChangeProtection(other, region, MEMPROTINFO_RW), sPERMISSIONDENIEDSHAREDMEM);
  EXPECT_EQ(shares.Allow(owner, region, MEMPROTINFO_RW, other, true), sSUCCESS);
  EXPECT_EQ(shares.ChangeProtection(other, region, MEMPROTINFO_RW), sSUCCESS);
  EXPECT_EQ(system->regions().OwnerOf(region), other);
  EXPECT_EQ(shares.Attach(other, region, MEMPROTINFO_INVALID), sINVALIDSHAREDMEMPROTECT);
}

// core.md 1.6
TEST_F(AperiosConformance, ResourcesAreThoseOfTheRobot) {
  Start();
  EXPECT_EQ(Answer("resources"),
            "T queue 32 entries 64 message 256 events 1 set 0 now 40 bad 31\n");
}

// core.md 6.5, names
TEST_F(AperiosConformance, NamesCanBeGivenAndTakenBack) {
  Start();
  EXPECT_EQ(Answer("names"),
            "T who 0 1 find 12 register 0 find 0 1 again 2 long 94 unregister 0 find 12\n");
}

// core.md 1.6: error 16
TEST_F(AperiosConformance, ASelectorThatTheReceiverLacksIsError16) {
  Start();
  EXPECT_EQ(Answer("post 40"), "T post 16\n");
  EXPECT_TRUE(Found("MCOOPMailer::intraDeliver selector is out of range: sel=40")) << Findings();
}

TEST_F(AperiosConformance, AMessageReachesAnyEntryOfAnyObject) {
  Start();
  EXPECT_EQ(Answer(fmt::format("post {}", EntryOf("hearer", "Command"))), "T post 0\n");
  EXPECT_EQ(Findings(), "");
}

TEST_F(AperiosConformance, AMessageOfMoreThan256BytesIsRefused) {
  Start();
  EXPECT_EQ(Answer("post too much"), "T post 15\n");  // sEXCEEDEDSIZEOFMSG
}

}  // namespace
}  // namespace openr_host
