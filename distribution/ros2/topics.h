// What a robot tells on topics of ROS 2, and what it hears: plain data in, messages out.
//
// Times are virtual, in microseconds since the boot; angles radians, the rest SI units; axes x
// forward, y left, z up.  Topics are named without the slash in front: "aibo/imu".  The types are
// those of idl/.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "distribution/ros2/endpoint.h"

namespace openr_host {

// rosgraph_msgs/Clock
class Ros2Clock {
 public:
  Ros2Clock(Bus* bus, const std::string& topic);
  void Publish(int64_t time_us);

 private:
  Ros2Writer writer_;
};

// sensor_msgs/JointState; efforts are not known.
class Ros2JointStates {
 public:
  Ros2JointStates(Bus* bus, const std::string& topic, std::vector<std::string> joints);
  // In the order of the names.
  void Publish(int64_t time_us, const std::vector<double>& position_rad,
               const std::vector<double>& velocity_rad_s);

 private:
  Ros2Writer writer_;
  const std::vector<std::string> joints_;
};

// sensor_msgs/Imu of an accelerometer alone: orientation and rates are marked as not measured.
class Ros2Imu {
 public:
  Ros2Imu(Bus* bus, const std::string& topic, std::string frame_id);
  void Publish(int64_t time_us, const std::array<double, 3>& acceleration_m_s2);

 private:
  Ros2Writer writer_;
  const std::string frame_id_;
};

// sensor_msgs/Image, "rgb8"
class Ros2Image {
 public:
  Ros2Image(Bus* bus, const std::string& topic, std::string frame_id);
  bool HasReaders() const { return writer_.HasReaders(); }
  // REQUIRES: 3 * width * height bytes, row by row from the top left.
  void Publish(int64_t time_us, int width, int height, const std::vector<uint8_t>& rgb);

 private:
  Ros2Writer writer_;
  const std::string frame_id_;
};

// std_msgs/Bool
class Ros2Switch {
 public:
  Ros2Switch(Bus* bus, const std::string& topic);
  void Publish(bool is_on);

 private:
  Ros2Writer writer_;
};

// std_msgs/Float32
class Ros2Number {
 public:
  Ros2Number(Bus* bus, const std::string& topic);
  void Publish(double value);

 private:
  Ros2Writer writer_;
};

// What somebody wants joints to do: as it came, not looked at.
struct Ros2JointCommand {
  std::vector<std::string> joints;
  std::vector<double> position_rad;
  std::vector<double> velocity_rad_s;
};

// sensor_msgs/JointState
class Ros2JointCommands {
 public:
  static constexpr int kWaitingMax = 32;     // messages; older ones are lost
  static constexpr size_t kJointsMax = 256;  // of a message; the rest is left out
  static constexpr size_t kNameMax = 256;    // characters; the same

  Ros2JointCommands(Bus* bus, const std::string& topic);
  bool HasMisfit() const { return reader_.HasMisfit(); }
  // The next one; nullopt when there is none.
  std::optional<Ros2JointCommand> Take();

 private:
  Ros2Reader reader_;
};

}  // namespace openr_host
