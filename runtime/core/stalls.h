// Stalls: objects that wait for a ready, for a reply or for the processor.
//
// An observer that forgets to assert ready, that is, to ask for the next data, gets no more data.
// The robot reports nothing, and subject and observer both stop sending (field-notes.md, 2.2).  The
// text of a stall names both objects.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/core/message.h"

namespace openr_host {

class System;

struct Stall {
  // The object that waits.  If an observer has not asserted ready, this is the object that has the
  // subject.
  ObjectId object = kNoObject;
  int64_t since_us = 0;     // virtual time when the wait began
  std::string text;         // "JointMover waits for ready of RCServer on ... since t=1.248 s"
  const char* advice = "";  // tells the author of the program how to end the wait
  // True if the observer may want no more data: no data wait for it, and it has not asserted ready
  // since its last notification, or never if it has received none.  But the observer may also have
  // forgotten to assert ready.  So this stall is reported only if no object of the run sends
  // messages any more.
  bool may_be_done = false;
  // True if the observer has probably stopped asking for data on purpose, so the report has a note
  // and not a warning.  This is assumed if the observer has received two notifications or more: it
  // has asserted ready between them, so its program can assert ready.  This is also assumed if the
  // subject belongs to a system object (a part of the robot), which continues its work even if the
  // observer never asserts ready.
  bool is_chosen = false;
};

// The shortest wait (for a ready, a reply or the processor) that is reported as a stall.  The value
// is our choice: in a program that works, no object waits so long.
constexpr int64_t kStallUs = 1'000'000;

// Returns the stalls that have lasted for `least_us` or longer, in the order of the objects' ids.
// A stall that may be no mistake (`may_be_done`) is returned only after kStallUs, even if
// `least_us` is shorter, because most observers work on a notification before they assert ready
// again.
std::vector<Stall> FindStalls(const System& system, int64_t least_us);

// Returns a line for each object that waits: "JointMover waits for the answer of IPStack since
// t=1.248 s".
std::vector<std::string> DescribeWaits(const System& system);

// Adds a finding for every stall (an object that waits for a ready, for a reply or for the
// processor) that has lasted for kStallUs or longer.  The finding is a note if the observer has
// probably stopped asking for data on purpose (`is_chosen`), otherwise a warning.  `is_silent` says
// whether no object sends messages any more.  If it is false, adds no finding for a stall in which
// the observer may want no more data (`may_be_done`).  Called at the end of a run.
void ReportStalls(System* system, bool is_silent);

}  // namespace openr_host
