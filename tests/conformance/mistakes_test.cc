// Classic mistakes of field-notes.md that no other file here tells: the story, and what the
// developer is told.
#include <gmock/gmock.h>

#include "runtime/core/stalls.h"
#include "tests/conformance/conform_fixture.h"

namespace openr_host {
namespace {

class MistakesConformance : public ConformTest {};

// 2.2: the observer never asserts ready, and both sides fall silent
TEST_F(MistakesConformance, AnObserverThatNeverAssertsIsNamed) {
  Start();
  Tell("send 1");
  system->RunFor(2'000'000);
  EXPECT_THAT(DescribeWaits(*system),
              testing::ElementsAre(testing::StartsWith("teller waits for ready of hearer")));
}

// 2.5: two notifies in a row
TEST_F(MistakesConformance, DataReplacedBeforeTheObserverWasReadyAreReported) {
  Start();
  Tell("send 1");
  EXPECT_EQ(Findings(), "");
  Tell("send 2");
  EXPECT_TRUE(Found("data hearer was not ready for were replaced by newer ones")) << Findings();
}

// 2.11: the pointer of Data() is kept beyond AssertReady
TEST_F(MistakesConformance, DataReadAfterAssertReadyCrashInTheCheckingMode) {
  Start({.guard_regions = true});
  Hear("remember");
  Hear("auto");
  Hear("assert");
  Tell("send 7");
  EXPECT_DEATH(Hear("peek"), "");
}

// 3.1: writing to what was received
TEST_F(MistakesConformance, WritingToReceivedDataCrashesInTheCheckingMode) {
  Start({.guard_regions = true});
  Hear("remember");
  Hear("assert");
  Tell("send 7");
  Hear("peek");
  EXPECT_NE(Said().find("H peeks 7\n"), std::string::npos);
  EXPECT_DEATH(Hear("poke"), "");
}

// 3.1: writing to what was received, as on a robot with memory protection
TEST_F(MistakesConformance, StrictlyWritingToReceivedDataCrashes) {
  Start({.strict = true});
  Hear("remember");
  Hear("assert");
  Tell("send 7");
  EXPECT_DEATH(Hear("poke"), "");
}

// 2.11: reading them later is a mistake that no robot stops
TEST_F(MistakesConformance, StrictlyDataReadAfterAssertReadyAreNoFault) {
  Start({.strict = true});
  Hear("remember");
  Hear("auto");
  Hear("assert");
  Tell("send 7");
  Hear("peek");
  EXPECT_NE(Said().find("H peeks 7\n"), std::string::npos);
  EXPECT_EQ(Findings(), "");
}

// 3.3 and core.md 10.1, 6: a region in flight is written
TEST_F(MistakesConformance, ARegionChangedInFlightIsReportedInTheCheckingMode) {
  Start({.guard_regions = true});
  Hear("assert");
  Tell("region");
  Tell("hurry 1 2");
  EXPECT_TRUE(Found("data were changed on their way to hearer")) << Findings();
  EXPECT_NE(Said().find("H in 2 "), std::string::npos);
}

// 3.4: a region for every command
TEST_F(MistakesConformance, RegionsWithoutEndAreReportedWhenThereAreNoMore) {
  Start();
  EXPECT_EQ(Answer("regions 65000"), "T all\n");
  EXPECT_EQ(Findings(), "");
  EXPECT_EQ(Answer("regions 1000"), "T no more\n");
  EXPECT_TRUE(Found("no shared memory for 4 bytes: 65535 regions are alive")) << Findings();
}

// 1.6: names are not registered
TEST_F(MistakesConformance, AnObjectThatIsNotInObjectCfgIsNotFound) {
  Config("OBJECT.CFG", "/MS/OPEN-R/MW/OBJS/TELLER.BIN\n");
  ASSERT_TRUE(Load());
  Boot();
  EXPECT_TRUE(
      Found("CONNECT.CFG:1: OServiceManager::Connect() : Hearer.In.Number.O NOT FOUND: no "
            "object registered it in DoInit (REGISTER_ALL_ENTRY missing, or the object is "
            "not in OBJECT.CFG)"))
      << Findings();
}

// 1.13 and core.md 1.1
TEST_F(MistakesConformance, TwoObjectsOfOneNameAreRefused) {
  std::filesystem::copy_file(root / "OPEN-R/MW/OBJS/TELLER.BIN", root / "OPEN-R/MW/OBJS/OTHER.BIN");
  Config("OBJECT.CFG", "/MS/OPEN-R/MW/OBJS/TELLER.BIN\n/MS/OPEN-R/MW/OBJS/OTHER.BIN\n");
  EXPECT_FALSE(Load());
  EXPECT_TRUE(Found("OBJECT.CFG:2: /MS/OPEN-R/MW/OBJS/OTHER.BIN is named 'teller' like another"))
      << Findings();
}

// 12.1: a busy loop on the clock
TEST_F(MistakesConformance, ABusyLoopOnTheClockEndsAndIsReported) {
  Start();
  EXPECT_EQ(Answer("wait 1100"), "T waited\n");
  EXPECT_TRUE(Found("1000000 calls of GetSystemTime() in one handler")) << Findings();
}

// --strict: wiring that does not hold stops the robot before any DoStart
TEST_F(MistakesConformance, StrictlyWrongWiringStopsTheBoot) {
  Config("CONNECT.CFG", "Teller.Aut.Number.S Hearer.In.Number.O\n");
  ASSERT_TRUE(Load({.strict = true}));
  Boot();
  EXPECT_TRUE(system->powered_off());
  EXPECT_EQ(Said().find("start"), std::string::npos);
}

}  // namespace
}  // namespace openr_host
