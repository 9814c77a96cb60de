// The command openr stick: makes and checks the folders of a Memory Stick, for the robot or for the
// host.
#include <map>
#include <memory>

#include "cli/exit_code.h"
#include "cli/install_paths.h"
#include "kit/robot_stick.h"
#include "openr/commands/commands.h"
#include "openr/commands/common_flags.h"
#include "openr/commands/stick_commands.h"

namespace openr_host {
namespace {

void AddOutput(CLI::App* command, std::string* output) {
  command->add_option("-o,--output", *output, "Folder to make; OPEN-R/ will be in it")
      ->required()
      ->check(IsFolder());
}

void AddHost(CLI::App* stick, int* exit_code) {
  CLI::App* const command = stick->add_subcommand("host", "A copy of the default stick");
  auto output = std::make_shared<std::string>();
  AddOutput(command, output.get());
  command->callback([output, exit_code] {
    MakeHostStick(DefaultStick(), *output);
    *exit_code = kExitGood;
  });
}

void AddRobot(CLI::App* stick, int* exit_code) {
  CLI::App* const command = stick->add_subcommand(
      "robot", "The objects built with the OPEN-R SDK of OPENRSDK_ROOT, on the SDK's base stick");
  auto options = std::make_shared<RobotStickOptions>();
  AddOutput(command, &options->output);
  command->add_option("--controller", options->controller,
                      "Folder of a controller (default: one that does nothing)");
  CLI::Option* const base = command->add_option(
      "--base", options->base, "Folder with OPEN-R/ to add to (default: the SDK's)");
  command->add_option("--robot", options->model, "ers210, ers220 or ers7: which base")
      ->check(CLI::IsMember({"ers210", "ers220", "ers7"}))
      ->excludes(base);
  const std::map<std::string, std::string> flavours = {
      {"basic", "BASIC"}, {"wlan", "WLAN"}, {"wconsole", "WCONSOLE"}};
  command
      ->add_option("--flavour", options->flavour,
                   "basic (no network), wlan, or wconsole (console on port 59000; default)")
      ->transform(CLI::CheckedTransformer(flavours, CLI::ignore_case))
      ->excludes(base);
  command->add_flag("!--nomemprot", options->is_protected, "The base without memory protection")
      ->excludes(base);
  command->add_flag("--verbose", options->is_verbose, "Show every command");
  command->callback([options, exit_code] {
    options->sources = ObjectSources();
    options->stick = DefaultStick();
    MakeRobotStick(*options);
    *exit_code = kExitGood;
  });
}

}  // namespace

void AddStickCommand(CLI::App* app, int* exit_code) {
  CLI::App* const stick =
      app->add_subcommand("stick", "Makes and checks the files of a Memory Stick");
  stick->require_subcommand(1);
  AddHost(stick, exit_code);
  AddRobot(stick, exit_code);
  AddStickCheck(stick, exit_code);
  AddStickNew(stick, exit_code);
  AddStickWlan(stick, exit_code);
}

}  // namespace openr_host
