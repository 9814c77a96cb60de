#include "openr/ros2/robot_topics.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "openr/model/urdf.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

constexpr int64_t kSecondFrames = 125;

// Returns the state of the battery of `robot` in the units of ROS 2.
Ros2BatteryValues BatteryOf(VirtualRobot* robot) {
  constexpr double kZeroCelsius = 273.15;  // 0 degrees Celsius in K
  const OPowerStatus status = robot->power().Status();
  return {.voltage_v = static_cast<float>(status.voltage / 1000.0),
          .current_a = static_cast<float>(status.current / 1000.0),
          .temperature_c = static_cast<float>(status.temperature / 10.0 - kZeroCelsius),
          .capacity_ah = static_cast<float>(status.fullyChargedCapacity / 1000.0),
          .share = static_cast<float>(status.remainingCapacity / 100.0),
          .is_charging = (status.robotStatus & orsbBATTERY_CHARGING) != 0};
}

Ros2Status BatteryStatus(VirtualRobot* robot) {
  const Ros2BatteryValues battery = BatteryOf(robot);
  const bool is_low = robot->power().is_battery_low();
  return {.level = is_low ? Ros2Status::kWarning : Ros2Status::kGood,
          .name = "battery",
          .message = is_low ? "low" : "good",
          .values = {{"percent", fmt::format("{:.0f}", 100 * battery.share)},
                     {"temperature_c", fmt::format("{:.1f}", battery.temperature_c)}}};
}

Ros2Status FaultStatus(VirtualRobot* robot) {
  Ros2Status status{
      .level = Ros2Status::kGood, .name = "body", .message = "no faults", .values = {}};
  for (const std::string& fault : robot->parts().faults.Present())
    status.values.emplace_back("fault", fault);
  if (!status.values.empty()) {
    status.level = Ros2Status::kWarning;
    status.message = fmt::format("{} faults", status.values.size());
  }
  return status;
}

// Returns a summary of the findings about the objects of `robot`.  The member `message` is the
// newest finding.  The member `level` depends only on the warnings and errors, because a note says
// that nothing is wrong.
Ros2Status ObjectStatus(const RobotParts& robot) {
  Ros2Status status{
      .level = Ros2Status::kGood, .name = "objects", .message = "no findings", .values = {}};
  int notes = 0, warnings = 0, errors = 0;
  for (const Finding& finding : robot.system.findings().all()) {
    if (finding.robot != robot.robot_index) continue;
    if (finding.severity == Severity::kNote) {
      ++notes;
    } else {
      const bool is_error = finding.severity == Severity::kError;
      ++(is_error ? errors : warnings);
      status.level = std::max(status.level, is_error ? Ros2Status::kError : Ros2Status::kWarning);
    }
    status.message = finding.object.empty() ? finding.text : finding.object + ": " + finding.text;
  }
  status.values = {{"errors", std::to_string(errors)},
                   {"warnings", std::to_string(warnings)},
                   {"notes", std::to_string(notes)}};
  return status;
}

std::vector<std::string> JointNames(const RobotModel& model) {
  std::vector<std::string> names;
  for (const JointModel& joint : model.joints) names.push_back(joint.name);
  return names;
}

}  // namespace

std::string TopicPart(const std::string& sensor) {
  std::string part;
  for (const char c : sensor) {
    const bool is_upper = c >= 'A' && c <= 'Z';
    if (is_upper || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9')) {
      part += static_cast<char>(is_upper ? c - 'A' + 'a' : c);
    } else if (!part.empty() && part.back() != '_') {
      part += '_';
    }
  }
  while (part.ends_with('_')) part.pop_back();
  return part;
}

RobotTopics::RobotTopics(Bus* bus, const std::string& space, VirtualRobot* robot)
    : robot_(robot),
      space_(space),
      joints_(bus, space + "/joint_states", JointNames(robot->model())),
      imu_(bus, space + "/imu", space + "/base_link"),
      image_(bus, space + "/image_raw", space + "/camera_optical"),
      faults_(bus, space + "/faults"),
      motion_(bus, space + "/odom", space + "/odom", space + "/base_link"),
      battery_(bus, space + "/battery"),
      sound_(bus, space + "/audio", kSoundRate),
      diagnostics_(bus, "diagnostics"),
      description_(bus, space + "/robot_description", LateReaders::kGetNewest) {
  description_.Publish(Urdf(robot->model()));
  for (const Led& led : robot->model().leds)
    lights_.push_back(std::make_unique<Ros2Number>(bus, space + "/led/" + TopicPart(led.name)));
  const std::vector<Sensor>& sensors = robot->model().sensors;
  for (size_t i = 0; i < sensors.size(); ++i) {
    const auto sensor = static_cast<int>(i);
    const std::string part = TopicPart(sensors[i].name);
    switch (sensors[i].kind) {
      case SensorKind::kSwitch:
        switches_[sensor] = std::make_unique<Ros2Switch>(bus, space + "/touch/" + part);
        break;
      case SensorKind::kForce:
      case SensorKind::kRaw:  // the strength of a touch, a value without a unit
        numbers_[sensor] = std::make_unique<Ros2Number>(bus, space + "/touch/" + part);
        break;
      case SensorKind::kDistance:
        numbers_[sensor] = std::make_unique<Ros2Number>(bus, space + "/distance/" + part);
        break;
      case SensorKind::kTemperature:
        temperatures_[sensor] = std::make_unique<Ros2Temperature>(
            bus, space + "/temperature/" + part, space + "/base_link");
        break;
      case SensorKind::kJoint:
      case SensorKind::kAcceleration:
        // Sensors of joints and of acceleration get no topics of their own, because the topics
        // joint_states and imu have their values.
        break;
    }
  }
}

