// core.md section 1 and measured.md section 1, "Life cycle and wiring".
#include "tests/conformance/conform_fixture.h"

namespace openr_host {
namespace {

class LifeConformance : public ConformTest {};

// measured.md 1.1, core.md 1.5
TEST_F(LifeConformance, InitOfAllThenConnectionsThenStartOfAllInFileOrder) {
  Config("CONNECT.CFG",
         "Teller.Out.Number.S Hearer.In.Number.O\nTeller.Loop.Number.S Teller.Loop.Number.O\n");
  ASSERT_TRUE(Load()) << Findings();
  Boot();
  EXPECT_EQ(Said(),
            "T made with an id\n"
            "T init 0\n"
            "H init\n"
            "T connect 1 to Teller.Loop.Number.S\n"
            "T control add from Teller.Loop.Number.O\n"
            "T start\n"
            "H start\n");
}

// measured.md 1.2
TEST_F(LifeConformance, MessagesFlowBeforeALaterObjectsDoStart) {
  Config("OBJECT.CFG", "/MS/OPEN-R/MW/OBJS/TELLER.BIN\n/MS/OPEN-R/MW/OBJS/HEARER.BIN\n");
  Config("CONNECT.CFG", "Teller.Loop.Number.S Teller.Loop.Number.O\n");
  Data("TSTART.TXT", "loop 5\n");
  ASSERT_TRUE(Load());
  Boot();
  const std::string said = Said();
  EXPECT_LT(said.find("T heard itself: 5"), said.find("H start")) << said;
}

// measured.md 1.3
TEST_F(LifeConformance, AnUnknownServiceIsNotFoundAndTheOtherLinesHold) {
  Config("CONNECT.CFG",
         "Teller.Aut.Number.S Hearer.In.Number.O\nTeller.Out.Number.S Hearer.In.Number.O\n");
  Start();
  EXPECT_TRUE(Found("CONNECT.CFG:1: OServiceManager::Connect() : Teller.Aut.Number.S NOT FOUND"))
      << Findings();
  Hear("assert");
  Tell("send 3");
  EXPECT_NE(Said().find("H in 3"), std::string::npos);
}

// measured.md 1.4
TEST_F(LifeConformance, ALineWhoseDataTypesDifferIsSkippedWithItsNumber) {
  Config("CONNECT.CFG",
         "Teller.Out.Number.S Hearer.In.Text.O\nTeller.Out.Number.S Hearer.In.Number.O\n");
  Start();
  EXPECT_TRUE(Found("CONNECT.CFG:1: subject sends 'Number', observer expects 'Text'"))
      << Findings();
  Hear("assert");
  Tell("send 3");
  EXPECT_NE(Said().find("H in 3"), std::string::npos);
}

// measured.md 1.4: "or whose data type is not the registered one"
TEST_F(LifeConformance, ALineWithDataThatWereNotRegisteredIsASyntaxError) {
  Config("CONNECT.CFG",
         "Teller.Out.Text.S Hearer.In.Text.O\nTeller.Out.Number.S Hearer.In.Number.O\n");
  Start();
  EXPECT_TRUE(Found("CONNECT.CFG:1: OServiceManager::Connect() : Teller.Out.Text.S NOT FOUND"));
  EXPECT_TRUE(
      Found("syntax error, the object registered it with data 'Number', not 'Text'; the "
            "line is skipped"))
      << Findings();
  Hear("assert");
  Tell("send 3");
  EXPECT_NE(Said().find("H in 3"), std::string::npos);
}

// core.md 1.5, step 7; 10.1 17
TEST_F(LifeConformance, ShutdownStopsAllThenDestroysAll) {
  Start();
  system->Shutdown(0);
  Settle();
  EXPECT_EQ(Said(), "T battery 1\nT stop 1\nH stop\nT deassert\nT destroy\nH destroy\n");
  EXPECT_TRUE(system->powered_off());
}

// core.md 1.4, inferred there
TEST_F(LifeConformance, TheParameterOfASystemEventIsTheStickOrTheBattery) {
  stick->set_writable(false);
  Start();
  EXPECT_EQ(Answer("stick?"), "T booted with stick 1\n");
  system->Shutdown(0);
  Settle();
  EXPECT_EQ(Said().substr(0, 12), "T battery 1\n");
}

// core.md 11 1: our choice
TEST_F(LifeConformance, ADoStartThatFailsIsReportedAndTheRunGoesOn) {
  Data("TSTART.TXT", "fail\n");
  Start();
  EXPECT_TRUE(Found("DoStart returned status 2; the robot's answer to that is not known"))
      << Findings();
  EXPECT_EQ(Answer("notify"), "T notify 0\n");
}

// core.md 6.1; field-notes.md, 1.10
TEST_F(LifeConformance, FatalPowersOffWithoutDoStop) {
  Start();
  EXPECT_EQ(Answer("fatal"), "T lives for the rest of the method\n");
  EXPECT_TRUE(system->powered_off());
  system->RunFor(1'000'000);
  EXPECT_EQ(Said(), "");
  EXPECT_TRUE(Found("OPENR::Fatal(0): the robot powers off at once, without DoStop"));
}

// core.md 10.1 22
TEST_F(LifeConformance, AnObjectMayBeConnectedToItself) {
  Config("CONNECT.CFG", "Teller.Loop.Number.S Teller.Loop.Number.O\n");
  Start();
  EXPECT_EQ(Answer("loop 8"), "T heard itself: 8\n");
  EXPECT_EQ(Findings(), "");
}

// core.md 1.2, 10.2 "services registered twice"
TEST_F(LifeConformance, ARegisteredServiceIsRefusedTheSecondTime) {
  Start();
  EXPECT_EQ(Answer("register again"), "T registered 7\n");  // oALREADY_EXIST
}

// core.md 1.5, step 2; 10.1 14
TEST_F(LifeConformance, AMissingImageStopsTheBoot) {
  Config("OBJECT.CFG", "/MS/OPEN-R/MW/OBJS/TELLER.BIN\n/MS/OPEN-R/MW/OBJS/MISSING.BIN\n");
  EXPECT_FALSE(Load());
  EXPECT_TRUE(Found("OBJECT.CFG:2: /MS/OPEN-R/MW/OBJS/MISSING.BIN does not exist")) << Findings();
  EXPECT_TRUE(Found("error 90"));
}

// core.md 8.1: exit(), abort() and atexit()
TEST_F(LifeConformance, ExitAndAbortEndTheMethodAtexitDoesNothing) {
  Start();
  EXPECT_EQ(Answer("atexit"), "T atexit 0\n");
  for (const char* const word : {"exit", "_exit", "_Exit", "quick_exit", "pthread_exit"})
    EXPECT_EQ(Answer(word), "");
  EXPECT_EQ(Answer("abort"), "abort() called\n");
  EXPECT_NE(Answer("assert 0").find("assertion \"command.empty()\" failed"), std::string::npos);
  EXPECT_EQ(Answer("notify"), "T notify 0\n");
}

// field-notes.md, 1.2: the story of DoStart that waits
TEST_F(LifeConformance, ADoStartThatDoesNotReturnIsReportedWithError28) {
  Data("TSTART.TXT", "gets\n");  // nobody types
  ASSERT_TRUE(Load());
  system->Boot();
  system->RunFor(11'000'000);
  EXPECT_TRUE(
      Found("DoStart did not return within 10 s: OObjectRegistry::SendWithRBoxObjects() : "
            "Receive() oid 80000043 selector 1 error 28"))
      << Findings();
  EXPECT_NE(Said().find("H start"), std::string::npos);
}

// field-notes.md, 1.2: "the same object later reports the same for selector 2"; 17.  The robot
// goes on, with --strict as without.
TEST_F(LifeConformance, ADoStopThatDoesNotReturnIsReportedAndThePowerStillGoes) {
  for (const bool is_strict : {false, true}) {
    SCOPED_TRACE(is_strict);
    Data("TSTOP.TXT", "gets\n");
    Start({.strict = is_strict});
    system->Shutdown(0);
    system->RunFor(25'000'000);
    EXPECT_TRUE(
        Found("DoStop did not return within 10 s: OObjectRegistry::SendWithRBoxObjects() : "
              "Receive() oid 80000043 selector 2 error 28"))
        << Findings();
    EXPECT_TRUE(system->powered_off());
  }
}

}  // namespace
}  // namespace openr_host
