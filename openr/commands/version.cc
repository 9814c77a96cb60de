#include <cstdio>
#include <nlohmann/json.hpp>

#include "openr/commands/commands.h"
#include "openr/exit_code.h"

namespace openr_host {

void AddVersionCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command = app->add_subcommand("version", "Says which version this is");
  auto json = std::make_shared<bool>(false);
  command->add_flag("--json", *json, "One JSON object");
  command->callback([json, exit_code] {
    if (*json) {
      std::printf("%s\n", nlohmann::json{{"version", OPENR_VERSION}}.dump().c_str());
    } else {
      std::printf("openr-host %s\n", OPENR_VERSION);
    }
    *exit_code = kExitGood;
  });
}

}  // namespace openr_host
