#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "cli/exit_code.h"
#include "cli/json_text.h"
#include "openr/commands/commands.h"

namespace openr_host {

void AddVersionCommand(CLI::App* app, int* exit_code) {
  const char* const text = "openr-host " OPENR_VERSION;
  app->set_version_flag("--version", text, "Says which version this is");
  CLI::App* const command = app->add_subcommand("version", "Says which version this is");
  auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "One JSON object");
  command->callback([json, text, exit_code] {
    if (*json) {
      std::printf("%s\n", JsonText(nlohmann::json{{"version", OPENR_VERSION}}).c_str());
    } else {
      std::printf("%s\n", text);
    }
    *exit_code = kExitGood;
  });
}

}  // namespace openr_host
