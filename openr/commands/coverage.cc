// The command openr coverage: shows which lines of the user's objects were executed in runs.
#include "kit/coverage.h"

#include <memory>

#include "openr/commands/commands.h"
#include "openr/commands/common_flags.h"

namespace openr_host {

void AddCoverageCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command = app->add_subcommand(
      "coverage", "Shows the lines that runs executed, after openr build --coverage");
  auto options = std::make_shared<CoverageOptions>();
  options->folder = ".";
  command->add_option("DIR", options->folder, "Folder that was built")->capture_default_str();
  command->add_option("--lcov", options->lcov, "File to write for genhtml and editors");
  command->add_option("--work", options->work, "The folder that --work of openr build named")
      ->check(IsFolder());
  command->add_flag("--json", options->is_json, "Print JSON");
  command->add_flag("--reset", options->resets, "Forget the counts of earlier runs");
  command->callback([options, exit_code] { *exit_code = ShowCoverage(*options); });
}

}  // namespace openr_host
