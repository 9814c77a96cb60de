#include "openr/commands/common_flags.h"

namespace openr_host {

void AddCommonFlags(CLI::App* command, SimulationOptions* options) {
  command->add_option("--stick", options->stick,
                      "A folder that holds OPEN-R/ (default: the stick that came along)");
  command->add_option("--robot", options->robot, "Model of the robot")
      ->check(CLI::IsMember({"ers210", "ers220", "ers7"}))
      ->capture_default_str();
  command->add_option("--world", options->world, "World file (default: a flat floor)");
  command->add_option("--seed", options->seed, "Of everything random")->capture_default_str();
}

}  // namespace openr_host
