// The server of the panel: the command `openr panel`.
#pragma once

#include <cstdint>
#include <string>

namespace openr_host {

struct PanelOptions {
  uint16_t port = 8210;  // first port that the server tries; 0: any free port
  // The run for pages that name no run.  It is given by its name, its process id or both; "": no
  // run.
  std::string run;
  // Descriptor of a pipe.  The server ends when the other end of the pipe is closed; -1: the server
  // ends with SIGINT or SIGTERM.  The server of a run prints its address on standard error, and
  // then writes nothing more to standard error.
  int run_pipe = -1;
};

// Runs the server of the panel until it must end.  Throws std::runtime_error if the server cannot
// start.
void ServePanel(const PanelOptions& options);

}  // namespace openr_host
