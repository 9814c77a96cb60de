// Continues a recorded run as a live run: openr replay FILE --continue-at T.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "openr/inspect/replayer.h"

namespace openr_host {

struct ContinueOptions {
  ReplayOptions replay;
  int64_t at_us = 0;              // the moment of the recording from which the run goes on
  std::string record_file;        // file for a recording of the whole new run; "": none
  std::optional<int64_t> for_us;  // time for which the run goes on; nullopt: until the robot is off
  double rate = 1;                // virtual seconds per second; 0: as fast as possible
  bool panel = false;
  uint16_t panel_port = 8210;
};

// Replays the recording up to `at_us`, and then continues it as a live run.  Returns the exit code.
// Throws std::runtime_error if the recording cannot be used.
int ContinueRun(const ContinueOptions& options);

}  // namespace openr_host
