// The original timing of controllers (Hohl 2004, 5.3.3, 5.3.4, 5.3.6), for both styles: the
// Controller object between OVirtualRobotComm and probes for the other objects.
#include <OPENR/ODataFormats.h>
#include <gmock/gmock.h>
#include <openr/testing.h>

#include <algorithm>
#include <vector>

#include "Messages.h"

namespace openr_host {
namespace {

using openr::testing::Bench;
using openr::testing::MessageKind;
using openr::testing::SeenMessage;
using openr::testing::StandIn;
using ::testing::HasSubstr;

constexpr int64_t kStepUs = 32'000;
constexpr int64_t kFrameUs = 8'000;
// A vector that answers a ready begins with the next frame (robot.md, 9.5), so that the loop takes
// one frame more than the LEDs' period.
constexpr int64_t kIterationUs = kStepUs + kFrameUs;

struct Vector {
  uint64_t cause;
  int64_t time_us;
  uint32_t on;  // bit i: element i
  int frames;   // period of the first one, for LEDs
};

class ControllerTimingTest : public ::testing::TestWithParam<const char*> {
 protected:
  ControllerTimingTest()
      : bench({.stick = OPENR_STICK,
               .replace = {"JointMover", "RCServer",
                           StandIn("Controller",
                                   [](Bench& b) {
                                     b.AddImage(std::string(OPENR_IMAGES) + "/" + GetParam());
                                   })},
               .body = "ideal"}) {
    bench.OnMessage([this](const SeenMessage& message) { See(message); });
    bench.Boot();
  }

  void Stands() { bench.probe("JointMover").subject("MainExecution").Send(MainExecutionMessage{}); }

  void See(const SeenMessage& message) {
    if (message.to().service.starts_with("Controller.Led.") &&
        message.kind() == MessageKind::kReady)
      readies.push_back(message.number());
    if (!message.to().service.starts_with("OVirtualRobotComm.Effector")) return;
    if (message.kind() != MessageKind::kNotify) return;
    if (message.from().service.starts_with("Controller.Led.")) leds.push_back(Read(message));
    if (message.from().service.starts_with("Controller.Ear.")) ears.push_back(Read(message));
  }

  static Vector Read(const SeenMessage& message) {
    const std::string_view bytes = message.data(0);
    std::vector<uint64_t> copy(bytes.size() / 8 + 1);
    std::memcpy(copy.data(), bytes.data(), bytes.size());
    auto* const vector = reinterpret_cast<OCommandVectorData*>(copy.data());
    Vector result{message.cause(), message.time_us(), 0, 0};
    for (size_t i = 0; i < vector->vectorInfo.numData; ++i) {
      const bool is_led = vector->GetInfo(static_cast<int>(i))->type == odataLED_COMMAND2;
      void* const value = vector->GetData(static_cast<int>(i))->value;
      const auto* const led = static_cast<OLEDCommandValue2*>(value);
      const auto* const ear = static_cast<OJointCommandValue3*>(value);
      if (is_led && led->led == oledON) result.on |= 1u << i;
      if (!is_led && ear->value == ojoint3_STATE1) result.on |= 1u << i;
      if (i == 0 && is_led) result.frames = led->period;
    }
    return result;
  }

  int Iterations() const {
    int count = 0;
    const std::string& text = bench.console();
    for (size_t at = text.find("iteration "); at != std::string::npos;
         at = text.find("iteration ", at + 1))
      ++count;
    return count;
  }

