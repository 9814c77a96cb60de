// KnownRunner: runs a known run, such as a recording, at the rate that its clients choose.
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
  // A function that prints a message for the user.
  std::function<void(const std::string& line)> say;
};

// Runs a known run until Ctrl-C, and returns the exit code.  At the end of the recorded time the
// run is paused, and can be rewound.
int RunKnown(const KnownRunnerParts& parts);

}  // namespace openr_host
