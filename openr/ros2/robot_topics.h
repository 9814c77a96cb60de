// RobotTopics publishes the state of one robot as topics of ROS 2 (docs/ros2.md).
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "distribution/ros2/topics.h"
#include "virtualrobot/virtual_robot.h"

namespace openr_host {

// Returns the name of a sensor as a part of a topic's name, such as "paw_sensor_left_fore_leg" for
// "Paw sensor (left fore leg)".
std::string TopicPart(const std::string& sensor);

class RobotTopics {
 public:
  // Creates the topics.  The name of a topic is `space`, "/", and either a word such as "imu" or
  // the kind and name of a sensor, such as "touch/paw_sensor_left_fore_leg".
  RobotTopics(Bus* bus, const std::string& space, VirtualRobot* robot);

  // Publishes the values of the robot: most of them in each frame, the others once a second or when
  // they change.  Called after each frame of 8 ms.  Returns "", or the reason why the camera has no
  // picture.
  std::string Publish(int64_t time_us);

 private:
  double Value(int sensor) const;
  void PublishJoints(int64_t time_us);
  void PublishAcceleration(int64_t time_us);
  void PublishFaults();
  void PublishMotion(int64_t time_us);
  void PublishBattery(int64_t time_us);
  void PublishLights();
  void PublishSound();
  void PublishDiagnostics(int64_t time_us);
  std::string PublishImage(int64_t time_us);

  VirtualRobot* const robot_;
  const std::string space_;
  int64_t frame_ = 0;  // number of the frame whose values were published last
  Ros2JointStates joints_;
  Ros2Imu imu_;
  Ros2Image image_;
  Ros2Text faults_;
  Ros2Odometry motion_;
  Ros2Battery battery_;
  Ros2Sound sound_;
  Ros2Diagnostics diagnostics_;
  Ros2Text description_;
  std::string last_faults_;  // text of the faults that was published last
  std::map<int, std::unique_ptr<Ros2Switch>> switches_;  // key: number of the sensor
  std::map<int, std::unique_ptr<Ros2Number>> numbers_;
  std::map<int, std::unique_ptr<Ros2Temperature>> temperatures_;
  // Topics of the lights, in the order of RobotModel::leds.
  std::vector<std::unique_ptr<Ros2Number>> lights_;
  std::vector<double> last_lights_;  // brightness values that were published last
  int64_t last_sound_ = -1;          // number of the frame whose sound was published last
  Picture picture_;
};

}  // namespace openr_host
