#include <gmock/gmock.h>
#include <signal.h>

#include <string>
#include <vector>

#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

using ::testing::ContainsRegex;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(StickLockTest, ASecondRunOnTheSameStickIsNoted) {
  const ScratchFolder stick;
  stick.MakeTrouble("nothing");
  std::vector<std::string> words{"run",    "--rate", "0.01",    "--rc-port",  "0",
                                 "--body", "ideal",  "--stick", stick.path(), "--no-panel"};
  ProgramRun first(words);
  ASSERT_TRUE(first.WaitFor("is running"));
  words[2] = "max";
  words.insert(words.end(), {"--for", "100ms"});
  EXPECT_THAT(RunProgram(words).err,
              ContainsRegex("openr: note: process [0-9]+ \\(openr\\) runs on the stick .*, too"));
  first.Signal(SIGTERM);
  first.Finish();
  EXPECT_THAT(RunProgram(words).err, Not(HasSubstr("runs on the stick")));
}

}  // namespace
}  // namespace openr_host
