#include "openr/motion/log_file.h"

#include <fmt/format.h>

#include <stdexcept>
#include <string_view>

#include "runtime/base/assert.h"

namespace openr_host {
namespace {

constexpr std::string_view kHeader = RC_LOG_HEADER;
constexpr int kKeyFrameMax = 32767;
constexpr const char* kPawNames[RC_LOG_PAWS] = {"left fore", "left hind", "right fore",
                                                "right hind"};

// Reads the records of a log of a motion.  The constructor gets the robot's number of joints,
// because a log file has neither this number nor the name of the robot.
class LogReader {
 public:
  LogReader(std::string_view bytes, int joints) : bytes_(bytes), joints_(joints) {}

  std::vector<LogRecord> ReadAll() {
    if (bytes_.substr(0, kHeader.size()) != kHeader) {
      throw std::runtime_error(
          fmt::format("offset 0: a log file begins with '{}', this one does not", kHeader));
    }
    at_ = kHeader.size();
    std::vector<LogRecord> records;
    while (at_ < bytes_.size()) {
      number_ = records.size();
      records.push_back(ReadRecord());
    }
    return records;
  }

 private:
  LogRecord ReadRecord() {
    LogRecord record;
    record.key_frame = static_cast<int16_t>(U16("its key frame"));
    if (record.key_frame < 0)
      Refuse(at_ - 2, fmt::format("key frame is {}, must be 0 to 32767", record.key_frame));
    record.commanded_cdeg = Positions("its commanded positions");
    record.measured = ReadGroup("measured");
    record.simulated = ReadGroup("simulated");
    return record;
  }

  std::optional<LogValues> ReadGroup(const char* group) {
    Require(1, fmt::format("the number of its {} values", group));
    const int count = static_cast<uint8_t>(bytes_[at_++]);
    if (count == 0) return std::nullopt;
    if (count != joints_ + RC_LOG_PAWS) {
      Refuse(at_ - 1, fmt::format("says {} {} values, must be 0 or {}", count, group,
                                  joints_ + RC_LOG_PAWS));
    }
    LogValues values;
    values.positions_cdeg = Positions(fmt::format("its {} positions", group));
    for (size_t i = 0; i < values.paws.size(); ++i) {
      values.paws[i] = U16(fmt::format("its {} paws", group));
      if (values.paws[i] <= 1) continue;
      Refuse(at_ - 2,
             fmt::format("{} paw {} is {}, must be 0 or 1", group, kPawNames[i], values.paws[i]));
    }
    return values;
  }

  std::vector<int16_t> Positions(const std::string& what) {
    Require(2 * static_cast<size_t>(joints_), what);
    std::vector<int16_t> positions;
    for (int j = 0; j < joints_; ++j) positions.push_back(static_cast<int16_t>(U16(what)));
    return positions;
  }

  uint16_t U16(const std::string& what) {
    Require(2, what);
    const auto low = static_cast<uint8_t>(bytes_[at_]),
               high = static_cast<uint8_t>(bytes_[at_ + 1]);
    at_ += 2;
    return static_cast<uint16_t>(low | high << 8);
  }

  void Require(size_t size, const std::string& what) const {
    if (bytes_.size() - at_ >= size) return;
    Refuse(at_, fmt::format("the file ends, {} of {} bytes of {} are there", bytes_.size() - at_,
                            size, what));
  }

  [[noreturn]] void Refuse(size_t at, const std::string& why) const {
    throw std::runtime_error(fmt::format("offset {}: record {}: {}", at, number_, why));
  }

  const std::string_view bytes_;
  const int joints_;
  size_t at_ = 0;
  size_t number_ = 0;  // number of the record that is being read
};

void AppendU16(int value, std::string* out) {
  out->push_back(static_cast<char>(value & 0xff));
  out->push_back(static_cast<char>(value >> 8 & 0xff));
}

void AppendGroup(const std::optional<LogValues>& values, size_t joints, std::string* out) {
  if (!values) {
    out->push_back(0);
    return;
  }
  ASSERT(values->positions_cdeg.size() == joints, "{} positions", values->positions_cdeg.size());
  out->push_back(static_cast<char>(joints + values->paws.size()));
  for (const int16_t position : values->positions_cdeg) AppendU16(position, out);
  for (const uint16_t paw : values->paws) AppendU16(paw, out);
}

}  // namespace

std::vector<const JointConstants*> LoggedJoints(const RobotConstants& robot) {
  std::vector<const JointConstants*> joints;
  for (int j = 0; j < robot.numJoints; ++j) {
    if (robot.joints[j].mtnIndex >= 0) joints.push_back(&robot.joints[j]);
  }
  return joints;
}

// Tries each design of robot, because a log file does not name its robot.  With a wrong number of
// joints, the reader looks for the counts of values at wrong places and usually refuses the numbers
// that it finds there.
LogFile ParseLog(const std::string& bytes) {
  std::string problem;
  for (const char* const design : {"ERS-210", "ERS-7"}) {
    LogFile log;
    log.robot = FindRobot(design);
    try {
      log.records = LogReader(bytes, static_cast<int>(LoggedJoints(*log.robot).size())).ReadAll();
      return log;
    } catch (const std::runtime_error& error) {
      if (problem.empty())
        // Keeps the error of the first design, the ERS-210, for the user, because Hohl 2004
        // describes the format for this robot.
        problem = error.what();
    }
  }
  throw std::runtime_error(problem);
}

std::string FormatLog(const LogFile& log) {
  const size_t joints = LoggedJoints(*log.robot).size();
  std::string out(kHeader);
  for (const LogRecord& record : log.records) {
    ASSERT(record.key_frame >= 0 && record.key_frame <= kKeyFrameMax, "{}", record.key_frame);
    ASSERT(record.commanded_cdeg.size() == joints, "{} positions", record.commanded_cdeg.size());
    AppendU16(record.key_frame, &out);
    for (const int16_t position : record.commanded_cdeg) AppendU16(position, &out);
    AppendGroup(record.measured, joints, &out);
    AppendGroup(record.simulated, joints, &out);
  }
  return out;
}

}  // namespace openr_host
