// PanelProcess, with which a run starts the server of its panel.
#pragma once

#include <string>

#include "openr/panel/panel.h"

namespace openr_host {

// The server of the panel is a process of its own, `openr panel`, so that the simulation keeps its
// one thread.  The run never waits for the server, and goes on if the server ends.
//
// The server ends when all processes have closed the writing end of a pipe: the run and all forks
// of the run.  So the server goes on when the run goes on in a fork.
class PanelProcess {
 public:
  // Starts the server of the panel for the run `options.run` (such as "default.123"); ignores
  // `options.run_pipe`.  Prints a warning if the server cannot be started.
  explicit PanelProcess(const PanelOptions& options);
  // Makes the server of the panel end, and does not wait until it has ended.
  ~PanelProcess();
  PanelProcess(const PanelProcess&) = delete;
  PanelProcess& operator=(const PanelProcess&) = delete;

 private:
  int pipe_ = -1;
};

// Returns whether the panel is installed: the built page and the library that serves it.
bool HasPanel();

}  // namespace openr_host
