#include "kit/make_flags.h"

#include <algorithm>
#include <sstream>

#include "kit/compile_command.h"
#include "kit/shell_words.h"
#include "kit/text_files.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

// Adds to `all` the flags that `all` does not have yet.  Always adds a flag of two words ("-include
// FILE"), because the search in `all` compares single words.
void AddFlags(const Words& flags, Words* all) {
  for (size_t i = 0; i < flags.size(); ++i) {
    const bool is_pair = flags[i].starts_with("-i") && i + 1 < flags.size();
    if (is_pair) {
      all->insert(all->end(), {flags[i], flags[i + 1]});
      ++i;
    } else if (std::find(all->begin(), all->end(), flags[i]) == all->end()) {
      all->push_back(flags[i]);
    }
  }
}

bool HasMainMakefile(const fs::path& folder) {
  std::error_code error;
  for (const char* name : {"GNUmakefile", "makefile", "Makefile"})
    if (fs::is_regular_file(folder / name, error)) return true;
  return false;
}

// A rule for make, given with the flag --eval.  The rule prints the values of all variables that
// Makefiles set, each value on a line of its own.
constexpr char kShowVariables[] =
    "openr-kit-flags: ; "
    "$(foreach v,$(.VARIABLES),$(if $(filter file,$(origin $v)),$(info $($v))))@:";

}  // namespace

Words FlagsOfMakefiles(const fs::path& folder, const KitLog& log,
                       const std::vector<std::pair<std::string, std::string>>& variables,
                       const MakeOptions& options) {
  Words flags;
  for (const KitLog::Compile& compile : log.compiles) {
    if (IsBelow(compile.file, folder) || IsBelow(compile.folder, folder))
      AddFlags(compile.flags, &flags);
  }
  // Prefers the flags in the log to the values of variables, because a variable may hold flags that
  // no rule uses.
  if (!flags.empty() || !HasMainMakefile(folder)) return flags;
  Words arguments{std::string("--eval=") + kShowVariables, "openr-kit-flags"};
  for (const auto& [name, value] : variables) arguments.push_back(name + "=" + value);
  MakeOptions quiet = options;
  quiet.print_output = MakeOptions::PrintOutput::kNever;
  std::istringstream lines(RunMakeIn(folder, arguments, quiet).output);
  for (std::string line; std::getline(lines, line);)
    AddFlags(CarriedFlags(SplitShellWords(line), folder), &flags);
  return flags;
}

}  // namespace openr_host
