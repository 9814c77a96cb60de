// Log files of motions: AIBO_1.1, the format of Hohl 2004, section 3.3.6.
//
// A file is the header of eight characters and one record for each measured key frame.  A record
// has (table 3.9, numbers are little-endian):
//
//   16 bits   key frame
//   16 bits   commanded position of each joint, 15 on the ERS-210
//   8 bits    number of measured values: 0, or 15 positions and 4 paws
//   16 bits   each measured value
//   8 bits    number of simulated values: 0, or 15 positions and 4 paws
//   16 bits   each simulated value
//
// Positions are in 0.01 degree, paws are 0 or 1 (table 3.10).  Joints and paws have the order of
// the robot model.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "RemoteLog.h"
#include "RobotDescription.h"

namespace openr_host {

// The measured or the simulated values of a record in the log of a motion.
struct LogValues {
  std::vector<int16_t> positions_cdeg;
  // Contact of each paw: left fore, left hind, right fore, right hind.
  std::array<uint16_t, RC_LOG_PAWS> paws{};
  bool operator==(const LogValues&) const = default;
};

struct LogRecord {
  int key_frame = 0;  // number of the key frame, 0 to 32767
  std::vector<int16_t> commanded_cdeg;
  std::optional<LogValues> measured;   // values of the real robot
  std::optional<LogValues> simulated;  // values of the simulated robot
  bool operator==(const LogRecord&) const = default;
};

struct LogFile {
  // The robot of this log, which ParseLog() finds by the number of joints.
  const RobotConstants* robot = nullptr;
  std::vector<LogRecord> records;
};

// Returns the joints whose positions are in the log of a motion of `robot`: the joints that the
// motion files of Sony have.
std::vector<const JointConstants*> LoggedJoints(const RobotConstants& robot);

// Reads the bytes of a file with the log of a motion.  If the bytes are no such file, throws
// std::runtime_error with the place and the mistake, such as "offset 48: ...".
LogFile ParseLog(const std::string& bytes);

// Returns the bytes of the file for the log of a motion.  REQUIRES: each record has one position
// for each joint of the log, and a key frame of 0 to 32767.
std::string FormatLog(const LogFile& log);

}  // namespace openr_host
