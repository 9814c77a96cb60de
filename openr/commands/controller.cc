// The command openr controller: creates, builds and runs controllers.  A controller is a program
// with a main() that moves the robot with functions in the style of the simulator Webots.  The
// OPEN-R object Controller runs it.
#include <dlfcn.h>
#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include "cli/exit_code.h"
#include "cli/install_paths.h"
#include "cli/print_plain.h"
#include "kit/controller_build.h"
#include "kit/controller_library.h"
#include "kit/new_controller.h"
#include "kit/robot_stick.h"
#include "kit/shell_words.h"
#include "openr/commands/commands.h"
#include "openr/commands/common_flags.h"
#include "openr/controller/controller_run.h"
#include "openr/remote/address.h"
#include "openr/remote/error.h"
#include "openr/remote/token_file.h"
#include "runtime/base/temp_folder.h"

namespace openr_host {
namespace {

struct ControllerFlags {
  ControllerBuildOptions build;
  bool for_robot = false;
  std::string name;
  std::string folder;
  std::string source;   // folder or file with the source of the controller
  std::string address;  // address of the robot that the controller commands
  int64_t timeout_us = 3'000'000;
  // File with the token, the secret that the robot's server asks for; "": none.
  std::string token_file;
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
  for (const NewFile& file : files) PrintPlain("{}/{}\n", folder, file.path);
  PrintPlain("\nopenr controller build {0}\nopenr run --stick {0}\n", ShellWord(folder));
  return kExitGood;
}

CLI::Validator IsRemoteAddress() {
  const auto problem = [](const std::string& text) -> std::string {
    try {
      openr::remote::ParseAddress(text);
      return "";
    } catch (const openr::remote::Error& error) {
      return error.what();
    }
  };
  return CLI::Validator(problem, "");
}

// Loads the shared library `library` and returns its function `name`.  The library stays loaded
// until the process ends.
template <typename Function>
Function* Load(const std::string& library, const char* name) {
  void* const handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const function = handle == nullptr ? nullptr : dlsym(handle, name);
  if (function != nullptr) return reinterpret_cast<Function*>(function);
  throw std::runtime_error(fmt::format("{}; build openr again", dlerror()));
}

// Builds the controller as a shared library, loads it into this process, and returns a function
// that calls its main().  Returns null if the build fails.
int (*LoadController(const ControllerFlags& flags))() {
  // The folder is deleted when this function returns.  The library in it stays loaded, because
  // Linux lets a loaded file be deleted.
  const TempFolder folder;
  const std::string library = folder.path() + "/controller.so";
  if (!BuildControllerLibrary({flags.source, ControllerLibrary(), library})) return nullptr;
  return Load<int()>(library, kControllerMainName);
}

int Run(const ControllerFlags& flags) {
  // Loads libopenr_controller.so before the controller's library.  The controller's library needs
  // libopenr_controller.so, but does not say in which folder it is (rpath).  So the dynamic linker
  // can only use a libopenr_controller.so that is already loaded.
  auto* const run = Load<RunController>(ControllerLibrary(), kRunControllerName);
  auto* const controller_main = LoadController(flags);
  if (controller_main == nullptr) return kExitWrong;
  const std::string folder = FolderOfController(flags.source);
  const std::string token =
      flags.token_file.empty() ? "" : openr::remote::ReadTokenFile(flags.token_file);
  return run({flags.address.c_str(), flags.timeout_us / 1000, token.c_str(), folder.c_str(),
              controller_main});
}

}  // namespace

void AddControllerCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command =
      app->add_subcommand("controller", "Makes, builds and runs controllers in Webots style");
  command->require_subcommand(1);
  auto flags = std::make_shared<ControllerFlags>();

  CLI::App* const build =
      command->add_subcommand("build", "Makes CONTROLL.BIN and puts it on a stick");
  flags->build.folder = ".";
  build->add_option("DIR", flags->build.folder, "Folder of the controller")->capture_default_str();
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

  CLI::App* const run = command->add_subcommand(
      "run", "Runs a controller on this computer; it steers a robot by the remote control");
  run->add_option("SOURCE", flags->source, "Folder of the controller, or its one source")
      ->required();
  run->add_option("HOST", flags->address, "Where the robot is: HOST[:PORT]")
      ->required()
      ->check(IsRemoteAddress());
  AddDurationFlag(run, "--timeout", &flags->timeout_us, "How long to wait for an answer");
  run->add_option("--token-file", flags->token_file,
                  "File with the token that openr run --listen asks for");
  run->callback([flags, exit_code] { *exit_code = Run(*flags); });

  CLI::App* const make = command->add_subcommand("new", "Makes a controller that builds and runs");
  make->add_option("NAME", flags->name, "Of the controller: wave")
      ->required()
      ->check(CLI::Validator(&ControllerNameProblem, "NAME"));
  make->add_option("DIR", flags->folder, "Folder to write to (default: NAME)")->check(IsFolder());
  make->callback([flags, exit_code] { *exit_code = New(*flags); });
}

}  // namespace openr_host
