// Breakpoints of openr replay --step, in a replay of two robots.
#include "openr/inspect/breakpoints.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "openr/explore/quantity.h"
#include "openr/inspect/replayer.h"
#include "runtime/core/system.h"
#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

// Only the second robot has the object JointMover.
TEST(BreakpointsTest, AStateOfAnObjectOfTheSecondRobotStopsTheReplay) {
  const ScratchFolder folder;
  const std::string first = folder.File("first"), file = folder.File("two.rec");
  std::filesystem::copy(OPENR_STICK, first, std::filesystem::copy_options::recursive);
  folder.Write("first/OPEN-R/MW/CONF/OBJECT.CFG", "/MS/OPEN-R/MW/OBJS/POWERMON.BIN\n");
  folder.Write("first/OPEN-R/MW/CONF/CONNECT.CFG", "");
  RunProgram({"run", "--no-panel", "--rc-port", "0", "--body", "ideal", "--rate", "max", "--for",
              "300ms", "--robots", "2", "--stick", first, "--stick", OPENR_STICK, "--record",
              file});
  Replayer replayer({.file = file, .stick = "", .console = [](std::string_view) {}});
  const SimulationView view(&replayer.simulation());
  Breakpoints breaks(&replayer, &view);
  ASSERT_EQ(breaks.Add("state JointMover broadbase"), "");
  breaks.Arm();
  bool is_hit = false;
  while (!is_hit && replayer.Step()) is_hit = breaks.FindHit() == 1;
  EXPECT_TRUE(is_hit) << replayer.difference();
  EXPECT_EQ(replayer.system().object(replayer.last().record.target)->robot, 1);
}

}  // namespace
}  // namespace openr_host
