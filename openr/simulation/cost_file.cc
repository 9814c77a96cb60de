#include "openr/simulation/cost_file.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <stdexcept>

#include "cli/input_file.h"
#include "cli/install_paths.h"

namespace openr_host {

std::optional<CostConfig> LoadCostFile(const std::string& name) {
  if (name.empty() || name == "zero") return {};
  const std::string path = DataFile(name);
  RequireReadable(path, kCostFile);
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error(fmt::format("{}: cannot be read", path));
  const std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  CostResult result = ParseCostConfig(path, text);
  if (!result.diagnostics.empty()) {
    std::string problems = Render(result.diagnostics);
    problems.pop_back();  // the last newline
    throw std::runtime_error(problems);
  }
  return std::move(result.config);
}

}  // namespace openr_host
