// The commands openr completion and openr man, which describe all commands to a shell and to man.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cli/counted.h"
#include "cli/exit_code.h"
#include "cli/install_paths.h"
#include "cli/output_file.h"
#include "cli/standard_streams.h"
#include "openr/commands/command_tree.h"
#include "openr/commands/commands.h"
#include "openr/commands/common_flags.h"
#include "openr/commands/completion_script.h"
#include "openr/commands/input_words.h"
#include "openr/commands/man_page.h"
#include "virtualrobot/model/robot_model.h"
#include "virtualrobot/robot/faults.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

// Writes the manual page of one command to `folder`.  Throws std::runtime_error if that fails.
void WritePage(const CommandInfo& program, const CommandInfo& command, const fs::path& folder) {
  const std::string problem =
      WriteFile(folder / ManPageFile(command), ManPage(program, command, OPENR_VERSION));
  if (!problem.empty()) throw std::runtime_error(problem);
}

void WritePages(const CommandInfo& program, const std::string& output) {
  std::error_code error;
  fs::create_directories(output, error);
  if (error) throw std::runtime_error(fmt::format("{}: {}", output, error.message()));
  WritePage(program, program, output);
  for (const CommandInfo& command : program.commands) WritePage(program, command, output);
  PrintAnswer(
      fmt::format("wrote {} to {}\n", Counted(program.commands.size() + 1, "page"), output));
}

// The words of all inputs (docs/inputs.md) that the script of `openr completion` offers.  This list
// repeats what the runtime and the robots of a run define, because `openr completion` has no run
// that it could ask.
constexpr const char* kInputs[] = {"battery",
                                   "break JOINT SENSOR FAULT for",
                                   "charger on off",
                                   "draw for",
                                   "heat body battery for",
                                   "hold",
                                   "letgo",
                                   "lift",
                                   "press SENSOR pause for",
                                   "push at for",
                                   "put",
                                   "release SENSOR JOINT",
                                   "repair JOINT SENSOR body battery all",
                                   "send from",
                                   "set SENSOR for",
                                   "setdown",
                                   "shutdown",
                                   "target JOINT off in",
                                   "turn JOINT for",
                                   "type"};

// Returns an input of `openr poke` as the script of `openr completion` offers it: its first word,
// and all words that may follow.  `usage` is one of kInputs; for JOINT, SENSOR and FAULT in it, all
// names of joints, sensors and faults are added.
InputInfo MakeInput(const std::string& usage, const std::set<std::string>& joints,
                    const std::set<std::string>& sensors) {
  InputInfo input{usage.substr(0, usage.find(' ')), {}};
  const auto add = [&input](const auto& names) {
    input.words.insert(input.words.end(), names.begin(), names.end());
  };
  for (const std::string& word : WordsInUsage(usage)) {
    if (word == "JOINT") {
      add(joints);
    } else if (word == "SENSOR") {
      add(sensors);
    } else if (word == "FAULT") {
      add(Faults::Names());
    } else {
      input.words.push_back(word);
    }
  }
  return input;
}

// Returns the names of joints, sensors, robot models and worlds that came with openr, and the
// inputs in kInputs.
DataNames FindDataNames() {
  std::set<std::string> joints, sensors;  // sorted, each name once
  for (const std::string& name : ModelNames()) {
    const RobotModel model = LoadRobotModel(ModelFile(name));
    for (const auto& joint : model.joints) joints.insert(joint.name);
    for (const Sensor& sensor : model.sensors) {
      if (sensor.joint < 0) sensors.insert(sensor.short_name);
    }
  }
  std::vector<InputInfo> inputs;
  for (const char* const usage : kInputs) inputs.push_back(MakeInput(usage, joints, sensors));
  return {{joints.begin(), joints.end()},
          {sensors.begin(), sensors.end()},
          ModelNames(),
          WorldNames(),
          std::move(inputs)};
}

}  // namespace

void AddCompletionCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command =
      app->add_subcommand("completion", "Prints the script by which a shell completes commands");
  auto shell = std::make_shared<std::string>();
  command->add_option("SHELL", *shell, "Which shell")->required()->check(CLI::IsMember({"bash"}));
  // Captures `shell`, which the callback does not use, so that the string exists as long as the
  // command: the option SHELL stores its value in the string.
  command->callback([app, shell, exit_code] {
    PrintAnswer(BashCompletion(DescribeCommands(*app), FindDataNames()));
    *exit_code = kExitGood;
  });
}

void AddManCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command =
      app->add_subcommand("man", "Writes the manual pages: of the program and of each command");
  auto output = std::make_shared<std::string>();
  command->add_option("-o,--output", *output, "Folder for the pages")
      ->required()
      ->check(IsFolder());
  command->callback([app, output, exit_code] {
    WritePages(DescribeCommands(*app), *output);
    *exit_code = kExitGood;
  });
}

}  // namespace openr_host
