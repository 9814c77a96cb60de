// Couplings: which robots of this run clients control together with a second robot.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace openr_host {

class Rewind;
class RunClock;

// While there is a coupling, the run goes on in real time, because a robot cannot go faster, and
// cannot be rewound, because the second robot would not go back.  Afterwards it has the rate it had
// before, unless somebody has chosen another one meanwhile.
//
// A coupling ends with the connection of its client, so nothing is left when a client is killed.
class Couplings {
 public:
  Couplings(RunClock* clock, Rewind* rewind) : clock_(clock), rewind_(rewind) {}

  // Answers the request "couple" of the client with this number (docs/inputs.md).
  nlohmann::ordered_json Answer(uint64_t client, const nlohmann::json& request);

  // Ends the couplings of a client that has gone.
  void End(uint64_t client);

  // Forgets all couplings, in a fork of the process, which gets a rate of its own.
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
  bool is_paced_ = false;   // a coupling has switched the run to real time
  double rate_before_ = 1;  // rate of the run before that
};

}  // namespace openr_host
