// The part of a crash record that has the form of the robot's emergency monitor, so that programs
// that read the EMON.LOG of a robot can read the EMON.LOG of a run as well.
#pragma once

#include <cstdint>
#include <functional>

#include "openr/ending/signal_text.h"

namespace openr_host {

class Object;

// Value of RobotException::bad_address if the address is not known.  It is not 0, because a reader
// of EMON.LOG would look for a null pointer.  We take the number that the SDK uses for what is not
// defined, such as OID_UNDEF and oprimitiveID_UNDEF (core.md 6.2, 6.5).
inline constexpr uint64_t kUnknownAddress = 0xffffffff;

// The exception that the robot's processor would raise for a crash of a run.
struct RobotException {
  unsigned code = 0;         // exception code (field-notes.md 4.1); 0 if the robot would go on
  uint64_t bad_address = 0;  // address that could not be accessed; 0 for other exceptions
  uint64_t epc = 0;          // address of the instruction that failed, in the image's file
  // True: the signal has interrupted the object's own code.  False: it has interrupted the runtime,
  // which may have been changing its table of objects, so the table cannot be read.
  bool is_in_own_code = false;
};

// Heading of the first part of a crash record in the form of the robot's EMON.LOG.
inline constexpr char kRobotRecordBegin[] = "[exception info]";

// Passes the parts of a crash record one after the other to `write`: exception info, object info,
// exception code and list of objects, see field-notes.md 4.5.  The time stamp is the virtual time
// in microseconds.  Other numbers are cut to the 32 bits that they have on the robot.  An object of
// a run has no context and no thread, so the record gives the object's id in their places.
// Registers and stack are left out, because they are those of another processor.  If
// `exception.is_in_own_code` is true, the list has all objects of the robot; otherwise it has only
// `object`.  May be called in a signal handler.
void WriteRobotRecord(const RobotException& exception, const Object& object,
                      const std::function<void(const SignalText&)>& write);

}  // namespace openr_host
