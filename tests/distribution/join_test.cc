// openr join on this host; hosts_test.cc tests two hosts.
#include "tests/distribution/hosts.h"
#include "tests/distribution/same_run.h"
#include "tests/distribution/wait_until.h"

namespace openr_host {
namespace {

const Words kFlags = {"--for", "5s", "--body", "ideal"};

class JoinTest : public testing::Test {
 protected:
  // Places JointMover, which moves the body, and Controller, which commands it, in workers.
  std::string PlacementWithHost(const std::string& address) {
    folder.Write("where.cfg", "Controller vision\nJointMover legs\n@vision " + address + "\n");
    return folder.File("where.cfg");
  }
  const ScratchFolder folder;
};

TEST_F(JoinTest, AWorkerThatIsStartedFirstWaitsForTheRun) {
  const RecordedRun one = Record(kFlags);
  const std::string name = RunName("hand");
  ProgramRun join({"join", "--process", "vision", "--run-name", name});
  const std::string threads = "/proc/" + std::to_string(join.pid()) + "/task";
  WaitUntil("its DDS", [&] {  // DDS creates threads
    return std::distance(std::filesystem::directory_iterator(threads), {}) > 3;
  });
  ExpectSame(one, Record(kFlags +
                         Words{"--placement", PlacementWithHost("127.0.0.1"), "--run-name", name}));
  EXPECT_EQ(join.Finish().status, 0) << join.heard();
}

TEST_F(JoinTest, TheRunWaitsForALateWorker) {
  const std::string name = RunName("late");
  const RecordedRun one = Record(kFlags);
  const std::string recording = folder.File("r");
  ProgramRun run(kQuickly + kFlags +
                 Words{"--placement", PlacementWithHost("127.0.0.1"), "--run-name", name,
                       "--record", recording});
  ASSERT_TRUE(run.WaitFor("waiting for process 'vision'")) << run.heard();
  ProgramRun join({"join", "--process", "vision", "--run-name", name});
  EXPECT_EQ(run.Finish().status, 0) << run.heard();
  EXPECT_EQ(join.Finish().status, 0) << join.heard();
  EXPECT_EQ(folder.Read("r"), one.recording);
}

TEST_F(JoinTest, WithACopyOfTheStickElsewhere) {
  const std::string name = RunName("copy");
  std::filesystem::copy(OPENR_STICK, folder.File("copy"), std::filesystem::copy_options::recursive);
  const RecordedRun one = Record(kFlags);
  ProgramRun join(
      {"join", "--process", "vision", "--run-name", name, "--stick", folder.File("copy")});
  ExpectSame(one, Record(kFlags +
                         Words{"--placement", PlacementWithHost("127.0.0.1"), "--run-name", name}));
  EXPECT_EQ(join.Finish().status, 0) << join.heard();
}

TEST_F(JoinTest, RunsOfDifferentNamesDoNotHearEachOther) {
  ProgramRun other(Words{"run", "--no-panel", "--rc-port", "0", "--body", "ideal", "--for", "10min",
                         "--run-name", RunName("one"), "--isolate", "Controller"});
  ASSERT_TRUE(other.WaitFor("state: listening"));
  const RecordedRun one = Record(kFlags);
  ExpectSame(one, Record(kFlags + Words{"--run-name", RunName("two")} + Isolated({"Controller"})));
  other.Signal(SIGINT);
  EXPECT_EQ(other.Finish().status, 0) << other.heard();
}

}  // namespace
}  // namespace openr_host
