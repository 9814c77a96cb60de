// Tests of how robots are switched off.
#include "runtime/core/robot_table.h"

#include <gtest/gtest.h>

#include <memory>
#include <optional>

#include "runtime/core/code_object.h"
#include "runtime/core/robot_services.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// A robot with a boot timer of one second.
class TimerServices : public RobotServices {
 public:
  std::optional<int64_t> TimeOffUs() const override { return 1'000'000; }
};

class RobotTableTest : public testing::Test {
 protected:
  RobotTableTest() {
    for (int i = 0; i < 2; ++i) system.AddRobot("ERS-210", nullptr);
    system.robot(0).services = std::make_unique<TimerServices>();
    system.robot(0).load_again = [this] {
      ++boots_again;
      return true;
    };
    system.Boot();
    system.RunFor(1000);
  }

  System system;
  int boots_again = 0;
};

TEST_F(RobotTableTest, AShutdownWithABootTimerBootsTheRobotAgain) {
  system.Shutdown(0);
  system.RunFor(2'000'000);
  EXPECT_EQ(boots_again, 1);
}

TEST_F(RobotTableTest, ARobotThatIsSwitchedOffDuringItsShutdownDoesNotBootAgain) {
  system.Shutdown(0);
  system.PowerOff(0, {EndKind::kFatal, "an object called OPENR::Fatal()"});
  system.RunFor(2'000'000);
  EXPECT_EQ(boots_again, 0);
  ASSERT_TRUE(system.robot(0).end.has_value());
  EXPECT_EQ(system.robot(0).end->kind, EndKind::kFatal);
  EXPECT_FALSE(system.powered_off());
}

// An object that counts how often it is stopped.
class StopCounter : public CodeObject {
 public:
  explicit StopCounter(int* stops) : stops_(stops) {}
  OStatus DoStop(const OSystemEvent&) override {
    ++*stops_;
    return oSUCCESS;
  }

 private:
  int* const stops_;
};

// The object gets no DoInit, so its DoStop would find nothing to stop.
TEST_F(RobotTableTest, AnObjectOfARobotThatDoesNotBootAgainIsNotStopped) {
  int stops = 0;
  system.robot(0).load_again = [&] {
    system.AddObject<StopCounter>(0, "loaded", &stops);
    return false;  // as if the next image could not be loaded
  };
  system.Shutdown(0);
  system.RunFor(2'000'000);
  ASSERT_NE(system.FindObject(0, "loaded"), nullptr);
  system.Shutdown();
  system.RunFor(1000);
  EXPECT_TRUE(system.powered_off());
  EXPECT_EQ(stops, 0);
}

TEST(StrictRobotTest, AnErrorOfAnotherRobotDoesNotKeepARobotFromBootingAgain) {
  for (const int robot_with_error : {0, 1}) {
    System system({.strict = true});
    for (int i = 0; i < 2; ++i) system.AddRobot("ERS-210", nullptr);
    system.robot(0).services = std::make_unique<TimerServices>();
    system.robot(0).load_again = [&] {
      system.AddFindingAboutRobot(robot_with_error, Severity::kError, "an error during the boot");
      return true;
    };
    system.Boot();
    system.RunFor(1000);
    system.Shutdown(0);
    system.RunFor(2'000'000);
    EXPECT_EQ(system.robot(0).boots, 2);
    EXPECT_EQ(system.robot(0).powered_off, robot_with_error == 0);
  }
}

}  // namespace
}  // namespace openr_host
