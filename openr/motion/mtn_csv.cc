#include "openr/motion/mtn_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "virtualrobot/base/det_math.h"

namespace openr_host {
namespace {

constexpr double kDegPerUradOfCsv = Degrees(1e-6);
constexpr std::string_view kFirstColumns[] = {"key_frame", "time_ms", "roll_deg", "pitch_deg",
                                              "yaw_deg"};
constexpr size_t kFirstAngle = 2;  // index of the column roll_deg
constexpr size_t kFirstJoint = std::size(kFirstColumns);

std::vector<std::string_view> Split(std::string_view line) {
  std::vector<std::string_view> fields;
  for (;;) {
    const size_t comma = line.find(',');
    fields.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) return fields;
    line.remove_prefix(comma + 1);
  }
}

class CsvReader {
 public:
  explicit CsvReader(std::string_view text) : text_(text) {}

  MotionFile Read() {
    if (!NextLine()) throw std::runtime_error("line 1: the file is empty");
    ReadHeader();
    int time_ms = 0;
    while (NextLine()) time_ms = ReadKeyFrame(time_ms);
    if (motion_.key_frames.empty())
      throw std::runtime_error("line 2: a motion has at least one key frame");
    return std::move(motion_);
  }

 private:
  // Reads the next line of the CSV text that is not empty, and puts its fields into fields_.
  // Returns false at the end of the text.
  bool NextLine() {
    while (!text_.empty()) {
      const size_t end = std::min(text_.find('\n'), text_.size());
      std::string_view line = text_.substr(0, end);
      text_.remove_prefix(std::min(end + 1, text_.size()));
      ++line_;
      if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
      if (line.empty()) continue;
      fields_ = Split(line);
      return true;
    }
    return false;
  }

  void ReadHeader() {
    for (size_t i = 0; i < kFirstJoint; ++i) {
      if (i < fields_.size() && fields_[i] == kFirstColumns[i]) continue;
      throw std::runtime_error(
          fmt::format("line {}: the columns of a motion begin with {}", line_,
                      "key_frame,time_ms,roll_deg,pitch_deg,yaw_deg, then the joints' locators"));
    }
    for (size_t i = kFirstJoint; i < fields_.size(); ++i) {
      const std::string locator(fields_[i]);
      if (locator.empty() || locator.size() > 255) Refuse(i, "is no locator of a joint");
      if (std::find(motion_.locators.begin(), motion_.locators.end(), locator) !=
          motion_.locators.end()) {
        Refuse(i, "joint is listed twice");
      }
      motion_.locators.push_back(locator);
    }
    const size_t joints = motion_.locators.size();
    if (joints >= 1 && joints <= static_cast<size_t>(MTN_MAX_JOINTS)) return;
    throw std::runtime_error(
        fmt::format("line {}: {} joints, must be 1 to {}", line_, joints, MTN_MAX_JOINTS));
  }

  // Reads the fields of a CSV line as a key frame of a motion and adds the key frame to the motion.
  // Returns the time of the key frame.
  int ReadKeyFrame(int last_ms) {
    if (fields_.size() != kFirstJoint + motion_.locators.size()) {
      throw std::runtime_error(fmt::format("line {}: has {} fields, the first line has {}", line_,
                                           fields_.size(), kFirstJoint + motion_.locators.size()));
    }
    const size_t number = motion_.key_frames.size();
    if (Integer(0) != static_cast<int>(number)) Refuse(0, fmt::format("must be {}", number));
    if (number == static_cast<size_t>(MTN_MAX_KEYFRAMES))
      Refuse(0, fmt::format("a motion has at most {} key frames", MTN_MAX_KEYFRAMES));
    KeyFrame frame;
    const int time_ms = Integer(1);
    frame.interpolation = number == 0 ? FirstTime(time_ms) : GapOf(last_ms, time_ms);
    for (size_t axis = 0; axis < 3; ++axis)
      frame.attitude_urad[axis] = Angle(kFirstAngle + axis, MTN_MAX_ATTITUDE_URAD);
    for (size_t j = 0; j < motion_.locators.size(); ++j) frame.angles_urad.push_back(JointValue(j));
    motion_.key_frames.push_back(frame);
    return time_ms;
  }

