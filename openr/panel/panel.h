// The server of the panel: the command `openr panel`.
#pragma once

#include <cstdint>
#include <string>

namespace openr_host {

struct PanelOptions {
  uint16_t port = 8210;  // the first port to try; 0: any free one
  std::string run;       // the run of pages that name none: name, process id or both; "": none
  // Descriptor at whose end of file the server ends; -1: it ends with SIGINT or SIGTERM.  The
  // server of a run prints its address on standard error and then leaves that stream.
  int run_pipe = -1;
};

// Serves until the end.  Throws std::runtime_error if that is not possible.
void ServePanel(const PanelOptions& options);

}  // namespace openr_host
