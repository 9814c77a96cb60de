#include "kit/make_build.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <regex>
#include <sstream>

#include "cli/print_plain.h"
#include "cli/process.h"
#include "kit/dry_run.h"
#include "kit/kit_log.h"
#include "kit/makefile_text.h"
#include "kit/sdk_paths.h"
#include "kit/shell_words.h"
#include "kit/text_files.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;

using Environment = std::vector<std::pair<std::string, std::string>>;

Environment MakeEnvironment(const MakeOptions& options) {
  const char* const path = std::getenv("PATH");
  const std::string bin = options.sdk_root + "/bin";
  Environment environment = {
      {"PATH",
       fmt::format("{}:{}/OPEN_R/bin:{}", bin, options.sdk_root, path == nullptr ? "" : path)},
      {"OPENRSDK_ROOT", options.sdk_root},
      {"PKG_CONFIG_PATH", (fs::path(options.sdk_root) / "../../pkgconfig").lexically_normal()},
      {kLogVariable, options.log},
      {kCopiesVariable, options.copies},
      {kVariantVariable, options.variant},
      // Sets the make variables for compilers and tools to the kit's tools, because make would
      // otherwise use its default compiler if a Makefile does not set them.
      {"CC", bin + "/mipsel-linux-gcc"},
      {"CXX", bin + "/mipsel-linux-g++"},
      {"AR", bin + "/mipsel-linux-ar"}};
  // Removes variables of the user's shell that make or a Makefile would use.  Also removes
  // MAKEFLAGS, MFLAGS and MAKELEVEL, which make has set if a Makefile has started `openr build`.
  for (const char* name : {"CFLAGS", "CXXFLAGS", "CPPFLAGS", "LDFLAGS", "MAKEFLAGS", "MFLAGS",
                           "MAKELEVEL", "LD", "AS", "RANLIB", "STRIP"}) {
    environment.emplace_back(name, "");
  }
  // Gives ccache no base folder.  With a base folder, ccache would write relative paths into the
  // lists of headers, which are rules for make.  The rules of the kit have absolute paths.  make
  // would take both paths for different files, and would not notice a changed header.
  environment.emplace_back("CCACHE_BASEDIR", "");
  return environment;
}

ProcessResult Make(const fs::path& folder, const std::vector<std::string>& arguments, int jobs,
                   bool echoes, const MakeOptions& options) {
  // Adds .DELETE_ON_ERROR, so that make deletes the half-written file of a failed rule.  Otherwise
  // the file would count as up to date in the next run.
  std::vector<std::string> all{"make", "-k", "--eval=.DELETE_ON_ERROR:", fmt::format("-j{}", jobs)};
  if (!options.is_verbose) all.push_back("-s");
  if (!echoes) all.push_back("--output-sync=target");
  // Uses bash if possible, because the rules of old programs were written on systems where sh was
  // bash.
  if (HasProgram("/bin/bash")) all.push_back("SHELL=/bin/bash");
  all.insert(all.end(), arguments.begin(), arguments.end());
  Environment environment = MakeEnvironment(options);
  std::function<void()> while_waiting;
  if (options.while_waiting) while_waiting = [&options] { options.while_waiting(options.log); };
  // Sets PWD to the folder of the Makefile, because rules use PWD as this folder.
  environment.emplace_back("PWD", folder);
  return RunProcess(all, {.environment = environment,
                          .folder = folder,
                          .captures_error = true,
                          .captures_out = true,
                          .echoes = echoes,
                          .has_no_input = true,
                          .while_waiting = while_waiting});
}

// Returns the folders in which make must run: all folders with a Makefile.  Leaves out a folder
// inside another folder with a Makefile, because a Makefile usually calls the Makefiles in the
// folders inside its own.
std::vector<fs::path> TopFolders(const Project& project) {
  std::vector<fs::path> folders;
  for (const fs::path& file : project.makefiles) {
    const fs::path folder = file.parent_path();
    if (!IsMainMakefileName(file) || !IsBelow(folder, project.root)) continue;
    const bool is_below_another =
        std::any_of(folders.begin(), folders.end(),
                    [&](const fs::path& other) { return IsBelow(folder, other); });
    if (!is_below_another) folders.push_back(folder);
  }
  return folders;
}

