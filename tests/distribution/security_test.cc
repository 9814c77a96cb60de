// DDS Security: who has settings of the same authority takes part, others neither do nor hear.
#include <gmock/gmock.h>

#include <cstdlib>

#include "tests/distribution/same_run.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;

const Words kFlags = {"--for", "3s", "--body", "ideal"};

class SecurityTest : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* authority : {"ours", "theirs"}) {
      const std::string command = std::string(OPENR_DDS_SECURITY) + " " + folder.File(authority) +
                                  " alpha beta 2>" + folder.File("said");
      if (std::system(command.c_str()) != 0)
        GTEST_SKIP() << "settings cannot be made (openssl): " << folder.Read("said");
    }
    const ProgramResult result = RunProgram({"top", "--once", "--wait", "100ms", "--run-name", name,
                                             "--dds-config", Settings("ours/alpha")});
    if (result.err.find("Could not load") != std::string::npos)
      GTEST_SKIP() << "the plugins of Cyclone DDS are not installed: " << result.err;
    folder.Write("where.cfg", "Controller vision\nJointMover legs\n@vision 127.0.0.1\n");
  }
  std::string Settings(const std::string& of) const { return folder.File(of + ".xml"); }

  // JointMover in a process that is started, Controller in one that joins; "": without settings.
  void RunAndJoin(const std::string& joins_with, RecordedRun* run, ProgramResult* join) const {
    Words words = {"join", "--process", "vision", "--run-name", name, "--wait", "3s"};
    if (!joins_with.empty()) words = words + Words{"--dds-config", Settings(joins_with)};
    ProgramRun joining(words);
    *run = Record(kFlags + Words{"--placement", folder.File("where.cfg"), "--run-name", name,
                                 "--join-wait", "3s", "--dds-config", Settings("ours/alpha")});
    *join = joining.Finish();
  }

  const ScratchFolder folder;
  const std::string name = "secret-" + std::to_string(getpid());
};

TEST_F(SecurityTest, WhoIsOfOneAuthorityIsOneRun) {
  RecordedRun run;
  ProgramResult join;
  RunAndJoin("ours/beta", &run, &join);
  EXPECT_EQ(join.status, 0) << join.err;
  ExpectSame(Record(kFlags), run);
}

TEST_F(SecurityTest, OthersAreNotLetIn) {
  for (const char* settings : {"", "theirs/beta"}) {
    SCOPED_TRACE(settings);
    RecordedRun run;
    ProgramResult join;
    RunAndJoin(settings, &run, &join);
    EXPECT_EQ(run.status, 1);
    EXPECT_THAT(run.err, HasSubstr("process 'vision' did not come within 3 s"));
    EXPECT_EQ(join.status, 1);
    EXPECT_THAT(join.err, HasSubstr("no run '" + name + "'"));
  }
}

TEST_F(SecurityTest, OthersDoNotHear) {
  ProgramRun run(Words{"run", "--no-panel", "--rc-port", "0", "--body", "ideal", "--monitor",
                       "--run-name", name, "--dds-config", Settings("ours/alpha")});
  ASSERT_TRUE(run.WaitFor("state: listening"));
  const Words top = {"top", "--once", "--wait", "2s", "--run-name", name};
  EXPECT_EQ(RunProgram(top + Words{"--dds-config", Settings("ours/beta")}).status, 0);
  EXPECT_EQ(RunProgram(top + Words{"--dds-config", Settings("theirs/beta")}).status, 1);
  EXPECT_EQ(RunProgram(top).status, 1);
}

// Topics of ROS 2 are protected as well.
TEST_F(SecurityTest, Ros2IsAllowed) {
  const ProgramResult result =
      RunProgram(kQuickly + Words{"--for", "1s", "--body", "ideal", "--ros2", "--dds-config",
                                  Settings("ours/alpha")});
  EXPECT_EQ(result.status, 0) << result.err;
}

// Without the file a run would not be protected.
TEST(SettingsTest, AreAFileThatIsThere) {
  const ScratchFolder folder;
  for (const std::string& file : {folder.path(), folder.File("nothing.xml")}) {
    const ProgramResult result =
        RunProgram({"run", "--for", "1s", "--isolate", "JointMover", "--dds-config", file});
    EXPECT_EQ(result.status, 2) << result.err;
    EXPECT_THAT(result.err, HasSubstr("--dds-config: " + file + ": "));
  }
}

}  // namespace
}  // namespace openr_host
