// Shows on the panel a run that is known before it begins: a recording, or a failing run that openr
// explore has found.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace openr_host {

class KnownRun;

struct ShowOptions {
  std::string name;            // name of the run in the list that the panel shows
  uint16_t panel_port = 8210;  // port of the panel; if it is taken, the next free port is used
  double rate = 1;             // virtual seconds per second; 0: as fast as possible
};

// Adds the flags --panel-port and --rate, which set members of ShowOptions.  --panel-port can be
// given only together with the flag `panel`.  The caller checks when --rate can be given.
void AddShowFlags(CLI::App* command, CLI::Option* panel, ShowOptions* options);

// The type of a function that assembles a run whose objects print to `console`, and returns the
// run.
using MakeKnownRun =
    std::function<std::unique_ptr<KnownRun>(const std::function<void(std::string_view)>& console)>;

// Serves the run that `make` assembles, and a panel for it, until Ctrl-C.  Returns the exit code.
// Throws std::runtime_error if the run or its socket cannot be made.
int ShowRun(const MakeKnownRun& make, const ShowOptions& options);

}  // namespace openr_host
