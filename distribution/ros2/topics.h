// Publishes the state of a robot on ROS 2 topics and receives commands for the robot.  Callers use
// plain data and no types of ROS 2.
//
// Times are virtual, in microseconds since the boot.  Angles are in radians, all else in SI units;
// x is forward, y left, z up.  Topics are named without the leading slash: "aibo/imu".  The message
// types are in idl/.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "distribution/ros2/endpoint.h"

namespace openr_host {

// Publishes the virtual time of the run as rosgraph_msgs/Clock.
class Ros2Clock {
 public:
  Ros2Clock(Bus* bus, const std::string& topic);
  void Publish(int64_t time_us);

 private:
  Ros2Writer writer_;
};

// Publishes the angles and speeds of joints as sensor_msgs/JointState.  The joints' efforts
// (torques) are left out, because they are not known.
class Ros2JointStates {
 public:
  Ros2JointStates(Bus* bus, const std::string& topic, std::vector<std::string> joints);
  // Publishes one state.  The values are in the order of `joints`, the argument of the constructor.
  void Publish(int64_t time_us, const std::vector<double>& position_rad,
               const std::vector<double>& velocity_rad_s);

 private:
  Ros2Writer writer_;
  const std::vector<std::string> joints_;
};

// Publishes the values of an accelerometer as sensor_msgs/Imu.  Orientation and angular rates are
// marked as not measured.
class Ros2Imu {
 public:
  Ros2Imu(Bus* bus, const std::string& topic, std::string frame_id);
  void Publish(int64_t time_us, const std::array<double, 3>& acceleration_m_s2);

 private:
  Ros2Writer writer_;
  const std::string frame_id_;
};

// Publishes pictures as sensor_msgs/Image with the encoding "rgb8".
class Ros2Image {
 public:
  Ros2Image(Bus* bus, const std::string& topic, std::string frame_id);
  bool HasReaders() const { return writer_.HasReaders(); }
  // Publishes one picture.  REQUIRES: `rgb` has 3 * width * height bytes, row by row from the top
  // left.
  void Publish(int64_t time_us, int width, int height, const std::vector<uint8_t>& rgb);

 private:
  Ros2Writer writer_;
  const std::string frame_id_;
};

// Publishes the state of a switch as std_msgs/Bool.
class Ros2Switch {
 public:
  Ros2Switch(Bus* bus, const std::string& topic);
  void Publish(bool is_on);

 private:
  Ros2Writer writer_;
};

// Publishes a number as std_msgs/Float32.
class Ros2Number {
 public:
  Ros2Number(Bus* bus, const std::string& topic);
  void Publish(double value);

 private:
  Ros2Writer writer_;
};

// Publishes a temperature as sensor_msgs/Temperature.
class Ros2Temperature {
 public:
  Ros2Temperature(Bus* bus, const std::string& topic, std::string frame_id);
  void Publish(int64_t time_us, double celsius);

 private:
  Ros2Writer writer_;
  const std::string frame_id_;
};

// Publishes texts as std_msgs/String.
class Ros2Text {
 public:
  Ros2Text(Bus* bus, const std::string& topic, LateReaders late = LateReaders::kMissSamples);
  void Publish(const std::string& text);

 private:
  Ros2Writer writer_;
};

// The pose and the speeds of a robot's base frame.
struct Ros2Motion {
  std::array<double, 3> position_m{};          // position of the base frame in the fixed frame
  std::array<double, 4> rotation{0, 0, 0, 1};  // quaternion x, y, z, w
  std::array<double, 3> speed_m_s{};           // velocity, in the axes of the base frame
  std::array<double, 3> turning_rad_s{};       // angular velocity, in the axes of the base frame
};

// Publishes nav_msgs/Odometry, and the same pose as tf2_msgs/TFMessage on the topic "tf".
// `fixed_frame` and `base_frame` are names of frames: "aibo/odom", "aibo/base_link".
class Ros2Odometry {
 public:
  Ros2Odometry(Bus* bus, const std::string& topic, std::string fixed_frame, std::string base_frame);
  void Publish(int64_t time_us, const Ros2Motion& motion);

