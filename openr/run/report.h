// The report of a run: --report FILE and --json.  Field names, once released, stay.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "openr/simulation/standing.h"

namespace openr_host {

class Simulation;

// What the report says besides the state of the simulation.
struct RunFacts {
  double wall_time_s = 0;
  uint64_t seed = 1;
  std::vector<StandingMonitor> standing;  // by robot
};

// Keys in the order of docs/cli.md.
nlohmann::ordered_json MakeReport(Simulation* simulation, const RunFacts& facts);

// Who is who among the lines of OSYSLOG, which carry the OID only: "[oid:0x80000045]
// /MS/OPEN-R/MW/OBJS/RCSERVER.BIN RCServer", one line each, for the console.
std::string DescribeObjects(Simulation* simulation);

// "error: JointMover (message 12, t=0.096 s): text", one line each, for people.
std::string DescribeFindings(Simulation* simulation);

}  // namespace openr_host
