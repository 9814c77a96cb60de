// Faults are inputs: a recording of a run with faults replays without difference.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "openr/inspect/recorder.h"
#include "openr/inspect/replayer.h"
#include "openr/simulation/simulation.h"
#include "runtime/core/system.h"
#include "virtualrobot/virtual_robot.h"

namespace openr_host {
namespace {

struct TimedInput {
  int64_t time_us;
  const char* line;
};

// Runs the default stick with these inputs and records the run in `file`.  Inputs of time 0 come
// before the boot.  Returns the hash of its last state.
uint64_t RecordFaults(const std::string& file, const std::vector<TimedInput>& inputs) {
  SimulationOptions options;
  options.body = "ode";
  options.host_network = false;
  options.console = [](std::string_view) {};
  Recorder recorder(file, true);
  recorder.RecordNetworks(&options);
  Simulation simulation(options);
  recorder.Begin(&simulation, options, simulation.stick());
  System& system = simulation.system();
  system.Boot();
  for (const auto& [time_us, line] : inputs) {
    if (time_us > 0) system.RunUntil(time_us);
    EXPECT_EQ(system.inputs().Add(0, line), "");
  }
  system.RunUntil(4'000'000);
  EXPECT_EQ(recorder.Finish(&system), "");
  return system.state_hash();
}

class FaultReplayTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = (std::filesystem::temp_directory_path() / "openr-faults-XXXXXX").string();
    ASSERT_NE(mkdtemp(folder_.data()), nullptr);
    file_ = folder_ + "/run.rec";
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  void ExpectSameReplay() const {
    Replayer replayer({.file = file_, .stick = "", .console = [](std::string_view) {}});
    replayer.RunUntil(INT64_MAX);
    EXPECT_EQ(replayer.difference(), "");
    EXPECT_TRUE(replayer.at_end());
    EXPECT_TRUE(replayer.problems().empty());
  }
  std::string folder_, file_;
};

TEST_F(FaultReplayTest, EveryKindOfFaultReplaysWithoutDifference) {
  const uint64_t healthy = RecordFaults(file_, {});
  const uint64_t faulty = RecordFaults(file_, {{500'000, "break RF_j2 jammed for 1s"},
                                               {600'000, "break LF_j1 weak 20%"},
                                               {700'000, "break LH_j1 unpowered for 300ms"},
                                               {800'000, "break neck_pan noisy 3%"},
                                               {900'000, "break neck_tilt stuck for 500ms"},
                                               {1'000'000, "break tail_pan dead"},
                                               {1'100'000, "break acceleration noisy 10%"},
                                               {1'200'000, "break distance stuck for 1s"},
                                               {1'300'000, "break chin dead"},
                                               {1'400'000, "heat body 44 for 1s"},
                                               {1'500'000, "heat battery 50"},
                                               {1'600'000, "draw 2000 for 1s"},
                                               {1'700'000, "turn mouth -20 for 800ms"},
                                               {3'000'000, "repair all"}});
  EXPECT_NE(healthy, faulty);
  ExpectSameReplay();
}

// RCServer and Controller cannot open the last sensor, so their DoInit returns another status.
TEST_F(FaultReplayTest, APartThatIsMissingBeforeTheBootIsMissingInTheReplay) {
  const uint64_t healthy = RecordFaults(file_, {});
  const uint64_t faulty = RecordFaults(file_, {{0, "break acceleration_z missing"}});
  EXPECT_NE(healthy, faulty);
  ExpectSameReplay();
}

TEST_F(FaultReplayTest, ARepairOfTimeZeroEndsTheFaultsBeforeIt) {
  const uint64_t healthy = RecordFaults(file_, {});
  const uint64_t repaired = RecordFaults(
      file_, {{0, "break acceleration_z missing"}, {0, "break LF_j1 weak 20%"}, {0, "repair all"}});
  EXPECT_EQ(healthy, repaired);
  ExpectSameReplay();
}

}  // namespace
}  // namespace openr_host
