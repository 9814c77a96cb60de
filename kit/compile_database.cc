#include "kit/compile_database.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "kit/compile_command.h"
#include "kit/sdk_paths.h"
#include "kit/text_files.h"
#include "runtime/base/read_file.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

void Append(const Words& more, Words* words) {
  words->insert(words->end(), more.begin(), more.end());
}

// Returns the command that compiles `original`, the user's file that `compile` is about.
Words CommandOf(const KitLog::Compile& compile, const std::string& original,
                const std::vector<SourceCopy>& copies, const std::string& sdk_root,
                BuildVariant variant) {
  const bool is_cxx = fs::path(original).extension() != ".c";
  const Language language = is_cxx ? Language::kCxx : Language::kC;
  Words words = HostCompiler(language);
  Append(ParseCompileFlags(ReadFile(sdk_root + "/compile-flags.txt").value_or(""), language,
                           IsClang(words)),
         &words);
  for (const std::string& flag : compile.flags) {
    // The user's folder comes before its copy, so that an editor opens the user's headers.
    const std::string in_originals = InTermsOfOriginals(flag, copies);
    if (in_originals != flag) words.push_back(in_originals);
    words.push_back(flag);
  }
  Append({"-I" + fs::path(compile.file).parent_path().string(), "-isystem",
          sdk_root + "/OPEN_R/include", "-isystem", sdk_root + "/compat"},
         &words);
  Append(VariantCompileFlags(variant), &words);
  Append({"-c", original}, &words);
  return words;
}

}  // namespace

std::string CompileDatabase(const KitLog& log, const std::vector<SourceCopy>& copies,
                            const std::string& sdk_root, BuildVariant variant) {
  nlohmann::ordered_json commands = nlohmann::ordered_json::array();
  std::error_code error;
  for (const KitLog::Compile& compile : log.compiles) {
    const std::string original = OriginalOf(compile.file, copies);
    if (original.empty() || !fs::exists(original, error)) continue;  // a source the build has made
    const std::string folder = OriginalOf(compile.folder, copies);
    commands.push_back({{"directory", folder.empty() ? compile.folder : folder},
                        {"file", original},
                        {"arguments", CommandOf(compile, original, copies, sdk_root, variant)}});
  }
  return commands.dump(2) + "\n";
}

void WriteCompileDatabase(const fs::path& folder, const KitLog& log,
                          const std::vector<SourceCopy>& copies, const std::string& sdk_root,
                          BuildVariant variant, std::vector<std::string>* problems) {
  const std::string problem =
      WriteText(folder / "compile_commands.json", CompileDatabase(log, copies, sdk_root, variant));
  if (!problem.empty()) problems->push_back(problem);
}

}  // namespace openr_host
