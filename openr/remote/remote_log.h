// Collects the log of a motion from a robot, by the remote control.
#pragma once

#include <cstdint>
#include <string>

namespace openr_host {

class RemoteClient;

// Reads records of the robot's log while a motion plays.  The functions throw the errors of
// RemoteClient; the client uses version 2 of the protocol from then on.
class RemoteLog {
 public:
  explicit RemoteLog(RemoteClient* client) : client_(client) {}

  // Leaves out the records that the robot has already.
  void SkipOld();

  // Reads the records that have come since the last call.  Returns the state of JointMover
  // (MoverState) after them.
  int Take();

  // The bytes of a log file: the header and all records that were read.
  std::string File() const;

  int count() const { return count_; }  // number of records that were read
  // Number of records that the robot has dropped before they were read.
  uint32_t lost() const { return lost_; }
  uint32_t frame() const { return frame_; }  // frame of the last answer

 private:
  RemoteClient* const client_;
  uint32_t next_ = 0;  // number of the next record
  uint32_t lost_ = 0;
  uint32_t frame_ = 0;
  int count_ = 0;
  std::string records_;
};

}  // namespace openr_host
