// Each sensor is moved by the action that should move it, and by no other.
#include <fmt/format.h>
#include <openr/testing.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "virtualrobot/body/body.h"
#include "virtualrobot/virtual_robot.h"

namespace openr::testing {
namespace {

using Names = std::set<std::string>;

std::string NameOf(const openr_host::Sensor& sensor, const Bench& bench) {
  if (sensor.joint < 0) return sensor.short_name;
  return bench.model().joints[static_cast<size_t>(sensor.joint)].name;
}

std::vector<int32_t> ReadAll(const Bench& bench) {
  std::vector<int32_t> values;
  for (size_t i = 0; i < bench.model().sensors.size(); ++i)
    values.push_back(bench.dog().sensor(static_cast<int>(i)).value);
  return values;
}

// Returns what the sensors of a standing dog read 400 ms after `input`; "": no input.
std::vector<int32_t> ReadingsAfter(const std::string& input) {
  Bench bench({.stick = DefaultStick(), .body = "ideal"});
  bench.Boot();
  bench.RunFor(15s);
  if (!input.empty()) {
    EXPECT_TRUE(bench.Do(input));
  }
  bench.RunFor(400ms);
  return ReadAll(bench);
}

// Returns the sensors that read something else because of `input`.
Names MovedBy(const std::string& input) {
  static const std::vector<int32_t> without = ReadingsAfter("");  // while the dog wags its tail
  const std::vector<int32_t> with = ReadingsAfter(input);
  const Bench bench({.body = "ideal"});
  Names moved;
  for (size_t i = 0; i < with.size(); ++i) {
    if (with[i] != without[i]) moved.insert(NameOf(bench.model().sensors[i], bench));
  }
  return moved;
}

TEST(SensorsTest, EachActionMovesItsSensorsAndNoOthers) {
  EXPECT_EQ(MovedBy("press chin"), Names{"chin"});
  EXPECT_EQ(MovedBy("press back"), Names{"back"});
  EXPECT_EQ(MovedBy("press head_front"), Names{"head_front"});
  EXPECT_EQ(MovedBy("press head_back 20%"), Names{"head_back"});
  EXPECT_EQ(MovedBy("press head"), (Names{"head_back", "head_front"}));
  EXPECT_EQ(MovedBy("heat body 50"), Names{"temperature"});
  EXPECT_EQ(MovedBy("heat battery 50"), Names{});
  EXPECT_EQ(MovedBy("draw 1000"), Names{});
  EXPECT_EQ(MovedBy("battery 50%"), Names{});
  EXPECT_EQ(MovedBy("charger on"), Names{});
  EXPECT_EQ(MovedBy("lift 0.1"), (Names{"paw_LF", "paw_LH", "paw_RF", "paw_RH"}));
  EXPECT_EQ(MovedBy("turn mouth -20"), Names{"mouth"});
  EXPECT_EQ(MovedBy("turn tail_tilt 15"), Names{"tail_tilt"});
  EXPECT_EQ(MovedBy("turn neck_pan 20"), Names{"neck_pan"});
}

TEST(SensorsTest, AWallInFrontMovesTheDistanceSensorAlone) {
  const auto values = [](const std::string& world) {
    Bench bench({.stick = DefaultStick(), .body = "ideal", .world = world});
    bench.Boot();
    bench.RunFor(15s);
    return ReadAll(bench);
  };
  const std::filesystem::path file =
      std::filesystem::temp_directory_path() / fmt::format("openr-wall-{}.json", getpid());
  std::ofstream(file) << R"({"schema": "openr-host world 2", "name": "wall", "things": [
    {"shape": "box", "name": "wall", "size_m": [0.1, 1, 1], "centre_m": [0.55, 0, 0.5]}]})";
  const std::vector<int32_t> empty = values(""), wall = values(file);
  std::filesystem::remove(file);
  Bench bench({.body = "ideal"});
  const int distance = bench.model().SensorsNamed("distance").front();
  for (size_t i = 0; i < empty.size(); ++i) {
    if (static_cast<int>(i) == distance) {
      EXPECT_EQ(empty[i], 900'000);
      EXPECT_NEAR(wall[i], 400'000, 50'000);
    } else {
      EXPECT_EQ(empty[i], wall[i]) << NameOf(bench.model().sensors[i], bench);
    }
  }
}

