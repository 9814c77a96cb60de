#include "distribution/ros2/topics.h"

#include <string.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "audio_common_msgs.h"
#include "diagnostic_msgs.h"
#include "geometry_msgs.h"
#include "nav_msgs.h"
#include "rosgraph_msgs.h"
#include "runtime/base/assert.h"
#include "sensor_msgs.h"
#include "std_msgs.h"
#include "tf2_msgs.h"

namespace openr_host {
namespace {

// Number of the newest messages that a writer keeps for slow readers, for each kind of topic.  For
// sensor data we keep 5 messages, as ROS 2 does.  We keep fewer images, because they are large, and
// only one message of the clock, because only the newest time matters.
constexpr int kSensorDepth = 5;
constexpr int kImageDepth = 2;
constexpr int kClockDepth = 1;
constexpr int kSoundDepth = 50;  // enough messages for 0.4 s of sound

constexpr int64_t kUsPerSecond = 1'000'000;

builtin_interfaces_msg_dds__Time_ TimeOf(int64_t time_us) {
  return {static_cast<int32_t>(time_us / kUsPerSecond),
          static_cast<uint32_t>(time_us % kUsPerSecond * 1000)};
}

// Returns the characters of `text` without const, as samples need them.  This is safe, because
// writers only read a sample.
char* Text(const std::string& text) { return const_cast<char*>(text.c_str()); }

template <typename Sequence, typename Element>
Sequence Borrowed(const std::vector<Element>& elements) {
  const auto count = static_cast<uint32_t>(elements.size());
  return {count, count, const_cast<Element*>(elements.data()), false};
}

// Makes the header of a ROS 2 message.  The header points to `frame_id`, so `frame_id` must outlive
// the header.
std_msgs_msg_dds__Header_ HeaderOf(int64_t time_us, const char* frame_id) {
  return {TimeOf(time_us), const_cast<char*>(frame_id)};
}

// Returns the length of a received sequence.  The length is limited, because it comes from the
// network.
template <typename Sequence>
size_t CountOf(const Sequence& sequence) {
  return std::min(size_t{sequence._length}, Ros2JointCommands::kJointsMax);
}

std::vector<std::string> Copied(const dds_sequence_string& names) {
  std::vector<std::string> copied;
  for (size_t i = 0; i < CountOf(names); ++i) {
    const char* const name = names._buffer[i];
    copied.emplace_back(name, strnlen(name, Ros2JointCommands::kNameMax));
  }
  return copied;
}

std::vector<double> Copied(const dds_sequence_double& values) {
  return {values._buffer, values._buffer + CountOf(values)};
}

}  // namespace

Ros2Clock::Ros2Clock(Bus* bus, const std::string& topic)
    : writer_(bus, rosgraph_msgs_msg_dds__Clock__desc, topic, kClockDepth) {}

void Ros2Clock::Publish(int64_t time_us) {
  const rosgraph_msgs_msg_dds__Clock_ sample = {TimeOf(time_us)};
  writer_.Write(&sample);
}

Ros2JointStates::Ros2JointStates(Bus* bus, const std::string& topic,
                                 std::vector<std::string> joints)
    : writer_(bus, sensor_msgs_msg_dds__JointState__desc, topic, kSensorDepth),
      joints_(std::move(joints)) {}

void Ros2JointStates::Publish(int64_t time_us, const std::vector<double>& position_rad,
                              const std::vector<double>& velocity_rad_s) {
  std::vector<char*> names;
  for (const std::string& joint : joints_) names.push_back(Text(joint));
  sensor_msgs_msg_dds__JointState_ sample{};
  sample.header_ = HeaderOf(time_us, "");
  sample.name_ = Borrowed<dds_sequence_string>(names);
  sample.position_ = Borrowed<dds_sequence_double>(position_rad);
  sample.velocity_ = Borrowed<dds_sequence_double>(velocity_rad_s);
  writer_.Write(&sample);
}

Ros2Imu::Ros2Imu(Bus* bus, const std::string& topic, std::string frame_id)
    : writer_(bus, sensor_msgs_msg_dds__Imu__desc, topic, kSensorDepth),
      frame_id_(std::move(frame_id)) {}

void Ros2Imu::Publish(int64_t time_us, const std::array<double, 3>& acceleration_m_s2) {
  sensor_msgs_msg_dds__Imu_ sample{};
  sample.header_ = HeaderOf(time_us, frame_id_.c_str());
  sample.orientation_.w_ = 1;
  // Marks the covariances as not measured: -1 as the first number means this (sensor_msgs/Imu).
  sample.orientation_covariance_[0] = -1;
  sample.angular_velocity_covariance_[0] = -1;
  sample.linear_acceleration_ = {acceleration_m_s2[0], acceleration_m_s2[1], acceleration_m_s2[2]};
  writer_.Write(&sample);
}

Ros2Image::Ros2Image(Bus* bus, const std::string& topic, std::string frame_id)
    : writer_(bus, sensor_msgs_msg_dds__Image__desc, topic, kImageDepth),
      frame_id_(std::move(frame_id)) {}

void Ros2Image::Publish(int64_t time_us, int width, int height, const std::vector<uint8_t>& rgb) {
  ASSERT(width >= 0 && height >= 0 && rgb.size() == size_t{3} * width * height,
         "{} bytes for {} x {} pixels", rgb.size(), width, height);
  static const std::string encoding = "rgb8";
  sensor_msgs_msg_dds__Image_ sample{};
  sample.header_ = HeaderOf(time_us, frame_id_.c_str());
  sample.height_ = static_cast<uint32_t>(height);
  sample.width_ = static_cast<uint32_t>(width);
  sample.encoding_ = Text(encoding);
  sample.step_ = 3 * sample.width_;
  sample.data_ = Borrowed<dds_sequence_octet>(rgb);
  writer_.Write(&sample);
}

Ros2Switch::Ros2Switch(Bus* bus, const std::string& topic)
    : writer_(bus, std_msgs_msg_dds__Bool__desc, topic, kSensorDepth) {}

void Ros2Switch::Publish(bool is_on) {
  const std_msgs_msg_dds__Bool_ sample = {is_on};
  writer_.Write(&sample);
}

Ros2Number::Ros2Number(Bus* bus, const std::string& topic)
    : writer_(bus, std_msgs_msg_dds__Float32__desc, topic, kSensorDepth) {}

void Ros2Number::Publish(double value) {
  const std_msgs_msg_dds__Float32_ sample = {static_cast<float>(value)};
  writer_.Write(&sample);
}

Ros2Temperature::Ros2Temperature(Bus* bus, const std::string& topic, std::string frame_id)
    : writer_(bus, sensor_msgs_msg_dds__Temperature__desc, topic, kSensorDepth),
      frame_id_(std::move(frame_id)) {}

void Ros2Temperature::Publish(int64_t time_us, double celsius) {
  sensor_msgs_msg_dds__Temperature_ sample{};
  sample.header_ = HeaderOf(time_us, frame_id_.c_str());
  sample.temperature_ = celsius;
  writer_.Write(&sample);
}

Ros2Text::Ros2Text(Bus* bus, const std::string& topic, LateReaders late)
    : writer_(bus, std_msgs_msg_dds__String__desc, topic,
              late == LateReaders::kGetNewest ? 1 : kSensorDepth, late) {}

void Ros2Text::Publish(const std::string& text) {
  const std_msgs_msg_dds__String_ sample = {Text(text)};
  writer_.Write(&sample);
}

Ros2Odometry::Ros2Odometry(Bus* bus, const std::string& topic, std::string fixed_frame,
                           std::string base_frame)
    : odometry_(bus, nav_msgs_msg_dds__Odometry__desc, topic, kSensorDepth),
      transforms_(bus, tf2_msgs_msg_dds__TFMessage__desc, "tf", kSensorDepth),
      fixed_frame_(std::move(fixed_frame)),
      base_frame_(std::move(base_frame)) {}

void Ros2Odometry::Publish(int64_t time_us, const Ros2Motion& motion) {
  const auto& [x, y, z] = motion.position_m;
  const geometry_msgs_msg_dds__Quaternion_ rotation = {motion.rotation[0], motion.rotation[1],
                                                       motion.rotation[2], motion.rotation[3]};
  nav_msgs_msg_dds__Odometry_ sample{};
  sample.header_ = HeaderOf(time_us, fixed_frame_.c_str());
  sample.child_frame_id_ = Text(base_frame_);
  sample.pose_.pose_ = {{x, y, z}, rotation};
  sample.twist_.twist_ = {
      {motion.speed_m_s[0], motion.speed_m_s[1], motion.speed_m_s[2]},
      {motion.turning_rad_s[0], motion.turning_rad_s[1], motion.turning_rad_s[2]}};
  odometry_.Write(&sample);
  const std::vector<geometry_msgs_msg_dds__TransformStamped_> transforms = {
      {sample.header_, sample.child_frame_id_, {{x, y, z}, rotation}}};
  const tf2_msgs_msg_dds__TFMessage_ all = {
      Borrowed<dds_sequence_geometry_msgs_msg_dds__TransformStamped_>(transforms)};
  transforms_.Write(&all);
}

Ros2Battery::Ros2Battery(Bus* bus, const std::string& topic)
    : writer_(bus, sensor_msgs_msg_dds__BatteryState__desc, topic, kSensorDepth) {}

void Ros2Battery::Publish(int64_t time_us, const Ros2BatteryValues& values) {
  // Values of POWER_SUPPLY_STATUS_ in sensor_msgs/BatteryState.
  enum { kCharging = 1, kDischarging = 2 };
  constexpr uint8_t kHealthGood = 1, kLithiumIon = 2;
  static const std::string nothing;
  sensor_msgs_msg_dds__BatteryState_ sample{};
  sample.header_ = HeaderOf(time_us, "");
  sample.voltage_ = values.voltage_v;
  sample.temperature_ = values.temperature_c;
  sample.current_ = values.current_a;
  sample.charge_ = values.capacity_ah * values.share;
  sample.capacity_ = values.capacity_ah;
  sample.design_capacity_ = std::numeric_limits<float>::quiet_NaN();
  sample.percentage_ = values.share;
  sample.power_supply_status_ = values.is_charging ? kCharging : kDischarging;
  sample.power_supply_health_ = kHealthGood;
  sample.power_supply_technology_ = kLithiumIon;
  sample.present_ = true;
  sample.location_ = Text(nothing);
  sample.serial_number_ = Text(nothing);
  writer_.Write(&sample);
}

Ros2Sound::Ros2Sound(Bus* bus, const std::string& topic, int rate_hz)
    : sound_(bus, audio_common_msgs_msg_dds__AudioData__desc, topic, kSoundDepth),
      info_(bus, audio_common_msgs_msg_dds__AudioInfo__desc, topic + "_info", 1,
            LateReaders::kGetNewest) {
  static const std::string format = "S16LE", coding = "wave";
  const audio_common_msgs_msg_dds__AudioInfo_ info = {1, static_cast<uint32_t>(rate_hz),
                                                      Text(format), 0, Text(coding)};
  info_.Write(&info);
}

void Ros2Sound::Publish(const std::vector<int16_t>& samples) {
  if (!sound_.HasReaders()) return;
  std::vector<uint8_t> bytes;
  for (const int16_t sample : samples) {
    bytes.push_back(static_cast<uint8_t>(sample & 0xff));
    bytes.push_back(static_cast<uint8_t>(sample >> 8 & 0xff));
  }
  const audio_common_msgs_msg_dds__AudioData_ data = {Borrowed<dds_sequence_octet>(bytes)};
  sound_.Write(&data);
}

Ros2Diagnostics::Ros2Diagnostics(Bus* bus, const std::string& topic)
    : writer_(bus, diagnostic_msgs_msg_dds__DiagnosticArray__desc, topic, kSensorDepth) {}

void Ros2Diagnostics::Publish(int64_t time_us, const std::string& hardware,
                              const std::vector<Ros2Status>& statuses) {
  std::vector<std::vector<diagnostic_msgs_msg_dds__KeyValue_>> values;
  for (const Ros2Status& status : statuses) {
    std::vector<diagnostic_msgs_msg_dds__KeyValue_>& of_status = values.emplace_back();
    for (const auto& [key, value] : status.values) of_status.push_back({Text(key), Text(value)});
  }
  std::vector<diagnostic_msgs_msg_dds__DiagnosticStatus_> samples;
  for (size_t i = 0; i < statuses.size(); ++i) {
    samples.push_back({statuses[i].level, Text(statuses[i].name), Text(statuses[i].message),
                       Text(hardware),
                       Borrowed<dds_sequence_diagnostic_msgs_msg_dds__KeyValue_>(values[i])});
  }
  const diagnostic_msgs_msg_dds__DiagnosticArray_ all = {
      HeaderOf(time_us, ""),
      Borrowed<dds_sequence_diagnostic_msgs_msg_dds__DiagnosticStatus_>(samples)};
  writer_.Write(&all);
}

Ros2Texts::Ros2Texts(Bus* bus, const std::string& topic)
    : reader_(bus, std_msgs_msg_dds__String__desc, topic, kWaitingMax) {}

std::optional<std::string> Ros2Texts::Take() {
  void* const sample = reader_.Take();
  if (sample == nullptr) return std::nullopt;
  const char* const data = static_cast<const std_msgs_msg_dds__String_*>(sample)->data_;
  std::string text(data, strnlen(data, kTextMax));
  reader_.Return(sample);
  return text;
}

Ros2JointCommands::Ros2JointCommands(Bus* bus, const std::string& topic)
    : reader_(bus, sensor_msgs_msg_dds__JointState__desc, topic, kWaitingMax) {}

std::optional<Ros2JointCommand> Ros2JointCommands::Take() {
  void* const sample = reader_.Take();
  if (sample == nullptr) return std::nullopt;
  const auto& message = *static_cast<const sensor_msgs_msg_dds__JointState_*>(sample);
  Ros2JointCommand command;
  command.joints = Copied(message.name_);
  command.position_rad = Copied(message.position_);
  command.velocity_rad_s = Copied(message.velocity_);
  reader_.Return(sample);
  return command;
}

}  // namespace openr_host
