#include "openr/ros2/robot_topics.h"

#include <vector>

namespace openr_host {
namespace {

constexpr int64_t kFaultsFrames = 125;  // 1 s

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
      joints_(bus, space + "/joint_states", JointNames(robot->model())),
      imu_(bus, space + "/imu", space + "/base_link"),
      image_(bus, space + "/image_raw", space + "/camera_optical"),
      faults_(bus, space + "/faults") {
  const std::vector<Sensor>& sensors = robot->model().sensors;
  for (size_t i = 0; i < sensors.size(); ++i) {
    const auto sensor = static_cast<int>(i);
    const std::string part = TopicPart(sensors[i].name);
    switch (sensors[i].kind) {
      case SensorKind::kSwitch:
        switches_[sensor] = std::make_unique<Ros2Switch>(bus, space + "/touch/" + part);
        break;
      case SensorKind::kForce:
      case SensorKind::kRaw:  // the strength of a touch, without a unit
        numbers_[sensor] = std::make_unique<Ros2Number>(bus, space + "/touch/" + part);
        break;
      case SensorKind::kDistance:
        numbers_[sensor] = std::make_unique<Ros2Number>(bus, space + "/distance/" + part);
        break;
      default:
        break;  // joints and acceleration are published elsewhere, temperature is not
    }
  }
}

// Returns the present value of the sensor with the index `sensor`, in SI units.
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
  PublishFaults();
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

// Publishes the acceleration with its sign changed: the robot's sensors measure gravity minus
// acceleration, and ROS 2 expects acceleration minus gravity.
void RobotTopics::PublishAcceleration(int64_t time_us) {
  const std::vector<Sensor>& sensors = robot_->model().sensors;
  Eigen::Vector3d felt{0, 0, 0};
  for (size_t i = 0; i < sensors.size(); ++i) {
    if (sensors[i].kind == SensorKind::kAcceleration)
      felt -= Value(static_cast<int>(i)) * sensors[i].direction;
  }
  imu_.Publish(time_us, {felt.x(), felt.y(), felt.z()});
}

// Publishes the faults of the robot, a line each, when they change and once a second.
void RobotTopics::PublishFaults() {
  std::string text;
  for (const std::string& fault : robot_->parts().faults.Present()) text += fault + "\n";
  if (text == last_faults_ && frame_ % kFaultsFrames != 0) return;
  last_faults_ = text;
  faults_.Publish(text);
}

std::string RobotTopics::PublishImage(int64_t time_us) {
  if (!image_.HasReaders() || !robot_->ImageIsDue()) return "";
  std::string problem = robot_->TakePicture(&picture_);
  if (!problem.empty()) return "camera: " + problem;
  image_.Publish(time_us, picture_.width, picture_.height, picture_.rgb);
  return "";
}

}  // namespace openr_host