 private:
  Ros2Writer odometry_;
  Ros2Writer transforms_;
  const std::string fixed_frame_;
  const std::string base_frame_;
};

struct Ros2BatteryValues {
  float voltage_v = 0, current_a = 0, temperature_c = 0;
  float capacity_ah = 0;  // capacity of the full battery
  float share = 0;        // share of the capacity that remains, 0 to 1
  bool is_charging = false;
};

// Publishes the state of the battery as sensor_msgs/BatteryState.
class Ros2Battery {
 public:
  Ros2Battery(Bus* bus, const std::string& topic);
  void Publish(int64_t time_us, const Ros2BatteryValues& values);

 private:
  Ros2Writer writer_;
};

// Publishes sound as audio_common_msgs/AudioData, 16 bits a sample, mono.  Publishes the format of
// the sound as audio_common_msgs/AudioInfo on the topic `topic` + "_info".
class Ros2Sound {
 public:
  Ros2Sound(Bus* bus, const std::string& topic, int rate_hz);
  void Publish(const std::vector<int16_t>& samples);

 private:
  Ros2Writer sound_;
  Ros2Writer info_;
};

// An entry of ROS 2 diagnostics: the state of a part of the robot or of the run, with values that
// describe it.
struct Ros2Status {
  enum Level : uint8_t { kGood = 0, kWarning = 1, kError = 2 };
  Level level = kGood;
  std::string name;
  std::string message;
  std::vector<std::pair<std::string, std::string>> values;
};

// Publishes entries of diagnostics (Ros2Status) as diagnostic_msgs/DiagnosticArray.
class Ros2Diagnostics {
 public:
  Ros2Diagnostics(Bus* bus, const std::string& topic);
  bool HasReaders() const { return writer_.HasReaders(); }
  // Publishes `statuses`.  `hardware` is the name of the device that all of them describe.
  void Publish(int64_t time_us, const std::string& hardware,
               const std::vector<Ros2Status>& statuses);

 private:
  Ros2Writer writer_;
};

// Receives texts as std_msgs/String.
class Ros2Texts {
 public:
  // Largest number of texts that wait for Take().  If more texts arrive, the oldest are lost.
  static constexpr int kWaitingMax = 32;
  // Largest number of characters of a text from a ROS 2 topic; the rest is cut off, because the
  // network must not fill the memory of the run.
  static constexpr size_t kTextMax = 65536;

  Ros2Texts(Bus* bus, const std::string& topic);
  bool HasIncompatibleWriter() const { return reader_.HasIncompatibleWriter(); }
  // Returns the next text that was received on the ROS 2 topic; nullopt when there is none.
  std::optional<std::string> Take();

 private:
  Ros2Reader reader_;
};

// A received command for joints.  Names and values are as received and not checked.
struct Ros2JointCommand {
  std::vector<std::string> joints;
  std::vector<double> position_rad;
  std::vector<double> velocity_rad_s;
};

// Receives sensor_msgs/JointState as commands for joints.  Messages come from the network and may
// have any size, so the number and the size of kept messages are limited.
class Ros2JointCommands {
 public:
  // Largest number of messages that wait for Take().  If more messages arrive, the oldest are lost.
  static constexpr int kWaitingMax = 32;
  // Largest number of joints in a message; further joints are ignored.
  static constexpr size_t kJointsMax = 256;
  // Largest number of characters of a joint's name; the rest is cut off.
  static constexpr size_t kNameMax = 256;

  Ros2JointCommands(Bus* bus, const std::string& topic);
  bool HasIncompatibleWriter() const { return reader_.HasIncompatibleWriter(); }
  // Returns the next command that was received on the ROS 2 topic; nullopt when there is none.
  std::optional<Ros2JointCommand> Take();

 private:
  Ros2Reader reader_;
};

}  // namespace openr_host
