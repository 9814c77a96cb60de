#include "openr/commands/motion_input.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <optional>
#include <stdexcept>

#include "cli/input_file.h"
#include "openr/chart/chart.h"
#include "openr/commands/common_flags.h"
#include "runtime/base/read_file.h"

namespace openr_host {

MtnFile ReadMotion(const std::string& file) {
  RequireReadable(file, {"motion file", ".MTN"});
  const std::optional<std::string> bytes = ReadFile(file);
  if (!bytes) {
    throw std::runtime_error(fmt::format("{}: cannot be read: {}", file, std::strerror(errno)));
  }
  MtnFile motion;
  if (!motion.Read(reinterpret_cast<const Uint8*>(bytes->data()), bytes->size()))
    throw std::runtime_error(fmt::format("{}: {}", file, motion.Error()));
  return motion;
}

CLI::Option* AddChartOption(CLI::App* command, std::string* file) {
  return command->add_option("-o,--output", *file, "The chart to write: NAME.svg or NAME.png")
      ->check(CLI::Validator(&chart::ChartNameProblem, ""))
      ->check(IsWritable());
}

}  // namespace openr_host