  int FirstTime(int time_ms) const {
    if (time_ms != 0) Refuse(1, "must be 0 at the first key frame");
    return 0;
  }

  // Returns the number of interpolated frames between two key frames at the times `last_ms` and
  // `time_ms`.
  int GapOf(int last_ms, int time_ms) const {
    const int64_t gap_ms = int64_t{time_ms} - last_ms;
    if (gap_ms < MTN_FRAME_MS || gap_ms % MTN_FRAME_MS != 0) {
      Refuse(1,
             fmt::format("is {} ms after the key frame before, must be 16 ms or a multiple of it",
                         gap_ms));
    }
    if (gap_ms / MTN_FRAME_MS - 1 > MTN_MAX_INTERPOLATION) {
      Refuse(1, fmt::format("is {} ms after the key frame before, at most {} make sense", gap_ms,
                            (MTN_MAX_INTERPOLATION + 1) * MTN_FRAME_MS));
    }
    return static_cast<int>(gap_ms / MTN_FRAME_MS - 1);
  }

  int32_t JointValue(size_t joint) const {
    const size_t column = kFirstJoint + joint;
    if (!HasTwoPositions(motion_.locators[joint])) return Angle(column, MTN_MAX_ANGLE_URAD);
    const int position = Integer(column);
    if (position != 0 && position != 1) Refuse(column, "an ear is 0 or 1");
    return position;
  }

  int32_t Angle(size_t column, int32_t bound_urad) const {
    const std::string_view field = fields_[column];
    double deg = 0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), deg);
    if (error != std::errc() || end != field.data() + field.size())
      Refuse(column, "is no number of degrees");
    const double urad = deg / kDegPerUradOfCsv;
    if (!(std::abs(urad) <= bound_urad))
      Refuse(column, fmt::format("beyond +-{:.0f} degrees no angle makes sense",
                                 bound_urad * kDegPerUradOfCsv));
    return static_cast<int32_t>(std::lround(urad));
  }

  int Integer(size_t column) const {
    const std::string_view field = fields_[column];
    int value = 0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (error != std::errc() || end != field.data() + field.size())
      Refuse(column, "is no whole number");
    return value;
  }

  [[noreturn]] void Refuse(size_t column, const std::string& why) const {
    const std::string name = column < kFirstJoint ? std::string(kFirstColumns[column])
                             : column - kFirstJoint < motion_.locators.size()
                                 ? motion_.locators[column - kFirstJoint]
                                 : fmt::format("{}", column + 1);
    throw std::runtime_error(fmt::format("line {}, column {}: '{}' {}", line_, name,
                                         fields_[column].substr(0, 80), why));
  }

  std::string_view text_;  // the part of the text that was not read yet
  int line_ = 0;           // number of the line in fields_, from 1
  std::vector<std::string_view> fields_;
  MotionFile motion_;
};

}  // namespace

bool HasTwoPositions(const std::string& locator) {
  return locator.find("-Joint3:") != std::string::npos ||
         locator.find("-Joint4:") != std::string::npos;
}

std::string CsvOf(const MtnFile& motion) {
  std::string text = "key_frame,time_ms,roll_deg,pitch_deg,yaw_deg";
  for (int j = 0; j < motion.NumJoints(); ++j) text += "," + motion.Locator(j);
  text += "\n";
  for (int k = 0; k < motion.NumKeyFrames(); ++k) {
    text += fmt::format("{},{}", k, motion.TimeMs(k));
    for (int a = 0; a < 3; ++a)
      text += fmt::format(",{:.5f}", motion.Attitude(k, a) * kDegPerUradOfCsv);
    for (int j = 0; j < motion.NumJoints(); ++j) {
      if (HasTwoPositions(motion.Locator(j))) {
        text += motion.Angle(k, j) == 0 ? ",0" : ",1";
      } else {
        // Five decimals are finer than 1 urad, so ParseMotionCsv() gets the same angle back.
        text += fmt::format(",{:.5f}", motion.Angle(k, j) * kDegPerUradOfCsv);
      }
    }
    text += "\n";
  }
  return text;
}

MotionFile ParseMotionCsv(const std::string& text) { return CsvReader(text).Read(); }

}  // namespace openr_host
