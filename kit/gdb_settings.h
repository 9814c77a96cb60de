// The commands that gdb needs before it starts a run.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

// Returns the commands of gdb, in their order.  `printers` is the file with the pretty printers, or
// "" if there is no such file.
inline std::vector<std::string> GdbSettings(const std::string& printers) {
  // Allows breakpoints in images, which are loaded only during the run.  Lets gdb ignore SIGFPE,
  // the signal of an operation that makes NaN, because the run itself handles this signal.
  std::vector<std::string> commands{"set breakpoint pending on", "set print thread-events off",
                                    "handle SIGFPE nostop noprint pass"};
  if (!printers.empty()) commands.push_back("source " + printers);
  return commands;
}

}  // namespace openr_host
