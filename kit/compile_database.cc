#include "kit/compile_database.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>

#include "cli/json_text.h"
#include "kit/compile_command.h"
#include "kit/text_files.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

// Flags of compile-flags.txt and of the compile tool that clang 14 refuses.  The compile commands
// for editors do not contain these flags.  An editor uses clang only to show errors in sources, and
// these flags change the generated code but not the errors.
constexpr std::array<std::string_view, 5> kFlagsOfGccAlone = {
    "-fno-gnu-unique", "-fno-aggressive-loop-optimizations", "-fno-lifetime-dse",
    "-ftrivial-auto-var-init=zero", kNoHelpersInLibrary};

// Returns the words of `command`, a call of the compiler.  The build compiled a private copy of
// `original`, which is a file of the user; the words are changed so that they name `original`,
// because editors show the user's file.
Words WordsFor(const KitLog::Command& command, const std::string& original,
               const std::vector<SourceCopy>& copies) {
  Words words = command.words;
  // Leaves out the flags that only gcc knows, because clangd shows each of them as an error in the
  // first line of the source.
  std::erase_if(words, [](const std::string& word) {
    return std::find(kFlagsOfGccAlone.begin(), kFlagsOfGccAlone.end(), word) !=
           kFlagsOfGccAlone.end();
  });
  // Puts each header folder (-I) of the user before the private copy of that folder, so that an
  // editor opens the user's headers.
  Words originals;
  for (const std::string& flag : CarriedFlags(words, command.folder)) {
    const std::string in_originals = InTermsOfOriginals(flag, copies);
    if (flag.starts_with("-I") && in_originals != flag) originals.push_back(in_originals);
  }
  const auto first_flag = std::find_if(
      words.begin(), words.end(), [](const std::string& word) { return word.starts_with('-'); });
  words.insert(first_flag, originals.begin(), originals.end());
  // Adds the folder of the copied source to the header folders (-I), because headers that the build
  // makes, such as def.h, are only in this folder.
  const std::string copied_folder = fs::path(command.file).parent_path();
  words.insert(words.end(), {"-I" + copied_folder, "-c", original});
  return words;
}

}  // namespace

std::string CompileDatabase(const KitLog& log, const std::vector<SourceCopy>& copies) {
  nlohmann::ordered_json commands = nlohmann::ordered_json::array();
  std::error_code error;
  for (const KitLog::Command& command : log.commands) {
    const std::string original = OriginalOf(command.file, copies);
    // Skips a source that the build itself has made, because the user's folder has no such file.
    if (original.empty() || !fs::exists(original, error)) continue;
    commands.push_back({{"directory", command.folder},
                        {"file", original},
                        {"arguments", WordsFor(command, original, copies)}});
  }
  return JsonText(commands, 2) + "\n";
}

void WriteCompileDatabase(const fs::path& folder, const KitLog& log,
                          const std::vector<SourceCopy>& copies,
                          std::vector<std::string>* problems) {
  const std::string problem =
      WriteText(folder / "compile_commands.json", CompileDatabase(log, copies));
  if (!problem.empty()) problems->push_back(problem);
}

}  // namespace openr_host
