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

// Runs the default stick with these inputs and records the run in `file`.  Returns the hash of its
// last state.
uint64_t RecordFaults(const std::string& file, const std::vector<TimedInput>& inputs) {
  SimulationOptions options;
  options.body = "ode";
  options.host_network = false;
  options.console = [](std::string_view) {};
  Recorder recorder(file, true);
  recorder.Listen(&options);
  Simulation simulation(options);
  recorder.Begin(&simulation, options, simulation.stick());
  System& system = simulation.system();
  system.Boot();
  for (const auto& [time_us, line] : inputs) {
    system.RunUntil(time_us);
    EXPECT_EQ(system.inputs().Add(0, line), "");
  }
  system.RunUntil(4'000'000);
  EXPECT_EQ(recorder.Finish(&system), "");
  return system.state_hash();
}

TEST(FaultReplayTest, EveryKindOfFaultReplaysWithoutDifference) {
  std::string name = (std::filesystem::temp_directory_path() / "openr-faults-XXXXXX").string();
  ASSERT_NE(mkdtemp(name.data()), nullptr);
  const std::string file = name + "/run.rec";
  const uint64_t healthy = RecordFaults(file, {});
  const uint64_t faulty = RecordFaults(file, {{500'000, "break RF_j2 jammed for 1s"},
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
  Replayer replayer({.file = file, .stick = "", .console = [](std::string_view) {}});
  replayer.RunUntil(INT64_MAX);
  EXPECT_EQ(replayer.difference(), "");
  EXPECT_TRUE(replayer.at_end());
  EXPECT_TRUE(replayer.problems().empty());
  std::filesystem::remove_all(name);
}

}  // namespace
}  // namespace openr_host
