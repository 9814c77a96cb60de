// measured.md section 1, "Notify and ready" and "Reference counts": each line once more on
// objects built from stub.cfg files.
#include "tests/conformance/conform_fixture.h"

namespace openr_host {
namespace {

class ObjcommConformance : public ConformTest {};

// measured.md 1.6
TEST_F(ObjcommConformance, ReadyIsAFlagAndTwoAssertsGiveTwoCallbacks) {
  Start();
  Hear("assert");
  Hear("assert");
  EXPECT_EQ(Said(), "T ready 1 refs 0\nT ready 1 refs 0\n");
  Tell("send 1");
  Tell("send 2");
  EXPECT_EQ(Said(), "H in 1 (notifies 1 refs 1)\n");
}

// measured.md 1.7
TEST_F(ObjcommConformance, NotifySendsEverythingSetAsOneEventAndClearsTheFlag) {
  Start();
  Hear("assert");
  Said();
  for (const char* command : {"set 1", "set 2", "set 3", "notify", "ready?"}) Tell(command);
  EXPECT_EQ(Said(), "T notify 0\nH in 1 2 3 (notifies 1 refs 1)\nT any 0 ready 0 all 0\n");
}

// measured.md 1.8
TEST_F(ObjcommConformance, OfFiveNotifiesTheObserverGetsTheFirstAndTheLast) {
  Start();
  Hear("assert");
  for (const char* command : {"send 1", "send 2", "send 3", "send 4", "send 5"}) Tell(command);
  Hear("assert");
  EXPECT_EQ(Said(),
            "T ready 1 refs 0\nH in 1 (notifies 1 refs 1)\nT ready 0 refs 0\n"
            "H in 5 (notifies 1 refs 1)\n");
}

// measured.md 1.9
TEST_F(ObjcommConformance, PendingDataGoOutBeforeTheReadyCallback) {
  Start();
  Tell("send 9");
  Hear("assert");
  EXPECT_EQ(Said(), "T ready 0 refs 0\nH in 9 (notifies 1 refs 1)\n");
}

// measured.md 1.10
TEST_F(ObjcommConformance, TwoObserversCanSeeDifferentSequences) {
  Config("CONNECT.CFG",
         "Teller.Out.Number.S Hearer.In.Number.O\nTeller.Out.Number.S Hearer.Late.Number.O\n");
  Start();
  Hear("assert");
  for (const char* command : {"send 1", "send 2", "send 5"}) Tell(command);
  Hear("assert");
  Hear("assert late");
  const std::string said = Said();
  EXPECT_NE(said.find("H in 1 "), std::string::npos) << said;
  EXPECT_NE(said.find("H in 5 "), std::string::npos) << said;
  EXPECT_NE(said.find("H late 5 "), std::string::npos) << said;
  EXPECT_EQ(said.find("H late 1 "), std::string::npos) << said;
}

// measured.md 1.11
TEST_F(ObjcommConformance, DataNotifiedInDoStartSurviveAsTheLatestSet) {
  Data("TSTART.TXT", "send 1\nsend 2\n");
  Start();
  Hear("assert");
  EXPECT_EQ(Said(), "T ready 0 refs 0\nH in 2 (notifies 1 refs 1)\n");
}

// measured.md 1.12
TEST_F(ObjcommConformance, NotifyWithNothingSetSendsNothingAndKeepsTheFlag) {
  Start();
  Hear("assert");
  Said();
  Tell("notify");
  Tell("ready?");
  EXPECT_EQ(Said(), "T notify 0\nT any 1 ready 1 all 1\n");
}

// measured.md 1.13
TEST_F(ObjcommConformance, TheFourteenthDatumDropsTheOldestWithStatus28) {
  Start();
  Hear("assert");
  Said();
  for (int i = 1; i <= 14; ++i) Tell(fmt::format("set {}", i));
  Tell("notify");
  EXPECT_EQ(Said(),
            "T status 28\nT notify 0\nH in 2 3 4 5 6 7 8 9 10 11 12 13 14 (notifies 1 refs 1)\n");
  EXPECT_TRUE(Found("more than 13 data set before a notify"));
}

// measured.md 1.14
TEST_F(ObjcommConformance, ASubjectWithoutConnectionAcceptsEverything) {
  Config("CONNECT.CFG", "# nothing\n");
  Start();
  EXPECT_EQ(Answer("send 1"), "");
  EXPECT_EQ(Answer("notify"), "T notify 0\n");
}

// measured.md 1.15; field-notes.md, 2.4
TEST_F(ObjcommConformance, ANotifyAfterDeassertStaysPendingAndIsReported) {
  Start();
  Hear("deassert");
  EXPECT_EQ(Said(), "T deassert\n");
  Tell("send 6");
  EXPECT_TRUE(Found("Teller.Out.Number.S: notifies hearer, which has deasserted ready"))
      << Findings();
  Hear("assert");
  EXPECT_EQ(Said(), "T ready 0 refs 0\nH in 6 (notifies 1 refs 1)\n");
}

// measured.md 1.16
TEST_F(ObjcommConformance, IsReadyReturnsTheCount) {
  Config("CONNECT.CFG",
         "Teller.Out.Number.S Hearer.In.Number.O\nTeller.Out.Number.S Hearer.Late.Number.O\n");
  Start();
  Hear("assert");
  EXPECT_EQ(Answer("ready?"), "T any 1 ready 1 all 0\n");
  Hear("assert late");
  EXPECT_EQ(Answer("ready?"), "T any 2 ready 2 all 2\n");
}

// measured.md 1.17
TEST_F(ObjcommConformance, WithMaxFourPendingNotifiesAreOneEvent) {
  Data("HINIT.TXT", "0 1 4");
  Start();
  for (const char* command : {"send 1", "send 2", "send 3", "send 4"}) Tell(command);
  Hear("assert");
  EXPECT_EQ(Said(), "T ready 0 refs 0\nH in 1 2 3 4 (notifies 4 refs 1)\n");
}

// measured.md 1.18
TEST_F(ObjcommConformance, WithMinThreeARemainderStaysUnsent) {
  Data("HINIT.TXT", "0 3 6");
  Start();
  Hear("auto");
  Hear("assert");
  Said();
  for (const char* command : {"send 1", "send 2"}) Tell(command);
  EXPECT_EQ(Said(), "");
  for (const char* command : {"send 3", "send 4"}) Tell(command);
  EXPECT_EQ(Said(), "H in 1 2 3 (notifies 3 refs 1)\nT ready 1 refs 0\n");
}

// measured.md 1.19
TEST_F(ObjcommConformance, WithSkipOneEverySecondNotifyIsDropped) {
  Data("HINIT.TXT", "1 1 1");
  Start();
  Hear("auto");
  Hear("assert");
  Said();
  for (const char* command : {"send 1", "send 2", "send 3", "send 4", "send 5"}) Tell(command);
  EXPECT_EQ(Said(),
            "H in 2 (notifies 1 refs 1)\nT ready 1 refs 0\n"
            "H in 4 (notifies 1 refs 1)\nT ready 1 refs 0\n");
}

// measured.md 1.20
TEST_F(ObjcommConformance, BufferAndUnitSizesAreAcceptedInDoInitOnly) {
  Data("TINIT.TXT", "buffer 30\nunit 3\n");
  ASSERT_TRUE(Load());
  Boot();
  EXPECT_NE(Said().find("T buffer 0\nT unit 0\n"), std::string::npos);
  EXPECT_EQ(Answer("unit 2"), "T unit 2\n");  // oFAIL
  EXPECT_TRUE(Found("SetNotifyUnitSize() after a connection is refused"));
  Hear("assert");
  Said();
  for (int i = 1; i <= 7; ++i) Tell(fmt::format("set {}", i));
  Tell("notify");
  EXPECT_EQ(Said(), "T notify 0\nH in 1 2 3 4 5 6 7 (notifies 1 refs 1)\n");
}

// measured.md 1.21
TEST_F(ObjcommConformance, SetDataAddsAReferencePerObserverAndNotifyNone) {
  Config("CONNECT.CFG",
         "Teller.Out.Number.S Hearer.In.Number.O\nTeller.Out.Number.S Hearer.Late.Number.O\n");
  Start();
  EXPECT_EQ(Answer("region"), "T refs 1\n");
  EXPECT_EQ(Answer("setregion 5"), "T refs 3\n");
  EXPECT_EQ(Answer("notify"), "T notify 0\n");
  EXPECT_EQ(Answer("refs"), "T refs 3\n");
}

// measured.md 1.22
TEST_F(ObjcommConformance, AReplacedPendingRegionIsReleasedAtOnce) {
  Start();
  for (const char* command : {"region", "setregion 5", "notify"}) Tell(command);
  EXPECT_EQ(Answer("refs"), "T refs 2\n");
  Tell("send 6");
  EXPECT_EQ(Answer("refs"), "T refs 1\n");
}

// measured.md 1.23
TEST_F(ObjcommConformance, ADeliveredRegionIsReleasedByTheNextReadyBeforeTheCallback) {
  Start();
  Hear("assert");
  for (const char* command : {"region", "setregion 5", "notify"}) Tell(command);
  EXPECT_EQ(Answer("refs"), "T refs 2\n");  // though the Notify method has returned
  Hear("assert");
  EXPECT_EQ(Said(), "T ready 1 refs 1\n");
}

// measured.md 1.24; core.md 2.7
TEST_F(ObjcommConformance, AnObserverKeepsARegionWithAReferenceOfItsOwn) {
  Start();
  Hear("keep");
  Hear("assert");
  for (const char* command : {"region", "setregion 5", "notify"}) Tell(command);
  Hear("assert");
  EXPECT_EQ(Answer("refs"), "T refs 2\n");
  Hear("kept?");
  EXPECT_EQ(Said(), "H kept 5\n");
  Hear("let go");
  Hear("assert");
  EXPECT_EQ(Answer("refs"), "T refs 1\n");
}

// core.md 1.6; field-notes.md, 2.3: ready without end
TEST_F(ObjcommConformance, TheThirtyThirdWaitingMessageIsRefusedWithError13WhenStrict) {
  Start({.strict = true});
  for (int i = 0; i < 33; ++i) Post("hearer", "Command", "nothing");
  EXPECT_EQ(Post("hearer", "Command", "nothing"), sFULLMSGQENTRY);
  EXPECT_TRUE(Found("Exceed max size of queue: queueSize=32")) << Findings();
}

// field-notes.md, 2.3: the readies wait while the subject's object waits for a typed line
TEST_F(ObjcommConformance, TheThirtyThirdWaitingReadyIsRefusedWithError13WhenStrict) {
  Start({.strict = true});
  EXPECT_EQ(Answer("gets"), "");
  for (int i = 0; i < 32; ++i) Hear("assert");
  EXPECT_EQ(Said(), "");
  EXPECT_FALSE(Found("Exceed max size of queue")) << Findings();
  Hear("assert");
  EXPECT_EQ(Said(),
            "OObserver(Hearer.In.Number.O)::SendReady() Sending Ready failed. sError = 13\n");
  EXPECT_TRUE(Found("Exceed max size of queue: queueSize=32")) << Findings();
}

// field-notes.md, 2.3
TEST_F(ObjcommConformance, AssertingAgainAndAgainIsReported) {
  Start();
  for (int i = 0; i < 12; ++i) Hear("assert");
  EXPECT_TRUE(Found("Hearer.In.Number.O: asserts ready to teller again and again (9 times)"))
      << Findings();
}

}  // namespace
}  // namespace openr_host
