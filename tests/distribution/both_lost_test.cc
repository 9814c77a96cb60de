// Two external workers that are lost at the same time; two runs of one name.
#include <gmock/gmock.h>
#include <signal.h>
#include <unistd.h>

#include "distribution/name_claim.h"
#include "tests/distribution/hosts.h"
#include "tests/distribution/sticks.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

class BothLostTest : public testing::Test {
 protected:
  BothLostTest() {
    folder_.Write("where.cfg",
                  "Controller brain\nRCServer net\n@brain 127.0.0.1\n@net 127.0.0.1\n");
  }
  std::unique_ptr<ProgramRun> Join(const std::string& process) const {
    return std::make_unique<ProgramRun>(
        Words{"join", "--process", process, "--run-name", name_, "--wait", "10min"});
  }

  const ScratchFolder folder_;
  const std::string name_ = RunName("both");
};

// In lockstep the master waits for both workers at the same time, so the two attempts that "brain"
// needs cost "net" none.
TEST_F(BothLostTest, AWorkerThatReturnsFirstKeepsItsRestarts) {
  const auto brain = Join("brain"), net = Join("net");
  ProgramRun run({"run", "--no-panel", "--rc-port", "0", "--body", "ideal", "--rate", "1",
                  "--placement", folder_.File("where.cfg"), "--run-name", name_, "--restart", "2",
                  "--join-wait", "5s"});
  ASSERT_TRUE(run.WaitFor("state: listening")) << run.heard();
  brain->Signal(SIGKILL);
  net->Signal(SIGKILL);
  const auto second_net = Join("net");
  ASSERT_TRUE(run.WaitFor("process 'brain' did not come back within 5 s")) << run.heard();
  const auto second_brain = Join("brain");
  EXPECT_TRUE(run.WaitFor("process 'brain' is back")) << run.heard();
  EXPECT_TRUE(run.WaitFor("process 'net' is back")) << run.heard();
  run.Signal(SIGINT);
  EXPECT_EQ(run.Finish().status, 1);  // for the two losses
  EXPECT_THAT(run.heard(), Not(HasSubstr("process 'net' did not come back")));
  EXPECT_EQ(second_brain->Finish().status, 0) << second_brain->heard();
  EXPECT_EQ(second_net->Finish().status, 0) << second_net->heard();
}

// The claim of a run whose worker has joined beats an earlier claim.
TEST_F(BothLostTest, ARunThatHasBegunKeepsItsName) {
  ProgramRun earlier_run({"run", "--no-panel", "--rc-port", "0", "--body", "ideal", "--placement",
                          folder_.File("where.cfg"), "--run-name", name_});
  ASSERT_TRUE(earlier_run.WaitFor("waiting for process"));
  BusOptions options;
  options.run = name_;
  Bus bus(options);
  NameClaim claim(&bus);
  for (int ms = 0; claim.EarlierRun().empty() && ms < 60'000; ++ms) usleep(1000);
  ASSERT_THAT(claim.EarlierRun(), HasSubstr("pid " + std::to_string(earlier_run.pid())));
  earlier_run.Signal(SIGSTOP);  // stopped, or it would notice and end before the next check
  claim.MakePermanent();
  EXPECT_EQ(claim.EarlierRun(), "");
  earlier_run.Signal(SIGCONT);
  EXPECT_EQ(earlier_run.Finish().status, 1);
  EXPECT_THAT(earlier_run.heard(), HasSubstr("there is a run of the name '" + name_ + "' already"));
}

}  // namespace
}  // namespace openr_host
