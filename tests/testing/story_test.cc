// Tests of the output of a test program when an object crashes it, or a test asks the impossible.
#include "Messages.h"
#include "tests/testing/doubler.h"

namespace openr::testing {
namespace {

using ::testing::AllOf;
using ::testing::ExitedWithCode;
using ::testing::Field;
using ::testing::HasSubstr;

#if !defined(__SANITIZE_ADDRESS__)  // AddressSanitizer's own report says more
void BootTrouble(const char* what) {
  Bench bench({.handler_limit = 200ms});
  bench.AddImage(OPENR_IMAGES "/TROUBLE.BIN");
  bench.stick().Write("/MS/OPEN-R/MW/DATA/P/TROUBLE.TXT", what);
  bench.Boot();
}

TEST(StoryTest, ACrashOfAnObjectEndsWithTheStory) {
  EXPECT_EXIT(BootTrouble("crash"), ExitedWithCode(1),
              AllOf(HasSubstr("EXCEPTION SIGSEGV"), HasSubstr("OBJECT Trouble, DoStart"),
                    HasSubstr("Last messages:"), HasSubstr("To see it again: OPENR_SEED=1 ")));
}

TEST(StoryTest, AHandlerWithoutEndIsEndedWithTheStory) {
  EXPECT_EXIT(BootTrouble("hang"), ExitedWithCode(1),
              AllOf(HasSubstr("a handler does not return: Trouble, DoStart"),
                    HasSubstr("To see it again: OPENR_SEED=1 ")));
}

void LoadTrouble(const char* what) {
  Bench bench({.handler_limit = 200ms});
  bench.stick().Write("/MS/OPEN-R/MW/DATA/P/TROUBLE.TXT", what);
  bench.AddImage(OPENR_IMAGES "/TROUBLE.BIN");
}

TEST(StoryTest, AConstructorThatEndsTheProcessIsNamedBeforeTheStory) {
  const std::pair<const char*, const char*> faults[] = {
      {"earlycrash", "EXCEPTION SIGSEGV"},
      {"earlyabort", "EXCEPTION a constructor of a global object has called abort()"},
      {"earlyexit", "EXCEPTION a constructor of a global object has called exit()"},
      {"earlyhang", "(BenchOptions::handler_limit)"}};
  for (const auto& [word, text] : faults) {
    EXPECT_EXIT(LoadTrouble(word), ExitedWithCode(1),
                AllOf(HasSubstr(text), HasSubstr("Trouble, constructors of its globals"),
                      HasSubstr("To see it again: OPENR_SEED=1 ")));
  }
}
#endif

TEST(StoryTest, ABenchThatIsOffCannotRun) {
  Bench bench;
  EXPECT_NONFATAL_FAILURE(bench.RunFor(1ms), "The robot is off: Boot() the bench first");
  EXPECT_NONFATAL_FAILURE(bench.Step(), "The robot is off: Boot() the bench first");
}

TEST(StoryTest, MessagesOfKnownTypesAreInWords) {
  Bench bench({.stick = DefaultStick(), .body = "ideal"});
  bench.Boot();
  ASSERT_TRUE(bench.StepTo(Notify("OVirtualRobotComm.Sensor", "RCServer.Sensor"), 1s));
  EXPECT_THAT(bench.Story(), HasSubstr("RCServer.Sensor notify, "));
  EXPECT_THAT(bench.Story(), HasSubstr("PRM:/r1/c1-Joint2:j1 "));
  MoverCommand command = {};
  command.kind = moverkindPOSITION;
  command.joint = 1;
  command.value = 523599;
  ASSERT_TRUE(bench.Inject(Notify("RCServer.Mover", "JointMover.Mover"), command));
  bench.Expect("RCServer.Mover", "JointMover.Mover",
               Data<MoverCommand>(Field(&MoverCommand::joint, 2)));
  ASSERT_TRUE(bench.StepTo("JointMover.Mover", 1s));
  EXPECT_NONFATAL_FAILURE(bench.Verify(),
                          "JointMover.Mover notify, 48 bytes: move neck_pan to 30.00 deg");
}

class RefusalTest : public DoublerTest {
 protected:
  RefusalTest() { BuildAndBoot(); }
};

TEST_F(RefusalTest, TimeDoesNotRunBackwards) {
  EXPECT_NONFATAL_FAILURE(bench().RunFor(-1ms), "time does not run backwards");
}

TEST_F(RefusalTest, NothingIsInjectedBetweenEndsThatAreNotConnected) {
  EXPECT_NONFATAL_FAILURE(
      bench().Inject(Notify("Doubler.Out", "Doubler.In"), 1),
      "Inject: Doubler.Out.int.S is not connected with Doubler.In.int.O (Notify)");
  EXPECT_NONFATAL_FAILURE(bench().Inject(Ready("Test2.Out", "Test1.In")), "is not connected with");
}

}  // namespace
}  // namespace openr::testing
