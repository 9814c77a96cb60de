// Inputs and faults on ROS 2, by a plain DDS participant.
#include "tests/distribution/ros2/ros2_run.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;

// Reads the faults until they are `wanted`; returns the last ones.
std::string WaitForFaults(const Ros2Run& run, const std::string& wanted) {
  std::string faults;
  for (int i = 0; i < 20 && faults != wanted; ++i)
    faults = run.peer().ReadOne("std_msgs/String", "rt/aibo/faults").get<std::string>();
  return faults;
}

TEST(Ros2InputsTest, InputsThatComeAreRecordedAndFaultsAreShown) {
  const ScratchFolder folder;
  Ros2Run run({"--body", "ideal", "--record", folder.File("r")}, "5");
  run.WaitUntil(1'000'000);
  EXPECT_EQ(WaitForFaults(run, ""), "");
  run.peer().Do({"say", "rt/aibo/input", "break chin dead", "break LF_j1 weak 30%"});
  EXPECT_EQ(WaitForFaults(run, "LF_j1 weak 30%\nchin dead\n"), "LF_j1 weak 30%\nchin dead\n");
  run.peer().Do({"say", "rt/aibo/input", "repair all"});
  EXPECT_EQ(WaitForFaults(run, ""), "");
  run.End();
  const ProgramResult replay = RunProgram({"replay", folder.File("r")});
  EXPECT_EQ(replay.status, 0) << replay.err;
  EXPECT_THAT(replay.out + replay.err, HasSubstr("to the end of the recording"));
}

TEST(Ros2InputsTest, AnInputThatCannotBeIsRefusedByName) {
  Ros2Run run({"--body", "ideal"}, "5");
  run.peer().Do({"say", "rt/aibo/input", "break nose dead"});
  EXPECT_TRUE(run.program().WaitFor("aibo/input: refused: break: the ERS-210 has no joint"));
}

}  // namespace
}  // namespace openr_host
