// The command openr new: makes the files of a new object.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cli/exit_code.h"
#include "cli/install_paths.h"
#include "cli/print_plain.h"
#include "kit/editor_files.h"
#include "kit/new_object.h"
#include "kit/sdk_paths.h"
#include "kit/shell_words.h"
#include "kit/text_files.h"
#include "openr/commands/commands.h"
#include "openr/commands/common_flags.h"

namespace openr_host {
namespace {

struct NewFlags {
  std::string name;
  std::string folder;
};

// Returns the commands that build and run the new object, for the output of openr new.  The user
// can paste them into a shell in the current folder.
std::string NextCommands(const std::string& folder) {
  const std::string openr = ShellWord(ProgramCall());
  const std::string prefix = std::filesystem::path(ProgramFolder()).parent_path();
  const auto below = [&](const char* name) { return ShellWord(folder + "/" + name); };
  return fmt::format(
      "\nto build it and run it for 10 s of virtual time:\n"
      "{0} build {1}\n"
      "{0} run --stick {2} --rate max --for 10s\n"
      "\nor with CMake, and with its tests:\n"
      "cmake -S {1} -B {3} -DCMAKE_PREFIX_PATH={4}\n"
      "cmake --build {3}\n"
      "ctest --test-dir {3} --output-on-failure\n"
      "{0} run --stick {5} --rate max --for 10s\n",
      openr, ShellWord(folder), below("MS"), below("build"), ShellWord(prefix),
      below("build/stick"));
}

// Returns the lines of `wanted` that `text` does not have.  Leaves out comments and empty lines.
std::string LinesNotIn(const std::string& text, const std::string& wanted) {
  std::set<std::string> present;
  std::istringstream text_lines(text);
  for (std::string line; std::getline(text_lines, line);) {
    line.erase(line.find_last_not_of(" \t\r") + 1);
    present.insert(line);
  }
  std::string lacking;
  std::istringstream wanted_lines(wanted);
  for (std::string line; std::getline(wanted_lines, line);) {
    if (!line.empty() && line[0] != '#' && !present.contains(line)) lacking += line + "\n";
  }
  return lacking;
}

// Returns the reason why no new object can have the name `name`; "" if it can.
std::string NewObjectProblem(const std::string& name) {
  const std::string problem = ObjectNameProblem(name);
  return problem.empty() ? ClassNameProblem(name, SdkRoot()) : problem;
}

// Removes .gitignore from `files` if `folder` already has this file, so that the user's file stays
// as it is.  This happens often, because a new repository has a .gitignore before the user makes an
// object in it.  Returns the lines that the file in the folder lacks; "" if it has them all, or if
// the folder has no such file.
std::string RemoveIgnoreFile(const std::string& folder, std::vector<NewFile>* files) {
  const std::optional<std::string> present = ReadText(std::filesystem::path(folder) / kIgnoreFile);
  if (!present) return "";
  const auto ours = std::find_if(files->begin(), files->end(),
                                 [](const NewFile& file) { return file.path == kIgnoreFile; });
  const std::string lacking = LinesNotIn(*present, ours->text);
  files->erase(ours);
  return lacking;
}

int New(const NewFlags& flags) {
  const std::string folder = flags.folder.empty() ? flags.name : flags.folder;
  std::vector<NewFile> files = MakeNewObject(flags.name);
  for (NewFile& file : EditorFiles(FindEditorPlaces(), {})) files.push_back(std::move(file));
  const std::string lacking = RemoveIgnoreFile(folder, &files);
  const std::string problem = WriteNewObject(files, folder);
  if (!problem.empty()) throw std::runtime_error(problem);
  for (const NewFile& file : files) PrintPlain("{}/{}\n", folder, file.path);
  if (!lacking.empty()) {
    PrintPlain(
        "\n{}/{} was there already and stays as it is; add these lines, so that git ignores what "
        "builds and runs leave behind:\n{}",
        folder, kIgnoreFile, lacking);
  }
  PrintPlain("{}", NextCommands(folder));
  return kExitGood;
}

}  // namespace

void AddNewCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command =
      app->add_subcommand("new", "Makes an OPEN-R object that builds and runs");
  auto flags = std::make_shared<NewFlags>();
  command->add_option("NAME", flags->name, "Of the object's class: HelloWorld")
      ->required()
      ->check(CLI::Validator(&NewObjectProblem, "NAME"));
  command->add_option("DIR", flags->folder, "Folder to write to (default: NAME)")
      ->check(IsFolder());
  command->callback([flags, exit_code] { *exit_code = New(*flags); });
}

}  // namespace openr_host