  Bench bench;
  std::vector<uint64_t> readies;  // numbers of the readies by which the LED vector ends
  std::vector<Vector> leds, ears;
};

TEST_P(ControllerTimingTest, NothingRunsBeforeTheDogStands) {
  bench.RunFor(std::chrono::seconds(1));
  EXPECT_EQ(Iterations(), 0);
  EXPECT_TRUE(leds.empty());
}

TEST_P(ControllerTimingTest, TheFirstVectorIsSentAfterMainAndLastsTheTimeStep) {
  Stands();
  bench.RunFor(std::chrono::milliseconds(1));
  EXPECT_EQ(Iterations(), 1);
  ASSERT_EQ(leds.size(), 1u);
  EXPECT_EQ(leds[0].frames, kStepUs / kFrameUs);
  EXPECT_EQ(leds[0].on, 1u);
}

TEST_P(ControllerTimingTest, EachIterationBeginsExactlyWhenTheReadyOfTheLedVectorArrives) {
  Stands();
  readies.clear();
  bench.RunFor(std::chrono::seconds(1));
  ASSERT_GT(leds.size(), 10u);
  EXPECT_EQ(readies.size() + 1, leds.size());
  EXPECT_EQ(static_cast<size_t>(Iterations()), leds.size());
  for (size_t i = 1; i < leds.size(); ++i) {
    EXPECT_EQ(leds[i].cause, readies[i - 1]) << i;
    EXPECT_EQ(leds[i].on & 1u, (i + 1) % 2) << i;
    EXPECT_EQ(leds[i].time_us - leds[i - 1].time_us, kIterationUs) << i;
  }
}

TEST_P(ControllerTimingTest, EarsWaitUntilTheyAreReadyAndAreTriedAgainInEveryIteration) {
  Stands();
  bench.RunFor(std::chrono::seconds(2));
  ASSERT_GT(ears.size(), 3u);
  for (size_t i = 0; i < ears.size(); ++i) {
    const auto same = [&](const Vector& led) { return led.cause == ears[i].cause; };
    EXPECT_EQ(std::count_if(leds.begin(), leds.end(), same), 1) << "at the same time as the LEDs";
    if (i == 0) continue;
    const int64_t gap_us = ears[i].time_us - ears[i - 1].time_us;
    EXPECT_GE(gap_us, 128'000);
    EXPECT_LT(gap_us, 128'000 + kFrameUs + 3 * kIterationUs);
  }
}

TEST_P(ControllerTimingTest, LedsAreNotHeldUpByTheEars) {
  Stands();
  bench.RunFor(std::chrono::seconds(2));
  EXPECT_GT(leds.size(), 2 * ears.size());
}

TEST_P(ControllerTimingTest, ValuesOfTheControllerWinAndOtherRemoteOnesGoOutWithThem) {
  Stands();
  bench.RunFor(std::chrono::milliseconds(100));
  const size_t before = leds.size();
  for (int i = 0; i < 4; ++i) {
    const LedEarState change = {1u | 1u << 8, 1u | 1u << 8, 0, 0};  // the eye, and the tail
    bench.probe("RCServer").subject("LedEar").Send(change);
    bench.RunFor(std::chrono::microseconds(kIterationUs));
  }
  ASSERT_GE(leds.size(), before + 3);
  for (size_t i = before; i < leds.size(); ++i) {
    EXPECT_EQ(leds[i].on, ((i + 1) % 2) | 1u << 8) << i;
  }
}

TEST_P(ControllerTimingTest, TheJointBufferIsSentWhenItHasChangedAndOnlyThen) {
  Stands();
  bench.RunFor(std::chrono::seconds(1));
  const auto& events = bench.probe("JointMover").observer("BatchMover").events();
  const int iterations = Iterations();
  EXPECT_EQ(static_cast<int>(events.size()), 1 + iterations / 4);
  const int tilt = FindJoint(FindRobot("ERS-210"), "PRM:/r1/c1-Joint2:j1");
  for (size_t i = 0; i < events.size(); ++i) {
    const BatchJoint& joint = events[i].as<BatchMoverCommand>().joint[tilt];
    EXPECT_EQ(joint.position, i % 2 == 0 ? -100000 : -200000);
    EXPECT_EQ(joint.flags, batchPOSITION_GIVEN);
  }
}

TEST_P(ControllerTimingTest, TheJointBufferWaitsForJointMover) {
  auto& batch = bench.probe("JointMover").observer("BatchMover");
  batch.set_auto_ready(false);
  Stands();
  bench.RunFor(std::chrono::seconds(1));
  EXPECT_EQ(batch.count(), 1u);
  batch.AssertReady();
  bench.RunFor(std::chrono::microseconds(kIterationUs));
  EXPECT_EQ(batch.count(), 2u);
}

TEST_P(ControllerTimingTest, TheShutdownCallsDieOnce) {
  Stands();
  bench.RunFor(std::chrono::seconds(1));
  bench.PressPause();
  bench.RunFor(std::chrono::seconds(1));
  const size_t at = bench.console().find("the end\n");
  ASSERT_NE(at, std::string::npos);
  EXPECT_EQ(bench.console().find("the end\n", at + 1), std::string::npos);
  EXPECT_EQ(bench.console().find("iteration", at), std::string::npos);
}

TEST_P(ControllerTimingTest, OnlyTheLoopIsRemarkedUpon) {
  Stands();
  bench.RunFor(std::chrono::seconds(1));
  if (std::string(GetParam()) == "TIMERUN.BIN") {
    EXPECT_EQ(bench.Findings(), "");
  } else {
    ASSERT_EQ(bench.findings().size(), 1u);
    EXPECT_THAT(bench.findings()[0].text, HasSubstr("robot_step() does not work on the robot"));
    EXPECT_EQ(bench.findings()[0].count, 1u);
  }
}

INSTANTIATE_TEST_SUITE_P(Styles, ControllerTimingTest,
                         ::testing::Values("TIMERUN.BIN", "TIMESTEP.BIN"), [](const auto& info) {
                           return std::string(info.param, 4, info.param[4] == 'R' ? 3 : 4);
                         });

// A run of the whole dog with one of the controllers: everything that objects send each other.
struct Dog {
  uint64_t trace, state;
  std::string console;
};

Dog RunDog(const std::string& controller, uint64_t seed) {
  Bench bench({.stick = OPENR_STICK,
               .replace = {StandIn(
                   "Controller",
                   [&](Bench& b) { b.AddImage(std::string(OPENR_IMAGES) + "/" + controller); })},
               .body = "ode",
               .seed = seed});
  bench.Boot();
  bench.RunFor(std::chrono::seconds(18));
  EXPECT_TRUE(bench.Standing());
  const std::string& console = bench.console();
  return {bench.trace_hash(), bench.state_hash(), console.substr(console.find("iteration"))};
}

// Nothing is masked: each message has the same number, cause, time, sender, receiver and bytes.
TEST(ControllerStylesTest, RunFunctionAndLoopGiveTheSameTraceBitForBit) {
  for (const uint64_t seed : {1, 2, 3}) {
    const Dog run = RunDog("TIMERUN.BIN", seed);
    const Dog step = RunDog("TIMESTEP.BIN", seed);
    EXPECT_EQ(run.trace, step.trace) << seed;
    EXPECT_EQ(run.state, step.state) << seed;
    EXPECT_EQ(run.console, step.console) << seed;
  }
}

TEST(ControllerStylesTest, ALoopThatIsReplacedBeginsAnew) {
  Bench bench({.stick = OPENR_STICK,
               .replace = {"JointMover", StandIn("Controller",
                                                 [](Bench& b) {
                                                   b.AddImage(std::string(OPENR_IMAGES) +
                                                              "/TIMESTEP.BIN");
                                                 })},
               .body = "ideal"});
  bench.Boot();
  for (int life = 0; life < 3; ++life) {
    bench.probe("JointMover").subject("MainExecution").Send(MainExecutionMessage{});
    bench.RunFor(std::chrono::seconds(1));
    const size_t last = bench.console().rfind("iteration 1\n");
    EXPECT_NE(bench.console().find("iteration 20\n", last), std::string::npos) << life;
    bench.system().object_table().Reload(bench.object("Controller").id);
    bench.RunFor(std::chrono::milliseconds(100));
  }
}

// The loop's stack is its own: what it has caught stays caught while it waits; exit() there ends
// the method that went there, and the object goes on without a controller.
TEST(ControllerStylesTest, ALoopMayStepInACatchBlockAndEndByExit) {
  Bench bench(
      {.stick = OPENR_STICK,
       .replace = {"JointMover", "RCServer",
                   StandIn("Controller", [](Bench& b) { b.AddImage(OPENR_IMAGES "/ENDING.BIN"); })},
       .body = "ideal"});
  bench.Boot();
  bench.probe("JointMover").subject("MainExecution").Send(MainExecutionMessage{});
  bench.RunFor(std::chrono::seconds(1));
  EXPECT_THAT(bench.console(), HasSubstr("caught 1\ncaught 2\ncaught 3\n"));
  EXPECT_NE(bench.LedIntensity("PRM:/r1/c1/c2/c3/l1-LED2:l1"), 0);
  bench.probe("RCServer").subject("LedEar").Send(LedEarState{1, 0, 0, 0});
  bench.RunFor(std::chrono::milliseconds(100));
  EXPECT_EQ(bench.LedIntensity("PRM:/r1/c1/c2/c3/l1-LED2:l1"), 0);
  bench.PressPause();
  bench.RunFor(std::chrono::seconds(1));
  EXPECT_TRUE(bench.system().powered_off());
}

}  // namespace
}  // namespace openr_host
