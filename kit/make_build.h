// Builds a program with its own Makefiles.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kit/project.h"

namespace openr_host {

struct MakeOptions {
  std::string sdk_root;
  std::string log;      // path of the log file (kit_log.h)
  std::string copies;   // list of private copies, for the tools (source_copies.h)
  std::string variant;  // name of the variant to build (build_variant.h)
  int jobs = 1;
  bool is_verbose = false;
  // A function that is called again and again while make runs; null: no function is called.  Its
  // argument is the path of the log in which the compiler records the compilations of this run of
  // make.
  std::function<void(const std::string& log)> while_waiting;
  // Tells when the output of make is printed: always, only if make succeeds, or never.
  enum class PrintOutput { kAlways, kIfGood, kNever } print_output = PrintOutput::kAlways;
};

// The folders and variables with which make is called for a project.  PlanMake() makes the plan and
// RunMake() carries it out.
struct MakePlan {
  // Folders in which make runs, for the first target of the Makefile and for `install`.
  std::vector<std::filesystem::path> folders;
  // Variables that are set on the command line of make, and so override the variables of the
  // Makefiles, as pairs of name and value.
  std::vector<std::pair<std::string, std::string>> variables;
  // Folders into which rules of the Makefiles write.  Some Makefiles do not create them, so
  // RunMake() creates them first.
  std::vector<std::filesystem::path> needed_folders;
  // True: even make -n, which should only print commands, would run commands of these Makefiles
  // (dry_run.h), so CountPlannedCompiles() does not call make -n.
  bool runs_in_dry_run = false;
};

struct MakeOutcome {
  bool is_good = true;
  // The output of make and its commands.  If make failed with several jobs and ran again with one
  // job, only the output of the second run is here.
  std::string output;
};

// Plans how to call make.  A Makefile variable that names a Memory Stick outside of the project is
// set to the project's own stick that is nearest to the folder in which make runs.
MakePlan PlanMake(const Project& project, const std::string& sdk_root);

// Returns how many sources the commands of make compile.  `commands` is the output of make -n.
uint64_t CountSourcesIn(const std::string& commands);

// Returns how many sources RunMake() is going to compile, according to make -n.  Returns 0 if make
// does not know the commands before it runs them, for example because a script calls make.  Returns
// nullopt, and does not call make, if make -n would run commands.  RunMake() runs these commands
// again, and a command that may run only once would then fail or do damage.
std::optional<uint64_t> CountPlannedCompiles(const MakePlan& plan, const MakeOptions& options);

// Runs make as planned.  Prints the output of compilers and make.  Afterwards the log (kit_log.h)
// lists the images that were made.
MakeOutcome RunMake(const MakePlan& plan, const MakeOptions& options);

// Runs make in `folder` with the variables of the plan, for the first target of the Makefile and
// for the target `install`.
MakeOutcome RunMakeTargets(const std::filesystem::path& folder, const MakePlan& plan,
                           const MakeOptions& options);

// Runs make in `folder` with `arguments`.  make finds the kit's compiler and tools in its
// environment.  After a failure make goes on with other targets (-k).
MakeOutcome RunMakeIn(const std::filesystem::path& folder,
                      const std::vector<std::string>& arguments, const MakeOptions& options);

// Returns the reason why make failed, in one line: the file that no rule makes, or the rule that
// failed and the last message of its command.  Returns "" if `output` does not show the reason.
std::string CauseOf(const std::string& output);

}  // namespace openr_host