// Returns the present value of the sensor with the index `sensor`, in SI units, but a temperature
// in degrees Celsius.
double RobotTopics::Value(int sensor) const {
  const double value = robot_->sensor(sensor).value;
  const SensorKind kind = robot_->model().sensors[static_cast<size_t>(sensor)].kind;
  return kind == SensorKind::kSwitch || kind == SensorKind::kRaw ? value : value / 1e6;
}

std::string RobotTopics::Publish(int64_t time_us) {
  if (robot_->frame() == frame_) return "";
  frame_ = robot_->frame();
  PublishJoints(time_us);
  PublishAcceleration(time_us);
  for (const auto& [sensor, topic] : switches_) topic->Publish(Value(sensor) != 0);
  for (const auto& [sensor, topic] : numbers_) topic->Publish(Value(sensor));
  for (const auto& [sensor, topic] : temperatures_) topic->Publish(time_us, Value(sensor));
  PublishFaults();
  PublishMotion(time_us);
  PublishLights();
  PublishSound();
  if (frame_ % kSecondFrames == 0) {
    PublishBattery(time_us);
    PublishDiagnostics(time_us);
  }
  return PublishImage(time_us);
}

void RobotTopics::PublishJoints(int64_t time_us) {
  std::vector<double> positions, velocities;
  for (const JointModel& joint : robot_->model().joints) positions.push_back(Value(joint.sensor));
  // Publishes the joint speeds of the simulated body, because the robot does not measure them.
  for (const JointState& joint : robot_->body().state().joints)
    velocities.push_back(joint.speed_rad_s);
  joints_.Publish(time_us, positions, velocities);
}

// Publishes the acceleration of the body with its sign changed: the robot's sensors measure gravity
// minus acceleration, and ROS 2 expects acceleration minus gravity.
void RobotTopics::PublishAcceleration(int64_t time_us) {
  const std::vector<Sensor>& sensors = robot_->model().sensors;
  Eigen::Vector3d felt{0, 0, 0};
  for (size_t i = 0; i < sensors.size(); ++i) {
    if (sensors[i].kind == SensorKind::kAcceleration)
      felt -= Value(static_cast<int>(i)) * sensors[i].direction;
  }
  imu_.Publish(time_us, {felt.x(), felt.y(), felt.z()});
}

// Publishes the present faults of the robot (jammed joints, dead sensors and the like), one line
// for each fault.  Does so when the faults change, and once a second.
void RobotTopics::PublishFaults() {
  std::string text;
  for (const std::string& fault : robot_->parts().faults.Present()) text += fault + "\n";
  if (text == last_faults_ && frame_ % kSecondFrames != 0) return;
  last_faults_ = text;
  faults_.Publish(text);
}

// Publishes the place of the body and its speed.  The values come from the simulation, because the
// robot has no sensor for them.
void RobotTopics::PublishMotion(int64_t time_us) {
  const BodyState& body = robot_->body().state();
  const Eigen::Vector3d place = body.X_WB.translation();
  const Eigen::Quaterniond turn(body.X_WB.linear());
  const Eigen::Vector3d speed = body.X_WB.linear().transpose() * body.v_WB;
  const Eigen::Vector3d turning = body.X_WB.linear().transpose() * body.w_WB;
  motion_.Publish(time_us, {.position_m = {place.x(), place.y(), place.z()},
                            .rotation = {turn.x(), turn.y(), turn.z(), turn.w()},
                            .speed_m_s = {speed.x(), speed.y(), speed.z()},
                            .turning_rad_s = {turning.x(), turning.y(), turning.z()}});
}

void RobotTopics::PublishBattery(int64_t time_us) { battery_.Publish(time_us, BatteryOf(robot_)); }

// Publishes the brightness of each light, from 0 to 1. Does so when it changes, and once a second.
void RobotTopics::PublishLights() {
  last_lights_.resize(lights_.size(), -1);
  for (size_t i = 0; i < lights_.size(); ++i) {
    const double full = robot_->model().leds[i].type == "LED3" ? 255 : 1;
    const double value = robot_->devices().leds[i].intensity / full;
    if (value == last_lights_[i] && frame_ % kSecondFrames != 0) continue;
    last_lights_[i] = value;
    lights_[i]->Publish(value);
  }
}

// Publishes the sound that the speaker has played in this frame.  Publishes nothing while the
// speaker is silent.
void RobotTopics::PublishSound() {
  const Speaker::Sound& sound = robot_->speaker().newest();
  if (sound.frame == last_sound_) return;
  last_sound_ = sound.frame;
  sound_.Publish({sound.samples.begin(), sound.samples.end()});
}

void RobotTopics::PublishDiagnostics(int64_t time_us) {
  if (!diagnostics_.HasReaders()) return;
  std::vector<Ros2Status> statuses = {BatteryStatus(robot_), FaultStatus(robot_),
                                      ObjectStatus(robot_->parts())};
  for (Ros2Status& status : statuses) status.name = space_ + ": " + status.name;
  diagnostics_.Publish(time_us, space_, statuses);
}

std::string RobotTopics::PublishImage(int64_t time_us) {
  if (!image_.HasReaders() || !robot_->HasNewImage()) return "";
  std::string problem = robot_->CopyPicture(&picture_);
  if (!problem.empty()) return "camera: " + problem;
  image_.Publish(time_us, picture_.width, picture_.height, picture_.rgb);
  return "";
}

}  // namespace openr_host
