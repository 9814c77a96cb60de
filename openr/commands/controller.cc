// The command openr controller: creates and builds controllers.  A controller is a program with a
// main() that moves the robot with functions in the style of the simulator Webots.  The OPEN-R
// object Controller runs it.
#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include "cli/exit_code.h"
#include "cli/install_paths.h"
#include "kit/controller_build.h"
#include "kit/new_controller.h"
#include "kit/robot_stick.h"
#include "kit/shell_words.h"
#include "openr/commands/commands.h"
#include "openr/commands/common_flags.h"

namespace openr_host {
namespace {

struct ControllerFlags {
  ControllerBuildOptions build;
  bool for_robot = false;
  std::string name;
  std::string folder;
};

// Builds the controller for the robot.  The build for the host adds only CONTROLL.BIN to a stick of
// compiled objects.  For the robot there is no such stick, so MakeRobotStick() compiles the
// controller and all other objects with the robot's SDK and makes a whole new stick.
int BuildForRobot(const ControllerBuildOptions& build) {
  if (build.output.empty()) {
    throw std::runtime_error("--robot makes a whole stick: name a new folder for it with -o");
  }
  RobotStickOptions options;
  options.output = build.output;
  options.controller = build.folder;
  options.sources = ObjectSources();
  options.stick = DefaultStick();
  MakeRobotStick(options);
  return kExitGood;
}

int Build(const ControllerFlags& flags) {
  if (flags.for_robot) return BuildForRobot(flags.build);
  ControllerBuildOptions options = flags.build;
  if (options.template_stick.empty()) options.template_stick = DefaultStick();
  return BuildController(options);
}

int New(const ControllerFlags& flags) {
  const std::string folder = flags.folder.empty() ? flags.name : flags.folder;
  const std::vector<NewFile> files = MakeNewController(flags.name);
  const std::string problem = WriteNewObject(files, folder);
  if (!problem.empty()) throw std::runtime_error(problem);
  for (const NewFile& file : files) fmt::print("{}/{}\n", folder, file.path);
  fmt::print("\nopenr controller build {0}\nopenr run --stick {0}\n", ShellWord(folder));
  return kExitGood;
}

}  // namespace

void AddControllerCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command =
      app->add_subcommand("controller", "Makes and builds controllers in Webots style");
  command->require_subcommand(1);
  auto flags = std::make_shared<ControllerFlags>();

  CLI::App* const build =
      command->add_subcommand("build", "Makes CONTROLL.BIN and puts it on a stick");
  build->add_option("DIR", flags->build.folder, "Folder of the controller")->required();
  build
      ->add_option("-o,--output", flags->build.output,
                   "Folder of the stick (default: DIR); made if it holds no OPEN-R/")
      ->check(IsFolder());
  CLI::Option* const from =
      build->add_option("--from", flags->build.template_stick,
                        "Stick that a new one is copied from (default: the one that came along)");
  build
      ->add_flag("--robot", flags->for_robot,
                 "For the dog, as openr stick robot --controller DIR; needs OPENRSDK_ROOT and -o")
      ->excludes(from);
  build->callback([flags, exit_code] { *exit_code = Build(*flags); });

  CLI::App* const make = command->add_subcommand("new", "Makes a controller that builds and runs");
  make->add_option("NAME", flags->name, "Of the controller: wave")
      ->required()
      ->check(CLI::Validator(&WhyNoControllerName, "NAME"));
  make->add_option("DIR", flags->folder, "Folder to write to (default: NAME)")->check(IsFolder());
  make->callback([flags, exit_code] { *exit_code = New(*flags); });
}

}  // namespace openr_host
