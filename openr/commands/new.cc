// openr new: an object to begin with.
#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include "openr/commands/commands.h"
#include "openr/commands/common_flags.h"
#include "openr/exit_code.h"
#include "openr/kit/new_object.h"
#include "openr/kit/shell_words.h"

namespace openr_host {
namespace {

struct NewFlags {
  std::string name;
  std::string folder;
};

int New(const NewFlags& flags) {
  const std::string folder = flags.folder.empty() ? flags.name : flags.folder;
  const std::vector<NewFile> files = MakeNewObject(flags.name);
  const std::string problem = WriteNewObject(files, folder);
  if (!problem.empty()) throw std::runtime_error(problem);
  for (const NewFile& file : files) fmt::print("{}/{}\n", folder, file.path);
  fmt::print("\nopenr build {}\nopenr run --stick {}\n", ShellWord(folder),
             ShellWord(folder + "/MS"));
  return kExitGood;
}

}  // namespace

void AddNewCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command =
      app->add_subcommand("new", "Makes an OPEN-R object that builds and runs");
  auto flags = std::make_shared<NewFlags>();
  command->add_option("NAME", flags->name, "Of the object's class: HelloWorld")
      ->required()
      ->check(CLI::Validator(&WhyNoObjectName, "NAME"));
  command->add_option("DIR", flags->folder, "Folder to write to (default: NAME)")
      ->check(IsFolder());
  command->callback([flags, exit_code] { *exit_code = New(*flags); });
}

}  // namespace openr_host
