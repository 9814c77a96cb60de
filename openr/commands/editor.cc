// The command openr editor: adds the files for Visual Studio Code to a folder that has the sources
// of objects or of a controller.
#include <fmt/format.h>

#include <memory>
#include <stdexcept>
#include <string>

#include "cli/exit_code.h"
#include "cli/print_plain.h"
#include "cli/standard_streams.h"
#include "kit/editor_files.h"
#include "kit/new_object.h"
#include "openr/commands/commands.h"
#include "openr/commands/common_flags.h"

namespace openr_host {
namespace {

int MakeEditorFiles(const std::string& folder) {
  const EditorFolder described = DescribeEditorFolder(folder);
  const std::vector<NewFile> files = EditorFiles(FindEditorPlaces(), described);
  const std::string problem = WriteNewObject(files, folder);
  if (!problem.empty()) throw std::runtime_error(problem);
  for (const NewFile& file : files) PrintPlain("{}/{}\n", folder, file.path);
  const std::string stick = described.stick == "." ? "the folder itself" : described.stick;
  PrintPlain("\nthe tasks run this stick: {}\n", stick);
  return kExitGood;
}

}  // namespace

void AddEditorCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command = app->add_subcommand(
      "editor", "Makes .vscode, for Visual Studio Code, in a folder of objects or a controller");
  auto folder = std::make_shared<std::string>(".");
  command->add_option("DIR", *folder, "Folder that openr build or openr controller build builds")
      ->capture_default_str();
  command->callback([folder, exit_code] { *exit_code = MakeEditorFiles(*folder); });
}

}  // namespace openr_host
