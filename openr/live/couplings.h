// Couplings: a client asks for a coupling while it controls a robot of the run together with a
// second robot, which may be a real robot.  During a coupling, the run goes on in real time.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace openr_host {

class Rewind;
class RunClock;

// A coupling connects the robot of the run with a second robot, which may be a real one.  While a
// coupling exists, the run goes on in real time, because a real robot cannot go faster.  The run
// cannot be rewound, because the second robot would not go back.  After the last coupling, the
// run has its earlier rate again, unless a client has chosen another rate meanwhile.
//
// A coupling ends with the connection of its client, so no coupling is left when a client is
// killed.
class Couplings {
 public:
  Couplings(RunClock* clock, Rewind* rewind) : clock_(clock), rewind_(rewind) {}

  // Answers the request "couple" (docs/inputs.md), which the client with the number `client` has
  // sent.  REQUIRES: the run has the robot that the request names.
  nlohmann::ordered_json Answer(uint64_t client, const nlohmann::json& request);

  // Ends the couplings of a client whose connection has ended.
  void End(uint64_t client);

  // Forgets all robots with which this run was coupled.  Called in a fork of the process, because
  // the fork chooses its own speed of virtual time.
  void Forget();

 private:
  struct Coupling {
    uint64_t client;
    int robot;
    std::string with;  // address of the second robot
  };

  std::string Begin(const Coupling& coupling);
  void Update();

  RunClock* const clock_;
  Rewind* const rewind_;
  std::vector<Coupling> all_;
  bool is_paced_ = false;   // true: a coupling has switched the run to real time
  double rate_before_ = 1;  // rate of the run before the couplings
};

}  // namespace openr_host
