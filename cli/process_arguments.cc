#include "cli/process_arguments.h"

#include "runtime/base/read_file.h"

namespace openr_host {

std::vector<std::string> ProcessArguments() {
  const std::string line = ReadFile("/proc/self/cmdline").value_or("");
  std::vector<std::string> arguments;
  for (size_t at = 0; at < line.size(); at = line.find('\0', at) + 1)
    arguments.emplace_back(line.c_str() + at);
  return arguments;
}

}  // namespace openr_host
