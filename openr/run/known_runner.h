// KnownRunner: runs a known run, such as a recording, at the pace that somebody who watches it
// wants.
#pragma once

#include <functional>
#include <string>

namespace openr_host {

class InterruptCounter;
class KnownRun;
class LiveServer;
class Rewind;
class RunClock;

struct KnownRunnerParts {
  KnownRun* run = nullptr;
  LiveServer* live = nullptr;
  RunClock* clock = nullptr;
  Rewind* rewind = nullptr;
  const InterruptCounter* interrupts = nullptr;
  std::function<void(const std::string& line)> say;  // prints a message for the user
};

// Runs until Ctrl-C.  When the run is over, it is paused at its last moment, and can be rewound.
// Returns the exit code.
int RunKnown(const KnownRunnerParts& parts);

}  // namespace openr_host