// field-notes.md 8.5.  The sensor looks 30 degrees downwards, so a flat floor is nearly twice as
// far away as it is below the sensor; where no floor is near, the sensor reads the end of its
// range.
TEST(SensorsTest, TheChestSensorOfAnErs7FindsCliffsAndNotTheDistanceToTheFloor) {
  Bench bench({.stick = DefaultStick(), .body = "ideal", .robot = "ers7"});
  bench.Boot();
  bench.RunFor(15s);
  const int chest = bench.model().SensorsNamed("distance_chest").front();
  const openr_host::Sensor& sensor = bench.model().sensors[static_cast<size_t>(chest)];
  const double height_m = (bench.dog().body().state().X_WB * sensor.place_m).z();
  EXPECT_NEAR(height_m, 0.14, 0.02);
  const double read_m = static_cast<double>(bench.SensorValue("distance_chest")) * 1e-6;
  EXPECT_GT(read_m, 1.5 * height_m);
  EXPECT_LT(read_m, 2.5 * height_m);
  EXPECT_TRUE(bench.Do("lift 0.5"));
  bench.RunFor(4s);
  EXPECT_EQ(bench.SensorValue("distance_chest"), 900'000);
}

// ---- with physics

struct Shaken {
  Shaken() : bench({.stick = DefaultStick(), .body = "ode"}) {
    bench.Boot();
    bench.RunFor(15s);
  }
  double Acceleration(const char* name) const {
    return static_cast<double>(bench.SensorValue(name)) * 1e-6;
  }
  double Norm() const {
    const double x = Acceleration("acceleration_x"), y = Acceleration("acceleration_y"),
                 z = Acceleration("acceleration_z");
    return std::sqrt(x * x + y * y + z * z);
  }
  Bench bench;
};

TEST(AccelerometerTest, AtRestItReadsGravityAlongTheTilt) {
  const Shaken dog;
  const double pitch_rad = dog.bench.PitchDeg() * M_PI / 180;
  EXPECT_NEAR(dog.Acceleration("acceleration_x"), 9.80665 * std::sin(pitch_rad), 0.02);
  EXPECT_NEAR(dog.Acceleration("acceleration_y"), 0, 0.02);
  EXPECT_NEAR(dog.Acceleration("acceleration_z"), -9.80665 * std::cos(pitch_rad), 0.02);
}

TEST(AccelerometerTest, APushToOneSideIsFeltAcrossAndHardlyAlong) {
  Shaken dog;
  const double x = dog.Acceleration("acceleration_x");
  EXPECT_TRUE(dog.bench.Push({0, 15, 0}, 24ms));
  double across = 0, along = 0;
  for (int i = 0; i < 3; ++i) {
    dog.bench.Frame();
    across = std::max(across, std::fabs(dog.Acceleration("acceleration_y")));
    along = std::max(along, std::fabs(dog.Acceleration("acceleration_x") - x));
  }
  EXPECT_GT(across, 1);
  EXPECT_LT(along, across / 4);
}

TEST(AccelerometerTest, ALiftIsFeltWhenItBeginsAndFreeFallReadsNothing) {
  Shaken dog;
  EXPECT_TRUE(dog.bench.Lift(0.5));
  double highest = 0;
  for (int i = 0; i < 20; ++i) {
    dog.bench.Frame();
    highest = std::max(highest, dog.Norm());
  }
  EXPECT_GT(highest, 10.5);
  dog.bench.RunFor(4s);
  EXPECT_NEAR(dog.Norm(), 9.80665, 0.2);  // held still
  EXPECT_TRUE(dog.bench.LetGo());
  dog.bench.RunFor(120ms);
  EXPECT_LT(dog.Norm(), 1.5);
}

TEST(PawTest, ThePawsCarryTheWeightAndOnlyThatOfAStandingDog) {
  Shaken dog;
  const std::vector<double>& forces_n = dog.bench.dog().body().state().paw_forces_n;
  ASSERT_EQ(forces_n.size(), 4u);
  const double weight_n = dog.bench.model().TotalMassKg() * openr_host::kGravity_m_s2;
  EXPECT_NEAR(std::accumulate(forces_n.begin(), forces_n.end(), 0.0), weight_n, 0.02 * weight_n);
  EXPECT_TRUE(dog.bench.Lift(0.2));
  dog.bench.RunFor(2s);
  EXPECT_EQ(std::accumulate(forces_n.begin(), forces_n.end(), 0.0), 0);
  for (const char* const paw : {"paw_LF", "paw_LH", "paw_RF", "paw_RH"})
    EXPECT_EQ(dog.bench.SensorValue(paw), 0) << paw;
}

// ---- current and heat of motors

int CurrentMa(const Bench& bench) { return -bench.dog().power().Status().current; }

TEST(EnergyTest, AStandingDogDrawsMoreThanALimpOneAndLessThanOneThatIsBlocked) {
  Bench limp({.body = "ode"});  // without objects nobody switches the motors on
  limp.Boot();
  limp.RunFor(1s);
  Bench bench({.stick = DefaultStick(), .body = "ode"});
  bench.Boot();
  bench.RunFor(20s);
  const int standing_ma = CurrentMa(bench);
  EXPECT_GT(standing_ma, CurrentMa(limp));
  bench.AllowFindings();
  EXPECT_TRUE(bench.Do("turn LF_j1 40"));
  EXPECT_TRUE(bench.Do("turn RF_j1 40"));
  bench.RunFor(2s);
  EXPECT_GT(CurrentMa(bench), standing_ma + 500);
}

TEST(EnergyTest, ABlockedLegWarmsTheBodyAndTheBodyCoolsAgain) {
  Bench bench({.stick = DefaultStick(), .body = "ode"});
  bench.Boot();
  bench.RunFor(15s);
  EXPECT_EQ(bench.SensorValue("temperature"), 30'000'000);
  bench.AllowFindings();
  EXPECT_TRUE(bench.Do("turn LF_j1 50 for 60s"));  // a hand works against the motor
  EXPECT_TRUE(bench.Do("turn RF_j1 50 for 60s"));
  bench.RunFor(60s);
  const int64_t warm = bench.SensorValue("temperature");
  EXPECT_GT(warm, 30'000'000);
  EXPECT_EQ(warm % 1'000'000, 0);  // whole degrees
}

}  // namespace
}  // namespace openr::testing
