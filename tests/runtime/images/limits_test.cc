// Tests of an object's limits, of the stick in the state hash, and of robots that go off singly.
#include <gtest/gtest.h>

#include "runtime/core/current.h"
#include "tests/runtime/images/image_fixture.h"

namespace openr_host {
namespace {

#if !defined(__SANITIZE_ADDRESS__)
TEST_F(ImageTest, StrictlyAnObjectHasNoMoreMemoryThanTheRobot) {
  Start({.strict = true});
  EXPECT_EQ(talker->Ask("hoard"), "refused after 31 MiB");
  EXPECT_NE(Findings().find("no memory for 1048576 bytes"), std::string::npos) << Findings();
}

TEST_F(ImageTest, OtherwiseItsMemoryIsTheHosts) {
  Start();
  EXPECT_EQ(talker->Ask("hoard"), "64 MiB");
  EXPECT_EQ(Findings(), "");
}

TEST_F(ImageTest, TheStackItUsesIsMeasured) {
  Start({.measure_stacks = true});
  const Object* const probe = system->FindObject(0, "probe");
  talker->Ask("count");
  const size_t shallow = probe->statistics().stack_max();
  EXPECT_GT(shallow, 100u);
  EXPECT_LT(shallow, 10000u);
  talker->Ask("deep");  // 12,000 bytes in one frame
  EXPECT_GT(probe->statistics().stack_max(), 12000u);
  EXPECT_LT(probe->statistics().stack_max(), 12000u + shallow + 2000u);
}
#endif

// A clock of which each call takes 1 us.  Notes calls that would get the time of the robot.
int64_t g_clock_ns = 0;
bool g_is_asked_by_image = false;
int64_t SlowClock() {
  g_is_asked_by_image = g_is_asked_by_image || t_current.image_code;
  return g_clock_ns += 1000;
}

TEST_F(ImageTest, TheLongestHandlerIsMeasuredWithTheClockOfTheHost) {
  g_is_asked_by_image = false;
  Start({.wall_clock_ns = &SlowClock});
  talker->Ask("count");
  EXPECT_GE(system->FindObject(0, "probe")->statistics().handler_ns_max(), 1000);
  EXPECT_FALSE(g_is_asked_by_image);
}

TEST_F(ImageTest, TheStickIsPartOfTheState) {
  Start();
  const uint64_t before = system->state_hash();
  Start();
  EXPECT_EQ(system->state_hash(), before);
  Write("OPEN-R/MW/DATA/P/OTHER.TXT", "nobody reads this");
  Start();
  EXPECT_NE(system->state_hash(), before);
}

TEST_F(ImageTest, AStickWithoutWiringIsAFinding) {
  fs::remove(root / "OPEN-R/MW/CONF/CONNECT.CFG");
  Start();
  EXPECT_EQ(Findings(),
            "/MS/OPEN-R/MW/CONF/CONNECT.CFG: No such file on the stick; no object is connected\n");
}

TEST_F(ImageTest, AStickThatNamesNoObjectIsAFinding) {
  Write("OPEN-R/MW/CONF/OBJECT.CFG", "# nothing yet\n");
  Write("OPEN-R/MW/CONF/CONNECT.CFG", "");
  Start();
  EXPECT_EQ(Findings(),
            "OBJECT.CFG: names no object for this robot; nothing of the application runs\n");
}

TEST_F(ImageTest, ARobotThatShutsDownLeavesTheOthersRunning) {
  Start();
  const int second = system->AddRobot("ERS-210", stick);
  // The first dog's talker stays the one that is asked.
  system->Shutdown(second);
  system->RunFor(1000);
  EXPECT_TRUE(system->robot(second).powered_off);
  EXPECT_FALSE(system->powered_off());
  EXPECT_EQ(talker->Ask("count"), "1");
  system->Shutdown(0);
  system->RunFor(1000);
  EXPECT_TRUE(system->powered_off());
  EXPECT_EQ(talker->Ask("count"), "(no answer)");
}

}  // namespace
}  // namespace openr_host
