// Building through the Makefiles a program has.
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
  enum class Says { kAlways, kIfGood, kNever } says = Says::kAlways;  // whether output is shown
};

// What make is called with.
struct MakePlan {
  std::vector<std::filesystem::path> folders;  // in each: the first target, and `install`
  std::vector<std::pair<std::string, std::string>> variables;  // on the command line
  std::vector<std::filesystem::path> needed_folders;           // rules write into them
};

struct MakeOutcome {
  bool is_good = true;
  std::string output;  // what make and its rules said; not of a run that was repeated
};

// Variables for a Memory Stick elsewhere point to the stick of the project that is nearest to the
// folder in which make runs.
MakePlan PlanMake(const Project& project, const std::string& sdk_root);

// Runs the plan.  What compilers and make say passes through.  The images that it made are in the
// log.
MakeOutcome RunMake(const MakePlan& plan, const MakeOptions& options);

// The first target and `install` of the Makefile in `folder`, with the variables of the plan.
MakeOutcome RunMakeTargets(const std::filesystem::path& folder, const MakePlan& plan,
                           const MakeOptions& options);

// Runs make in `folder` with the kit's environment; `arguments` follow those of the kit.  make goes
// on with other targets when one fails.
MakeOutcome RunMakeIn(const std::filesystem::path& folder,
                      const std::vector<std::string>& arguments, const MakeOptions& options);

// Why make failed, in one line, after what it said: what nothing makes, or which rule failed and
// what its command said.  "" when it does not say.
std::string CauseOf(const std::string& output);

}  // namespace openr_host
