// --wrap: an isolated object under a tool of the developer.
#include <gmock/gmock.h>

#include "tests/distribution/same_run.h"

namespace openr_host {
namespace {

TEST(WrapTest, UnderValgrindTheObjectDoesTheSame) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "no sanitizers under Valgrind";
#endif
  if (std::system("valgrind --version > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "valgrind is not installed";
  const Words flags = {"--for", "2s", "--body", "ideal"};
  const RecordedRun one = Record(flags);
  ExpectSame(one,
             Record(flags + Isolated({"JointMover"}) +
                    Words{"--handler-limit", "0s", "--wrap", "valgrind -q --error-exitcode=9"}));
}

TEST(WrapTest, AToolThatIsNotThereIsNamed) {
  const ProgramResult result = RunProgram(
      kQuickly + Words{"--for", "1s", "--isolate", "JointMover", "--wrap", "no-such-tool -q"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, ::testing::HasSubstr("no-such-tool"));
}

}  // namespace
}  // namespace openr_host
