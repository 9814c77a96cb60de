// The command openr build: builds a folder of OPEN-R programs so that they run on the host.
#include <memory>

#include "kit/build_folder.h"
#include "openr/commands/commands.h"
#include "openr/commands/common_flags.h"

namespace openr_host {
namespace {

void AddVariantFlags(CLI::App* command, BuildVariant* variant) {
  const auto add = [&](const char* name, const char* help, BuildVariant value) {
    return command->add_flag_callback(
        name, [variant, value] { *variant = value; }, help);
  };
  CLI::Option* const debug =
      add("--debug", "For a debugger: -Og -g, with frame pointers", BuildVariant::kDebug);
  CLI::Option* const sanitize =
      add("--sanitize", "With AddressSanitizer and UndefinedBehaviorSanitizer",
          BuildVariant::kSanitize);
  CLI::Option* const coverage =
      add("--coverage", "With counters for openr coverage", BuildVariant::kCoverage);
  debug->excludes(sanitize)->excludes(coverage);
  sanitize->excludes(coverage);
}

}  // namespace

void AddBuildCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command =
      app->add_subcommand("build", "Builds a folder of OPEN-R objects for the host");
  auto options = std::make_shared<BuildOptions>();
  options->folder = ".";
  command->add_option("DIR", options->folder, "Folder with objects, and Makefiles if it has any")
      ->capture_default_str();
  command
      ->add_option("-o,--output", options->output, "Folder for the stick (default: the one in DIR)")
      ->check(IsFolder());
  command->add_option("-j,--jobs", options->jobs, "Compilers at once (default: all processors)")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--work", options->work,
                   "Folder for private copies (default: one in ~/.cache/openr-host)")
      ->check(IsFolder());
  command->add_flag("--verbose", options->is_verbose, "Show every command");
  command->add_flag("--compile-commands", options->writes_database,
                    "Write DIR/compile_commands.json, for editors");
  AddVariantFlags(command, &options->variant);
  command->add_flag("--fresh", options->is_fresh, "Forget what earlier builds left");
  command->callback([options, exit_code] { *exit_code = BuildFolder(*options); });
}

}  // namespace openr_host
