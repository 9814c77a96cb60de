// Makes the report of a run, for --report and --json.  Fields keep their names after a release,
// because users' programs read them.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "openr/simulation/standing.h"

namespace openr_host {

class Simulation;
class System;
struct Ending;

// Facts that MakeReport() needs for the report of a run and cannot get from the simulation.
struct RunFacts {
  double wall_time_s = 0;
  uint64_t seed = 1;
  // For each robot, the monitor that knows whether the robot stands.
  std::vector<StandingMonitor> standing;
};

// Returns the report of the run as JSON. docs/cli.md gives the order of its keys.
nlohmann::ordered_json MakeReport(Simulation* simulation, const RunFacts& facts);

// Returns the findings of the run, which are a part of the report.
nlohmann::ordered_json ReportOfFindings(const System& system);

// Returns one line for each object, such as "[oid:0x80000045] /MS/OPEN-R/MW/OBJS/RCSERVER.BIN
// RCServer".  Printed at the start of the run, because the log lines of objects show only the
// number (OID).
std::string DescribeObjects(Simulation* simulation);

// Returns one line for each finding, such as "error: JointMover (message 12, t=0.096 s): text".
// If `has_colours` is true, the first word of each line has the colour of the finding's severity.
std::string DescribeFindings(Simulation* simulation, bool has_colours = false);

// Adds the finding about a crash, or about a handler that does not return, and notes the end of the
// run.  Must be called by an EndingAction: the function allocates memory in a signal handler, which
// may crash, and only a crash of an EndingAction is handled (ending.h).
void NoteTheEnding(const Ending& ending, Simulation* simulation);

// Prints on standard error the message whose handler has ended the process, such as "openr: message
// 24: boot".  Prints nothing if no message was handled.  Must be called by an EndingAction: the
// function allocates memory in a signal handler, which may crash, and only a crash of an
// EndingAction is handled (ending.h).
void PrintHandledMessage(const Ending& ending);

}  // namespace openr_host
