// RunEnd: the reason why a run or one of its robots ends, as a value and as a text for people.
#pragma once

#include <cstdint>
#include <string>

namespace openr_host {

// The reason why a run or a robot ends; docs/cli.md explains each value.  The numbers are part of
// the protocol of distribution/, so new values must be added at the end.
enum class EndKind : uint8_t {
  kTime,          // the virtual time that was asked for is over
  kIdle,          // --until-idle: no object has sent a message for 1 s (kIdleUs)
  kPause,         // the robot shut down after its pause button was pressed
  kBattery,       // an object shut the robot down while the battery was low
  kPowerOff,      // an object shut the robot down for a reason of its own
  kFatal,         // an object called OPENR::Fatal()
  kStrict,        // the run reached a limit of the robot that --strict enforces
  kCrash,         // an object crashed
  kHandlerLimit,  // a handler did not return
  kLostProcess,   // a process with objects of the run was lost
  kNoBoot,        // the robot did not boot, or --strict refused to start its objects
  kSignal,        // Ctrl-C or SIGTERM came a second time
  kBranch,        // a user chose a past moment; a copy of the run goes on from it (openr/rewind)
};
constexpr int kEndKinds = 13;

// Returns the name of `kind` as reports show it in the field `ended_by`: "time", "idle" ...
const char* EndName(EndKind kind);

struct RunEnd {
  EndKind kind = EndKind::kPowerOff;
  // A text for people that says why the run or robot ends.  If an object has shut the robot down,
  // the text begins with the name of the object.
  std::string why = "the robot was shut down";
};

// Returns a sentence about the end for people: "ended by time: --for 20s is over".
std::string DescribeEnd(const RunEnd& end);

}  // namespace openr_host
