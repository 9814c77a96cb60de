//
// The log of motions over the remote control (version 2): records as in Hohl 2004, table 3.9.
//
// A record has these little-endian numbers, of 16 bits unless noted:
//
//   key frame
//   commanded positions, one for each joint of the log
//   8 bits: number of measured values, which is the number of joints plus 4
//   measured positions of the same joints, then the switches of the four paws, 0 or 1
//   8 bits: number of simulated values, always 0; a client may add simulated values
//
// The joints of the log are the joints of the vendor's motion files, 15 on the ERS-210, in the
// order of RobotConstants::joints.  Positions are in 0.01 degree.
//

#ifndef RemoteLog_h_DEFINED
#define RemoteLog_h_DEFINED

#include "FixedTypes.h"
#include "RemotePacket.h"
#include "RobotDescription.h"

// The text at the beginning of a file with the log of motions, before the records.
#define RC_LOG_HEADER "AIBO_1.1"

// Record number in a request LOG that asks only for the number of records so far, and for none of
// the records.
const Uint32 RC_LOG_END = 0xffffffff;

const int RC_LOG_PAWS = 4;

// Size, in bytes, of a record in the log of motions when the log has `numJoints` joints.  A record
// is for one key frame (posture) that a motion has reached.
inline int
LogRecordSize(int numJoints)
{
    return 2 + 2 * numJoints + 1 + 2 * (numJoints + RC_LOG_PAWS) + 1;
}

const int RC_MAX_LOG_RECORD = 2 + 2 * MAX_JOINTS + 1 + 2 * (MAX_JOINTS + RC_LOG_PAWS) + 1;

// The head of an answer to LOG, the request for the log of motions.  The records of the log follow
// this head.
struct RcLogHead {
    Uint32 count;  // number of records since the robot has booted
    Uint32 first;  // number of the first record in this answer
    Uint8 state;   // a value of MoverState
    Uint8 here;    // number of records in this answer
    Uint16 size;   // size of a record, in bytes

    static const int SIZE = 12;

    void Write(RcWriter* out) const;
    void Read(RcReader* in);  // reads the fields above, but not the records
};

#endif  // RemoteLog_h_DEFINED
