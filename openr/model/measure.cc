#include "openr/model/measure.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "virtualrobot/base/det_math.h"
#include "virtualrobot/body/body_mover.h"
#include "virtualrobot/power/energy.h"
#include "virtualrobot/virtual_robot.h"

namespace openr_host {
namespace {

constexpr double kStep_s = 0.8;
constexpr int kSamples = 200;

// A robot that is held in the air in its standing posture, so that its feet touch nothing.
struct HangingRobot {
  explicit HangingRobot(const RobotModel& model)
      : body(MakeOdeBody(model, World())), mover(model, body.get()), devices(model), energy(model) {
    mover.StandUp();
    Eigen::Isometry3d X_WB = body->state().X_WB;
    X_WB.translation().z() += 0.3;
    body->Hold(X_WB);
    mover.Hold(3);
  }

  std::unique_ptr<Body> body;
  BodyMover mover;
  Devices devices;
  Energy energy;
};

StepResponse MeasureStep(const RobotModel& model, size_t j, double step_deg) {
  HangingRobot robot(model);
  const JointModel& joint = model.joints[j];
  const double from_rad = robot.mover.commands[j].target_rad;
  const double middle_rad = (joint.soft_rad.min + joint.soft_rad.max) / 2;
  const double room_rad =
      middle_rad > from_rad ? joint.soft_rad.max - from_rad : from_rad - joint.soft_rad.min;
  const double way_rad = std::min(Radians(step_deg), 0.8 * room_rad);
  const double to_rad = from_rad + (middle_rad > from_rad ? way_rad : -way_rad);
  const double sign = to_rad > from_rad ? 1 : -1;

  StepResponse response;
  response.joint = joint.name;
  response.from_deg = Degrees(from_rad);
  response.to_deg = Degrees(to_rad);
  response.rise_ms = -1;
  robot.mover.commands[j].target_rad = to_rad;
  for (int frame = 1; frame <= FramesIn(kStep_s); ++frame) {
    robot.mover.Frame();
    robot.energy.NoteFrame(*robot.body, robot.devices, false, true);
    const double angle_rad = robot.body->state().joints[j].angle_rad;
    response.times_ms.push_back(frame * kFrame_s * 1000);
    response.commanded_deg.push_back(response.to_deg);
    response.measured_deg.push_back(Degrees(angle_rad));
    if (response.rise_ms < 0 && sign * (angle_rad - from_rad) >= 0.9 * way_rad)
      response.rise_ms = response.times_ms.back();
    response.overshoot_deg = std::max(response.overshoot_deg, Degrees(sign * (angle_rad - to_rad)));
    response.current_ma_max =
        std::max(response.current_ma_max, double{1} * robot.energy.current_ma());
  }
  response.end_error_deg = std::fabs(response.measured_deg.back() - response.to_deg);
  return response;
}

// Returns the index of the first distance sensor whose place on the body is known; -1 if no such
// sensor exists.
int DistanceSensorOf(const RobotModel& model) {
  for (size_t i = 0; i < model.sensors.size(); ++i) {
    const Sensor& sensor = model.sensors[i];
    if (sensor.kind == SensorKind::kDistance && sensor.body >= 0) return static_cast<int>(i);
  }
  return -1;
}

// Makes a robot that stands in `world` and does not move, because only its sensor is measured.
std::unique_ptr<Body> StandingStatue(const RobotModel& model, const World& world) {
  std::unique_ptr<Body> body = MakeIdealBody(model, world);
  BodyMover mover(model, body.get());
  const std::vector<double> angles_rad = mover.Posture("stand");
  for (size_t j = 0; j < angles_rad.size(); ++j) {
    mover.commands[j].enabled = true;
    mover.commands[j].target_rad = angles_rad[j];
  }
  mover.Frame();
  return body;
}

}  // namespace

std::vector<StepResponse> MeasureSteps(const RobotModel& model, double step_deg) {
  std::vector<StepResponse> responses;
  for (size_t j = 0; j < model.joints.size(); ++j)
    responses.push_back(MeasureStep(model, j, step_deg));
  return responses;
}

std::vector<DistanceReading> MeasureDistances(const RobotModel& model, double reflectance) {
  std::vector<DistanceReading> readings;
  const int index = DistanceSensorOf(model);
  if (index < 0) return readings;
  const Sensor& sensor = model.sensors[static_cast<size_t>(index)];
  const std::unique_ptr<Body> statue = StandingStatue(model, World());
  const Eigen::Isometry3d X_WP = statue->PoseOf(static_cast<size_t>(sensor.body));
  const Eigen::Vector3d place_W = X_WP * sensor.place_m;
  const Eigen::Vector3d ray_W = X_WP.linear() * sensor.direction;
  for (int distance_mm = 100; distance_mm <= 1000; distance_mm += 50) {
    WorldThing wall;
    wall.size_m = {0.1, 2, 2};
    // Puts the front of the wall at the point of the ray that is `distance_mm` from the sensor.
    // The wall is 0.1 m thick, so its centre is 0.05 m behind its front.
    wall.centre_m = {place_W.x() + ray_W.x() * distance_mm / 1000.0 + 0.05, 0, 1};
    wall.reflectance = reflectance;
    World world;
    world.things.push_back(wall);
    PrimitiveTable primitives(model);
    const Devices devices(model);
    SensorSource sensors(model, primitives, Rng(1, "measure"), Rng(1, "measure/faults"));
    const std::unique_ptr<Body> body = StandingStatue(model, world);
    DistanceReading reading{static_cast<double>(distance_mm), reflectance, 1e9, 0, 0};
    for (int i = 0; i < kSamples; ++i) {
      sensors.SampleNow(*body, devices);
      const double value_mm = sensors.Latest(index).value / 1000.0;
      reading.min_mm = std::min(reading.min_mm, value_mm);
      reading.max_mm = std::max(reading.max_mm, value_mm);
      reading.mean_mm += value_mm / kSamples;
    }
    readings.push_back(reading);
  }
  return readings;
}

}  // namespace openr_host
