// The server of the panel: the command `openr panel`.
#pragma once

#include <cstdint>
#include <string>

#include "openr/panel/listen.h"

namespace openr_host {

struct PanelOptions {
  uint16_t port = 8210;  // first port that the server tries; 0: any free port
  // The run for pages that name no run: its name, its process id, or both as NAME.PROCESS; "": no
  // run.
  std::string run;
  // The server's end of a pipe.  The run that has started this server holds the other end, so the
  // server sees when the run ends, and ends, too.  Such a server writes nothing to standard error
  // after its address. -1: no run has started the server; it ends with SIGINT or SIGTERM.
  int run_pipe = -1;
  ListenOptions listen = {};
  int robots = 1;  // number of robots whose remote control is forwarded (--listen)
};

// Runs the server of the panel until it must end.  Throws std::runtime_error if the server cannot
// start.
void ServePanel(const PanelOptions& options);

}  // namespace openr_host