// Returns whether users had to set the variable for their own computers, because the Makefiles give
// it no value, or a value that leads to a path outside of the project.  `makefiles` is the text of
// all Makefiles.
bool LeadsOutOfProject(const MakefileVariable& variable, const std::string& makefiles) {
  if (!variable.is_defined) return true;
  static const std::regex kReference("^\\$[({](\\w+)[)}]");
  return std::any_of(variable.values.begin(), variable.values.end(), [&](const std::string& value) {
    std::smatch match;
    if (std::regex_search(value, match, kReference) && match[1] != "CURDIR" && match[1] != "PWD" &&
        !IsDefinedIn(makefiles, match[1])) {
      return true;
    }
    return value.empty() || value[0] == '/' || value[0] == '~' ||
           value.find("$(HOME)") != std::string::npos ||
           value.find("${HOME}") != std::string::npos || (value.size() > 1 && value[1] == ':');
  });
}

bool HasOnlyValue(const MakefileVariable& variable, const std::string& value) {
  return variable.is_defined && std::all_of(variable.values.begin(), variable.values.end(),
                                            [&](const std::string& v) { return v == value; });
}

// Returns whether make has an explicit rule for the target `install`, according to its database
// (make -p).  Asks make for a target that does nothing, so that make prints the database and runs
// no recipe of the Makefile.
bool HasExplicitInstallRule(const fs::path& folder, const std::vector<std::string>& variables,
                            const MakeOptions& options) {
  std::vector<std::string> arguments{"-p", "--eval=openr-host-nothing:;@:", "openr-host-nothing"};
  arguments.insert(arguments.end(), variables.begin(), variables.end());
  std::istringstream database(Make(folder, arguments, 1, false, options).output);
  std::string before;
  for (std::string line; std::getline(database, line); before = line) {
    if (line.starts_with("install:") && before != "# Not a target:") return true;
  }
  return false;
}

// Returns whether make has an explicit or an implicit rule for the target `install`.
bool HasInstallRule(const fs::path& folder, const std::vector<std::string>& variables,
                    const MakeOptions& options) {
  // Asks for the database of make (make -p) first, because in a dry run (make -n) the recipe of an
  // explicit rule could run commands (dry_run.h).
  if (HasExplicitInstallRule(folder, variables, options)) return true;
  std::vector<std::string> arguments{"-n", "install"};
  arguments.insert(arguments.end(), variables.begin(), variables.end());
  const std::string said = Make(folder, arguments, 1, false, options).output;
  return said.find("make: *** No rule to make target 'install'") == std::string::npos;
}

// Returns the value for Makefile variables that name a stick outside of the project: the path of
// the project's own stick, so that `make install` writes there.  If the project has no stick, the
// stick MS will be made.  If it has several sticks, returns an expression from which make chooses
// one: the stick in the folder in which make runs, else in the nearest folder around that folder,
// else the first stick.
std::string StickValue(const Project& project) {
  if (project.sticks.empty()) return project.root / "MS";
  std::vector<fs::path> roots;
  for (const StickFolder& stick : project.sticks) roots.push_back(stick.root);
  if (roots.size() == 1) return roots[0];
  const auto depth = [](const fs::path& path) { return std::distance(path.begin(), path.end()); };
  std::stable_sort(roots.begin(), roots.end(),
                   [&](const fs::path& a, const fs::path& b) { return depth(a) > depth(b); });
  std::string cases;
  for (const fs::path& root : roots)
    cases += fmt::format("$(if $(filter {}/%,$(CURDIR)/),{}) ", root.parent_path().string(),
                         root.string());
  return fmt::format("$(firstword {}{})", cases, project.sticks[0].root.string());
}

// Returns the variables of the plan as arguments of make: NAME=value.
std::vector<std::string> VariableArguments(const MakePlan& plan) {
  std::vector<std::string> arguments;
  for (const auto& [name, value] : plan.variables) arguments.push_back(name + "=" + value);
  return arguments;
}

