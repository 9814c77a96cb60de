// What one robot tells on topics of ROS 2 (docs/ros2.md).
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "distribution/ros2/topics.h"
#include "virtualrobot/virtual_robot.h"

namespace openr_host {

// The part of a topic's name that stands for a sensor: "Paw sensor (left fore leg)" is
// paw_sensor_left_fore_leg.
std::string TopicPart(const std::string& sensor);

class RobotTopics {
 public:
  // Topics are named `space`/..., the robot's devices as its model names them.
  RobotTopics(Bus* bus, const std::string& space, VirtualRobot* robot);

  // After each frame.  "" or why there is no image.
  std::string Publish(int64_t time_us);

 private:
  double Value(int sensor) const;
  void PublishJoints(int64_t time_us);
  void PublishAcceleration(int64_t time_us);
  std::string PublishImage(int64_t time_us);

  VirtualRobot* const robot_;
  int64_t frame_ = 0;  // published last
  Ros2JointStates joints_;
  Ros2Imu imu_;
  Ros2Image image_;
  std::map<int, std::unique_ptr<Ros2Switch>> switches_;  // by sensor
  std::map<int, std::unique_ptr<Ros2Number>> numbers_;
  Picture picture_;
};

}  // namespace openr_host
