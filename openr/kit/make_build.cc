#include "openr/kit/make_build.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "openr/kit/kit_log.h"
#include "openr/kit/makefile_text.h"
#include "openr/kit/process.h"
#include "openr/kit/sdk_paths.h"
#include "openr/kit/text_files.h"

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
      // A Makefile that sets no compiler gets make's own idea of one.
      {"CC", bin + "/mipsel-linux-gcc"},
      {"CXX", bin + "/mipsel-linux-g++"},
      {"AR", bin + "/mipsel-linux-ar"}};
  for (const char* name : {"CFLAGS", "CXXFLAGS", "CPPFLAGS", "LDFLAGS", "MAKEFLAGS", "MFLAGS",
                           "MAKELEVEL", "LD", "AS", "RANLIB", "STRIP"}) {
    environment.emplace_back(name, "");
  }
  return environment;
}

ProcessResult Make(const fs::path& folder, const std::vector<std::string>& arguments, int jobs,
                   bool captures, const MakeOptions& options) {
  std::vector<std::string> all{"make", fmt::format("-j{}", jobs)};
  if (!options.is_verbose) all.push_back("-s");
  if (captures) all.push_back("--output-sync=target");
  // Recipes of the time were written where sh is bash.
  if (HasProgram("/bin/bash")) all.push_back("SHELL=/bin/bash");
  all.insert(all.end(), arguments.begin(), arguments.end());
  Environment environment = MakeEnvironment(options);
  environment.emplace_back("PWD", folder);  // rules take it for the place of their Makefile
  return RunProcess(all, {environment, folder, captures, captures, true});
}

// Makefiles that no other one of the list is above of.
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

// Leads away from the copy, or was meant to be given by a person.
bool LeadsElsewhere(const MakefileVariable& variable) {
  if (!variable.is_defined) return true;
  return std::any_of(variable.values.begin(), variable.values.end(), [](const std::string& value) {
    return value.empty() || value[0] == '/' || value[0] == '~' ||
           value.find("$(HOME)") != std::string::npos ||
           value.find("${HOME}") != std::string::npos || (value.size() > 1 && value[1] == ':');
  });
}

bool IsAlready(const MakefileVariable& variable, const std::string& value) {
  return variable.is_defined && std::all_of(variable.values.begin(), variable.values.end(),
                                            [&](const std::string& v) { return v == value; });
}

bool HasInstallRule(const fs::path& folder, const std::vector<std::string>& variables,
                    const MakeOptions& options) {
  std::vector<std::string> arguments{"-n", "install"};
  arguments.insert(arguments.end(), variables.begin(), variables.end());
  const std::string said = Make(folder, arguments, 1, true, options).output;
  return said.find("make: *** No rule to make target 'install'") == std::string::npos;
}

}  // namespace

MakePlan PlanMake(const Project& project, const std::string& sdk_root, const fs::path& stick_root) {
  MakePlan plan;
  plan.folders = TopFolders(project);
  std::string all;  // definitions in one file hold for what another includes
  for (const fs::path& file : project.makefiles) {
    const std::string text = ReadText(file).value_or("");
    all += text + "\n";
    for (const MakefileVariable& variable : StickVariables(text)) {
      for (const std::string& value : variable.values) {
        if (value.empty() || value[0] == '/' || value.find('$') != std::string::npos) continue;
        plan.needed_folders.push_back(
            (file.parent_path() / value / "OPEN-R/MW/OBJS").lexically_normal());
      }
    }
  }
  plan.variables.emplace_back("OPENRSDK_ROOT", sdk_root);
  plan.variables.emplace_back(kStickVariable, stick_root);
  for (const MakefileVariable& variable : SdkVariables(all)) {
    const std::string value = sdk_root + variable.folder;
    if (variable.name != "OPENRSDK_ROOT" && !IsAlready(variable, value))
      plan.variables.emplace_back(variable.name, value);
  }
  for (const MakefileVariable& variable : StickVariables(all)) {
    if (LeadsElsewhere(variable)) plan.variables.emplace_back(variable.name, stick_root);
  }
  std::vector<fs::path> middleware{stick_root / "OPEN-R/MW"};
  for (const StickFolder& stick : project.sticks)
    middleware.push_back(stick.ObjectsFolder().parent_path());
  for (const fs::path& folder : middleware) {
    plan.needed_folders.push_back(folder / "OBJS");
    plan.needed_folders.push_back(folder / "DATA/P");
  }
  return plan;
}

bool RunMakeIn(const fs::path& folder, const std::vector<std::string>& arguments,
               const MakeOptions& options) {
  if (options.says != MakeOptions::Says::kAlways) {
    const ProcessResult result = Make(folder, arguments, options.jobs, true, options);
    if (result.good() && options.says == MakeOptions::Says::kIfGood)
      std::fputs(result.output.c_str(), stderr);
    return result.good();
  }
  if (options.jobs > 1) {
    // Old Makefiles often leave out dependencies and only work in order: if several jobs at once
    // fail, nothing of it is shown and the rest is done one by one.
    const ProcessResult together = Make(folder, arguments, options.jobs, true, options);
    if (together.good()) {
      std::fputs(together.output.c_str(), stderr);
      return true;
    }
    CleanKitLog(options.log);
  }
  const ProcessResult result = Make(folder, arguments, 1, false, options);
  if (!result.not_found.empty())
    std::fprintf(stderr, "openr build: %s (Debian package make)\n", result.not_found.c_str());
  return result.good();
}

bool RunMake(const MakePlan& plan, const MakeOptions& options) {
  std::vector<std::string> variables;
  for (const auto& [name, value] : plan.variables) variables.push_back(name + "=" + value);
  for (const fs::path& folder : plan.needed_folders) {
    std::error_code ignored;
    fs::create_directories(folder, ignored);
  }
  bool good = true;
  for (const fs::path& folder : plan.folders) {
    bool done = RunMakeIn(folder, variables, options);
    const bool compiles = ReadKitLog(options.log).failures.empty();
    if (compiles && HasInstallRule(folder, variables, options)) {
      std::vector<std::string> arguments{"install"};
      arguments.insert(arguments.end(), variables.begin(), variables.end());
      done = RunMakeIn(folder, arguments, options);
    }
    good = good && done;
  }
  return good;
}

}  // namespace openr_host
