#include "openr/simulation/cost_file.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <optional>
#include <stdexcept>

#include "cli/input_file.h"
#include "cli/install_paths.h"
#include "runtime/base/read_file.h"

namespace openr_host {

std::optional<CostConfig> LoadCostFile(const std::string& name) {
  if (name.empty() || name == "zero") return {};
  const std::string path = DataFile(name);
  RequireReadable(path, kCostFile);
  const std::optional<std::string> text = ReadFile(path);
  if (!text)
    throw std::runtime_error(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
  CostResult result = ParseCostConfig(path, *text);
  if (!result.diagnostics.empty()) {
    std::string problems = Render(result.diagnostics);
    problems.pop_back();  // removes the newline at the end of the last problem
    throw std::runtime_error(problems);
  }
  return std::move(result.config);
}

}  // namespace openr_host
