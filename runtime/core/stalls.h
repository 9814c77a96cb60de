// Who waits: for a ready, for an answer, for the processor.
//
// The robot says nothing when an observer forgets to assert ready: subject and observer
// both fall silent (field-notes.md, 2.2).  Here it has a name.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "runtime/core/message.h"

namespace openr_host {

class System;

struct Stall {
  ObjectId object = kNoObject;  // who waits
  int64_t since_us = 0;         // virtual time
  std::string text;             // "JointMover waits for ready of RCServer on ... since t=1.248 s"
  const char* advice = "";
  // An observer took a notification and has asserted no ready since.  It may have forgotten, or
  // want no more; only a graph that has fallen silent makes it suspect.
  bool may_be_done = false;
  // A program that works may do this too.  The observer has asserted ready again after a
  // notification before, so it knows how to and has stopped on purpose; or the subject is the
  // robot's, which goes on without it.  An observer that has taken one notification of
  // another object at most, and leaves its data waiting, may have forgotten to assert ready.
  bool is_chosen = false;
};

// Nobody waits for so long in a graph that works.
constexpr int64_t kStallUs = 1'000'000;

// Everybody who has waited for `least_us` or longer, in order of objects; those who may be done
// from kStallUs on, since most work on a notification before.
std::vector<Stall> FindStalls(const System& system, int64_t least_us);

// Makes a warning of everybody who has waited for kStallUs or longer, a note where that is chosen;
// of those who may be done if the graph `is_silent`.  At the end of a run.
void ReportStalls(System* system, bool is_silent);

}  // namespace openr_host
