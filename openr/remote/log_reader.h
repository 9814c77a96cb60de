// LogReader, which collects the log of a motion from a robot.
#pragma once

#include <cstdint>
#include <string>

namespace openr::remote {

class Connection;

// Reads the log of a motion from a robot.  For each key frame that the robot reports while a motion
// plays, the log has a record with the positions of the joints.  The robot keeps the last 256
// records, 8 s of a motion with vectors of the usual length.  Functions throw the errors of
// Connection.
class LogReader {
 public:
  // Makes a reader for the robot of `connection`, which must outlive the reader.
  explicit LogReader(Connection* connection) : connection_(connection) {}

  // Skips the records of a motion's log that the robot has made before this call.
  void SkipOld();

  // Reads the records that the robot has added to the log of the motion since the last call.
  // Returns the state of JointMover (MoverState) after the last of these records.
  int ReadNewRecords();

  // Returns the bytes of a log file (Hohl 2004, table 3.9): the header, and all records that were
  // read from the robot.
  std::string File() const;

  int count() const { return count_; }  // number of records that were read
  // Returns the number of records of a motion's log that the robot has dropped before they were
  // read.
  uint32_t lost() const { return lost_; }
  uint32_t frame() const { return frame_; }  // frame number in the robot's last answer

 private:
  Connection* const connection_;
  uint32_t next_ = 0;  // number of the next record to read
  uint32_t lost_ = 0;
  uint32_t frame_ = 0;
  int count_ = 0;
  std::string records_;
};

}  // namespace openr::remote
