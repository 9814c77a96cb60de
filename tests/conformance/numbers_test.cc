// field-notes.md 4.4, core.md 8.2: the robot's processor stops where this one goes on.
#include "tests/conformance/conform_fixture.h"

namespace openr_host {
namespace {

class NumbersConformance : public ConformTest {
 protected:
  void SetUp() override { Start(); }
  // Returns the findings about `command`, which must run to its end.
  std::string FindingsOf(const std::string& command) {
    EXPECT_EQ(Answer(command), "T computed\n");
    return Findings();
  }
};

TEST_F(NumbersConformance, OrdinaryNumbersAreNoFinding) { EXPECT_EQ(FindingsOf("fp fine"), ""); }

TEST_F(NumbersConformance, AnOperationWithoutAResultIsReportedWithItsHandler) {
  EXPECT_EQ(FindingsOf("fp nan"),
            "Command: a floating-point operation made NaN (0/0, sqrt(-1), inf - inf) or converted "
            "a number that its integer type does not hold; the robot stops when such a NaN is "
            "used, in isnan() and printf() too: exception 15, the robot powers off\n");
}

TEST_F(NumbersConformance, SoIsTheRootOfANegativeNumber) {
  EXPECT_NE(FindingsOf("fp sqrt").find("made NaN"), std::string::npos);
}

TEST_F(NumbersConformance, SoIsANumberTooLargeForItsIntegerType) {
  EXPECT_NE(FindingsOf("fp int").find("its integer type does not hold"), std::string::npos);
}

TEST_F(NumbersConformance, AnInfinityIsReported) {
  EXPECT_NE(FindingsOf("fp inf").find("made an infinity"), std::string::npos);
}

// Denormals of an object's own making are 0 on the robot.
TEST_F(NumbersConformance, ADenormalFromElsewhereIsReportedOneThatWasComputedIsNot) {
  EXPECT_EQ(FindingsOf("fp decay"), "");
  Start();
  EXPECT_NE(FindingsOf("fp denormal").find("a denormal number was used"), std::string::npos);
}

// A NaN that the object got as bytes.  This processor raises nothing when it is added.
TEST_F(NumbersConformance, ANaNFromElsewhereIsReportedWhereItIsComparedOrPrinted) {
  EXPECT_EQ(FindingsOf("fp foreign"), "");
#if !defined(__clang__)  // clang compares with an instruction that raises nothing
  EXPECT_NE(FindingsOf("fp compare").find("a floating-point operation made NaN"),
            std::string::npos);
  Start();
#endif
  EXPECT_NE(FindingsOf("fp whole").find("its integer type does not hold"), std::string::npos);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // sprintf() is theirs then
  Start();
  EXPECT_EQ(FindingsOf("fp print"),
            "Command: a NaN was printed: the robot stops when a NaN is used, in printf() too: "
            "exception 15, the robot powers off\n");
#endif
  Start();
  EXPECT_EQ(Answer("fp console"), "7 text nan\nT computed\n");
  EXPECT_NE(Findings().find("Command: a NaN was printed: the robot stops"), std::string::npos);
}

TEST_F(NumbersConformance, NumbersAndTheWordNanMayBePrinted) {
  EXPECT_EQ(FindingsOf("fp text"), "");
}

TEST_F(NumbersConformance, EachKindIsSaidOnceOfAnObject) {
  FindingsOf("fp nan");
  FindingsOf("fp inf");
  FindingsOf("fp nan");
  EXPECT_EQ(system->findings().all().size(), 2u);
  for (const Finding& finding : system->findings().all()) EXPECT_EQ(finding.count, 1u);
}

// Its flags are those of the processor: nobody inherits them.
TEST_F(NumbersConformance, OtherObjectsAreNotBlamed) {
  FindingsOf("fp nan");
  Tell("send 1");
  Hear("read");
  ASSERT_EQ(system->findings().all().size(), 1u);
  EXPECT_EQ(system->findings().all()[0].object, "teller");
}

}  // namespace
}  // namespace openr_host
