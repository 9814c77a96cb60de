#include "openr/motion/log_merge.h"

#include <fmt/format.h>

#include <cstdlib>
#include <stdexcept>
#include <utility>

namespace openr_host {
namespace {

// Throws std::runtime_error if the records with the index `i` of both logs are not from the same
// moment of the same motion.
void RequireSameMoment(const LogFile& real, const LogFile& other, size_t i) {
  const LogRecord& a = real.records[i];
  const LogRecord& b = other.records[i];
  if (a.key_frame != b.key_frame) {
    throw std::runtime_error(fmt::format(
        "record {} is of key frame {} of the first robot and {} of the other: they have not played "
        "the same motion",
        i, a.key_frame, b.key_frame));
  }
  // Does not compare the commanded positions in the first record of the logs of two robots, because
  // the robots got these commands before the motion, so they may differ.
  if (i == 0) return;
  const std::vector<const JointConstants*> joints = LoggedJoints(*real.robot);
  for (size_t j = 0; j < joints.size(); ++j) {
    if (std::abs(a.commanded_cdeg[j] - b.commanded_cdeg[j]) <= kSameCommandCdeg) continue;
    throw std::runtime_error(fmt::format(
        "key frame {}: {} was commanded to {:.2f} degrees by the first robot and to {:.2f} by the "
        "other: the files on their sticks differ",
        a.key_frame, joints[j]->name, a.commanded_cdeg[j] / 100.0, b.commanded_cdeg[j] / 100.0));
  }
}

}  // namespace

LogFile AsSimulated(LogFile log) {
  for (LogRecord& record : log.records) {
    record.simulated = std::exchange(record.measured, std::nullopt);
  }
  return log;
}

LogFile MergeLogs(const LogFile& real, const LogFile& other) {
  if (LoggedJoints(*real.robot).size() != LoggedJoints(*other.robot).size()) {
    throw std::runtime_error(fmt::format("the robots are an {} and an {}: their joints differ",
                                         real.robot->design, other.robot->design));
  }
  LogFile merged = real;
  for (size_t i = 0; i < real.records.size() && i < other.records.size(); ++i) {
    RequireSameMoment(real, other, i);
    merged.records[i].simulated = other.records[i].measured;
  }
  return merged;
}

}  // namespace openr_host
