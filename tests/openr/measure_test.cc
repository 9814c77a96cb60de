// The measurements of `openr model measure`.
#include "openr/model/measure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace openr_host {
namespace {

RobotModel ModelNamed(const std::string& name) {
  return LoadRobotModel(std::string(OPENR_MODEL_DIR) + "/" + name + ".json");
}

// Returns the table's value at a distance, and sets the largest noise there.
double Expected(const Sensor& sensor, double distance_mm, double* noise_mm) {
  const double distance_m = distance_mm / 1000;
  const auto& table = sensor.lookup;
  size_t i = 1;
  while (i + 1 < table.size() && distance_m > table[i].distance_m) ++i;
  const double part = std::clamp(
      (distance_m - table[i - 1].distance_m) / (table[i].distance_m - table[i - 1].distance_m), 0.0,
      1.0);
  const double value_m = table[i - 1].value_m + part * (table[i].value_m - table[i - 1].value_m);
  *noise_mm = 1000 * value_m * (table[i - 1].noise + part * (table[i].noise - table[i - 1].noise));
  return 1000 * value_m;
}

TEST(MeasureTest, InFrontOfAWallTheDistanceSensorFollowsItsTableWithinItsNoise) {
  const RobotModel model = ModelNamed("ers210");
  const Sensor& sensor = model.sensors[static_cast<size_t>(model.SensorsNamed("distance").front())];
  const std::vector<DistanceReading> readings = MeasureDistances(model, 1);
  ASSERT_EQ(readings.size(), 19u);  // 100 to 1000 mm
  for (const DistanceReading& reading : readings) {
    SCOPED_TRACE(reading.distance_mm);
    double noise_mm = 0;
    const double value_mm = Expected(sensor, reading.distance_mm, &noise_mm);
    EXPECT_GE(reading.min_mm, value_mm - noise_mm - 1);
    EXPECT_LE(reading.max_mm, value_mm + noise_mm + 1);
    EXPECT_NEAR(reading.mean_mm, value_mm, noise_mm / 8 + 1);
    EXPECT_GE(reading.max_mm - reading.min_mm, 1.7 * noise_mm - 1);  // the noise is used
  }
}

TEST(MeasureTest, ADarkWallIsSeenAsFarAsItIsUntilItIsOutOfSight) {
  const RobotModel model = ModelNamed("ers210");
  const std::vector<DistanceReading> bright = MeasureDistances(model, 1);
  const std::vector<DistanceReading> dark = MeasureDistances(model, 0.05);
  for (size_t i = 0; i < dark.size(); ++i) {
    SCOPED_TRACE(dark[i].distance_mm);
    // 0.05 / (0.8 m)^2 * 0.18 m^2: the light of grey paper at 80 cm comes from 42 cm.
    if (dark[i].distance_mm < 420) {
      EXPECT_EQ(dark[i].mean_mm, bright[i].mean_mm);
    } else {
      EXPECT_EQ(dark[i].min_mm, 900);
    }
  }
}

TEST(MeasureTest, EveryJointOfEveryModelArrives) {
  for (const char* const name : {"ers210", "ers220", "ers7"}) {
    for (const StepResponse& step : MeasureSteps(ModelNamed(name), 20)) {
      SCOPED_TRACE(name + (" " + step.joint));
      EXPECT_GT(step.rise_ms, 0);
      EXPECT_LT(step.rise_ms, 200);
      EXPECT_LT(step.overshoot_deg, 3.5);  // necks: the weight of the head
      EXPECT_LT(step.end_error_deg, 3.5);
    }
  }
}

}  // namespace
}  // namespace openr_host