// Returns make's error in `line`: "No rule to make target 'x'" for "make[1]: *** No rule to make
// target 'x'.  Stop.".  Returns "" for other lines.
std::string ErrorOfMake(const std::string& line) {
  static const std::regex kErrorOfMake(
      "(?:\\S*make(?:\\[\\d+\\])?: |([^\\s:]+:\\d+): )\\*\\*\\* (.*?)\\.?(?:  Stop\\.)?");
  // Reads no long line, such as data that a command has printed, because std::regex calls itself
  // for each character that it matches, and could overflow the stack.
  constexpr size_t kLineMax = 4096;
  std::smatch match;
  if (line.size() > kLineMax || !std::regex_match(line, match, kErrorOfMake)) return "";
  return (match[1].matched ? match[1].str() + ": " : "") + match[2].str();
}

// Returns `line` without the codes with which compilers colour their messages
// (-fdiagnostics-color=always), such as ESC "[01;31m".
std::string WithoutColours(const std::string& line) {
  std::string plain;
  for (size_t i = 0; i < line.size(); ++i) {
    if (line.compare(i, 2, "\x1b[") == 0) {
      i = std::min(line.find_first_not_of("0123456789;", i + 2), line.size());
    } else {
      plain += line[i];
    }
  }
  return plain;
}

}  // namespace

std::string CauseOf(const std::string& output) {
  static const std::regex kFailedRule("\\[(?:(\\S+:\\d+): )?(.*)\\] (Error \\d+|[A-Z].*)");
  std::istringstream lines(output);
  std::string before;  // last line that a command printed before the current line
  std::string tool, rule;
  for (std::string line; std::getline(lines, line);) {
    const std::string error = ErrorOfMake(line);
    if (error.empty()) {
      if (!line.empty() && !line.starts_with("make")) before = WithoutColours(line);
      continue;
    }
    if (error.starts_with("Waiting for") || error.starts_with("Deleting file")) continue;
    std::smatch match;
    if (!std::regex_match(error, match, kFailedRule)) return error;
    // Takes a rule that lacks a program (Error 127) as the cause of make's failure, rather than a
    // rule with another error, because a missing program explains more.  Of several such rules,
    // takes the first, because later rules may depend on the first.
    std::string* const cause = match[3] == "Error 127" ? &tool : &rule;
    if (!cause->empty()) continue;
    *cause = fmt::format("the rule for '{}'{} failed: {}", match[2].str(),
                         match[1].matched ? " (" + match[1].str() + ")" : "",
                         before.empty() ? match[3].str() : before);
  }
  return tool.empty() ? rule : tool;
}

MakePlan PlanMake(const Project& project, const std::string& sdk_root) {
  MakePlan plan;
  plan.folders = TopFolders(project);
  const std::string stick = StickValue(project);
  std::string all;  // text of all Makefiles, because one may use a variable of another
  for (const fs::path& file : project.makefiles) {
    const std::string text = ReadText(file).value_or("");
    all += text + "\n";
    for (const MakefileVariable& variable : StickVariables(text)) {
      for (const std::string& value : variable.values) {
        if (value.empty() || value[0] == '/' || value.find('$') != std::string::npos) continue;
        plan.needed_folders.push_back(
            WithCaseOnDisk((file.parent_path() / value).lexically_normal(), "OPEN-R/MW/OBJS"));
      }
    }
  }
  plan.runs_in_dry_run = DryRunRunsCommands(all);
  plan.variables.emplace_back("OPENRSDK_ROOT", sdk_root);
  plan.variables.emplace_back(kStickVariable, stick);
  for (const MakefileVariable& variable : SdkVariables(all)) {
    const std::string value = sdk_root + variable.folder;
    if (variable.name != "OPENRSDK_ROOT" && !HasOnlyValue(variable, value))
      plan.variables.emplace_back(variable.name, value);
  }
  for (const MakefileVariable& variable : StickVariables(all)) {
    if (LeadsOutOfProject(variable, all)) plan.variables.emplace_back(variable.name, stick);
  }
  std::vector<fs::path> middleware;
  if (project.sticks.empty()) middleware.push_back(fs::path(stick) / "OPEN-R/MW");
  for (const StickFolder& each : project.sticks)
    middleware.push_back(each.ObjectsFolder().parent_path());
  for (const fs::path& folder : middleware) {
    plan.needed_folders.push_back(WithCaseOnDisk(folder, "OBJS"));
    plan.needed_folders.push_back(WithCaseOnDisk(folder, "DATA/P"));
  }
  return plan;
}

