// openr join by hand: on this host, and on two hosts that see each other over one cable.
#include <gmock/gmock.h>

#include "tests/distribution/same_run.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;

const Words kFlags = {"--for", "5s", "--body", "ideal"};

// "name-1234": no two runs of one machine disturb each other.
std::string RunName(const std::string& name) { return name + "-" + std::to_string(getpid()); }

class JoinTest : public testing::Test {
 protected:
  // Where the body is moved and where it is told to.
  std::string PlacementWithHost(const std::string& address) {
    folder.Write("where.cfg", "Controller vision\nJointMover legs\n@vision " + address + "\n");
    return folder.File("where.cfg");
  }
  const ScratchFolder folder;
};

TEST_F(JoinTest, ByHandOnThisHost) {
  const RecordedRun one = Record(kFlags);
  const std::string name = RunName("hand");
  ProgramRun join({"join", "--process", "vision", "--run-name", name});
  ExpectSame(one, Record(kFlags +
                         Words{"--placement", PlacementWithHost("127.0.0.1"), "--run-name", name}));
  EXPECT_EQ(join.Finish().status, 0) << join.heard();
}

TEST_F(JoinTest, WhoComesFirstDoesNotMatter) {
  const std::string name = RunName("late");
  const RecordedRun one = Record(kFlags);
  const std::string recording = folder.File("r");
  ProgramRun run(kQuickly + kFlags +
                 Words{"--placement", PlacementWithHost("127.0.0.1"), "--run-name", name,
                       "--record", recording});
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

// ---- two network namespaces stand for two hosts

int Do(const std::string& command) { return std::system((command + " 2>/dev/null").c_str()); }

class HostsTest : public JoinTest {
 protected:
  HostsTest() : here(RunName("openr-a")), there(RunName("openr-b")) {}

  // False when this machine does not let us.
  bool Connect() {
    if (Do("ip netns add " + here) != 0 || Do("ip netns add " + there) != 0) return false;
    const std::string in_here = "ip -n " + here, in_there = "ip -n " + there;
    return Do("ip link add cable netns " + here + " type veth peer name cable netns " + there) ==
               0 &&
           Do(in_here + " addr add 10.77.0.1/24 dev cable") == 0 &&
           Do(in_there + " addr add 10.77.0.2/24 dev cable") == 0 &&
           Do(in_here + " link set cable up && " + in_here + " link set lo up") == 0 &&
           Do(in_there + " link set cable up && " + in_there + " link set lo up") == 0;
  }
  ~HostsTest() override {
    Do("ip netns del " + here);
    Do("ip netns del " + there);
  }

  static std::unique_ptr<ProgramRun> StartIn(const std::string& host, const Words& arguments) {
    return std::make_unique<ProgramRun>(
        Words{"-c", "exec ip netns exec \"$0\" \"$@\"", host, OPENR_PROGRAM} + arguments,
        "/bin/sh");
  }

  const std::string here, there;
};

TEST_F(HostsTest, TwoHostsAreOneRun) {
  if (!Connect()) GTEST_SKIP() << "network namespaces: iproute2 and the right to make them";
  const RecordedRun one = Record(kFlags);
  const std::string name = RunName("hosts");
  const std::unique_ptr<ProgramRun> join =
      StartIn(there, {"join", "--process", "vision", "--run-name", name, "--dds-address",
                      "10.77.0.2", "--dds-peer", "10.77.0.1"});
  const std::unique_ptr<ProgramRun> run =
      StartIn(here, kQuickly + kFlags +
                        Words{"--placement", PlacementWithHost("10.77.0.2"), "--run-name", name,
                              "--dds-address", "10.77.0.1", "--record", folder.File("r")});
  const ProgramResult& result = run->Finish();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(join->Finish().status, 0) << join->heard();
  EXPECT_EQ(folder.Read("r"), one.recording);
  const json report = json::parse(result.out, nullptr, false);
  ASSERT_TRUE(report.is_object());
  EXPECT_EQ(report["state_hash"], one.report["state_hash"]);
}

// The cable is cut in the middle of the run.
TEST_F(HostsTest, AHostThatIsGoneIsNamed) {
  if (!Connect()) GTEST_SKIP() << "network namespaces: iproute2 and the right to make them";
  const std::string name = RunName("cut");
  const std::unique_ptr<ProgramRun> join =
      StartIn(there, {"join", "--process", "vision", "--run-name", name, "--dds-address",
                      "10.77.0.2", "--dds-peer", "10.77.0.1"});
  const std::unique_ptr<ProgramRun> run =
      StartIn(here, {"run", "--for", "10min", "--body", "ideal", "--no-panel", "--rc-port", "0",
                     "--placement", PlacementWithHost("10.77.0.2"), "--run-name", name,
                     "--dds-address", "10.77.0.1"});
  ASSERT_TRUE(run->WaitFor("state: listening"));
  ASSERT_EQ(Do("ip -n " + here + " link set cable down"), 0);
  const ProgramResult& result = run->Finish();
  EXPECT_EQ(result.status, 1) << result.err;
  EXPECT_THAT(result.err, HasSubstr("process 'vision'"));
  EXPECT_THAT(result.err, HasSubstr("has not answered for 2 s"));
  EXPECT_THAT(result.err, HasSubstr("cannot be reached any more"));
  EXPECT_EQ(join->Finish().status, 1);
  EXPECT_THAT(join->heard(), HasSubstr("the master is gone"));
}

}  // namespace
}  // namespace openr_host
