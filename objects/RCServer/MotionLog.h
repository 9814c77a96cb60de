//
// MotionLog: the newest key frames that motions have reached, as records of Hohl 2004, table 3.9
// (RemoteLog.h).
//
// Records have numbers, counted from 0 since the robot has booted.  The last CAPACITY records are
// kept, so that several clients can read them, each at its own speed.
//

#ifndef MotionLog_h_DEFINED
#define MotionLog_h_DEFINED

#include "Messages.h"
#include "RemoteLog.h"
#include "SensorValues.h"

class MotionLog {
public:
    // Number of records that the log of motions keeps: 8 s of a motion with a record every 32 ms.
    static const int CAPACITY = 256;

    MotionLog() : robot_(0), numJoints_(0), count_(0) {}

    void Begin(const RobotConstants* robot);

    // Adds a record to the log of motions, with the key frame in `report`, if a motion plays.
    // Takes the state of the paws from `sensors`, the newest sensor values.
    void Add(const SetValueMessage& report, const SensorValues& sensors);

    // Returns the number of records that were added to the log of motions since the boot.
    Uint32 Count() const { return count_; }

    // Returns the number of the oldest record that the log of motions keeps.
    Uint32 Oldest() const { return count_ > (Uint32)CAPACITY ? count_ - CAPACITY : 0; }

    int RecordSize() const { return LogRecordSize(numJoints_); }

    // Returns the bytes of record number `number` of the log of motions.  REQUIRES: Oldest() <=
    // number < Count().
    const Uint8* Record(Uint32 number) const { return record_[number % CAPACITY]; }

private:
    const RobotConstants* robot_;
    int numJoints_;  // number of joints in a record
    Uint32 count_;
    Uint8 record_[CAPACITY][RC_MAX_LOG_RECORD];
};

#endif  // MotionLog_h_DEFINED