uint64_t CountSourcesIn(const std::string& commands) {
  static const std::regex kContinued("\\\\\n");
  std::istringstream lines(std::regex_replace(commands, kContinued, " "));
  uint64_t count = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::vector<std::string> words = SplitShellWords(line);
    const bool has_compiler = std::any_of(words.begin(), words.end(), [](const std::string& word) {
      return word.ends_with("g++") || word.ends_with("gcc");
    });
    if (!has_compiler || std::find(words.begin(), words.end(), "-c") == words.end()) continue;
    count += static_cast<uint64_t>(std::count_if(
        words.begin(), words.end(), [](const std::string& word) { return IsSourceName(word); }));
  }
  return count;
}

std::optional<uint64_t> CountPlannedCompiles(const MakePlan& plan, const MakeOptions& options) {
  if (plan.runs_in_dry_run) return std::nullopt;
  std::vector<std::string> arguments = VariableArguments(plan);
  arguments.insert(arguments.begin(), "-n");
  uint64_t count = 0;
  for (const fs::path& folder : plan.folders)
    count += CountSourcesIn(Make(folder, arguments, 1, false, options).output);
  return count;
}

MakeOutcome RunMakeIn(const fs::path& folder, const std::vector<std::string>& arguments,
                      const MakeOptions& options) {
  if (options.print_output != MakeOptions::PrintOutput::kAlways) {
    const ProcessResult result = Make(folder, arguments, options.jobs, false, options);
    if (result.good() && options.print_output == MakeOptions::PrintOutput::kIfGood)
      std::fputs(result.output.c_str(), stderr);
    return {result.good(), result.output};
  }
  if (options.jobs > 1) {
    // Runs make with several jobs.  If this run fails, hides its output and runs make again with
    // one job, because old Makefiles often lack dependencies, and work only if make runs their
    // rules one after the other.  A failure that the compiler has logged also makes the run fail,
    // because a rule may ignore the failure of its command.
    const KitLog before = ReadKitLog(options.log);
    const ProcessResult together = Make(folder, arguments, options.jobs, false, options);
    KitLog after = ReadKitLog(options.log);
    if (together.good() && after.failures.size() == before.failures.size()) {
      std::fputs(together.output.c_str(), stderr);
      return {true, together.output};
    }
    // Forgets the failures of the first run of make, because the second run, with one job, logs the
    // failures that remain.
    after.failures = before.failures;
    WriteKitLog(options.log, after);
  }
  const ProcessResult result = Make(folder, arguments, 1, true, options);
  if (!result.start_error.empty())
    PrintPlain(stderr, "openr build: {} (Debian package make)\n", result.start_error);
  return {result.good(), result.output};
}

MakeOutcome RunMakeTargets(const fs::path& folder, const MakePlan& plan,
                           const MakeOptions& options) {
  const std::vector<std::string> variables = VariableArguments(plan);
  MakeOutcome outcome = RunMakeIn(folder, variables, options);
  if (!HasInstallRule(folder, variables, options)) return outcome;
  std::vector<std::string> arguments{"install"};
  arguments.insert(arguments.end(), variables.begin(), variables.end());
  const size_t failures = ReadKitLog(options.log).failures.size();
  MakeOptions install = options;
  // The run for the target `install` often repeats the steps of the Makefile's first target.  If
  // the first target has failed, the messages of these steps are already printed, so the output of
  // a failed run for `install` is printed only if the log has new failures.
  if (!outcome.is_good || failures > 0) {
    install.print_output = MakeOptions::PrintOutput::kIfGood;
    install.jobs = 1;
  }
  const MakeOutcome installed = RunMakeIn(folder, arguments, install);
  if (ReadKitLog(options.log).failures.size() > failures)
    std::fputs(installed.output.c_str(), stderr);
  outcome.is_good = installed.is_good;
  outcome.output += installed.output;
  return outcome;
}

MakeOutcome RunMake(const MakePlan& plan, const MakeOptions& options) {
  for (const fs::path& folder : plan.needed_folders) {
    std::error_code ignored;
    fs::create_directories(folder, ignored);
  }
  MakeOutcome all;
  for (const fs::path& folder : plan.folders) {
    const MakeOutcome outcome = RunMakeTargets(folder, plan, options);
    all.is_good = all.is_good && outcome.is_good;
    all.output += outcome.output;
  }
  return all;
}

}  // namespace openr_host
