// Makes the report of a run, for --report FILE and --json.  Names of fields do not change after a
// release.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "openr/simulation/standing.h"

namespace openr_host {

class Simulation;

// Parts of the report that are not in the state of the simulation.
struct RunFacts {
  double wall_time_s = 0;
  uint64_t seed = 1;
  std::vector<StandingMonitor> standing;  // by robot
};

// Returns the report, with keys in the order of docs/cli.md.
nlohmann::ordered_json MakeReport(Simulation* simulation, const RunFacts& facts);

// Returns a table of objects for the console, because lines of OSYSLOG show only the OID: one line
// each, "[oid:0x80000045] /MS/OPEN-R/MW/OBJS/RCSERVER.BIN RCServer".
std::string DescribeObjects(Simulation* simulation);

// Returns the findings for people, one line each: "error: JointMover (message 12, t=0.096 s):
// text".
std::string DescribeFindings(Simulation* simulation);

}  // namespace openr_host
