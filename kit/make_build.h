// Builds a program with its own Makefiles.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "kit/project.h"

namespace openr_host {

struct MakeOptions {
  std::string sdk_root;
  std::string log;     // see kit_log.h
  std::string copies;  // see source_copies.h
  int jobs = 1;
  bool is_verbose = false;
  enum class Says { kAlways, kIfGood, kNever } says = Says::kAlways;  // when the output is shown
};

// How make is called for a project.
struct MakePlan {
  // Folders in which make runs, for the first target and for `install`.
  std::vector<std::filesystem::path> folders;
  std::vector<std::pair<std::string, std::string>> variables;  // given on the command line
  std::vector<std::filesystem::path> needed_folders;  // folders that rules write into; made before
};

struct MakeOutcome {
  bool is_good = true;
  std::string output;  // output of make and its commands; without a run that was repeated
};

// Plans how to call make.  A Makefile variable that names a Memory Stick outside of the project is
// set to the project's own stick that is nearest to the folder in which make runs.
MakePlan PlanMake(const Project& project, const std::string& sdk_root);

// Runs make as planned.  Passes on the output of compilers and make.  The images that were made are
// in the log.
MakeOutcome RunMake(const MakePlan& plan, const MakeOptions& options);

// Runs the Makefile in `folder` for the first target and `install`, with the variables of the plan.
MakeOutcome RunMakeTargets(const std::filesystem::path& folder, const MakePlan& plan,
                           const MakeOptions& options);

// Runs make in `folder` with the kit's environment and flags, then `arguments`. make goes on with
// other targets when one fails.
MakeOutcome RunMakeIn(const std::filesystem::path& folder,
                      const std::vector<std::string>& arguments, const MakeOptions& options);

// Returns the reason why make failed, in one line: the file that no rule makes, or the rule that
// failed and the last message of its command.  Returns "" if `output` does not show it.
std::string CauseOf(const std::string& output);

}  // namespace openr_host
