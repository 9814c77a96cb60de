// Building through the Makefiles a program has.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "openr/kit/project.h"

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

// `stick_root`: where variables for a Memory Stick elsewhere are to point.
MakePlan PlanMake(const Project& project, const std::string& sdk_root,
                  const std::filesystem::path& stick_root);

// Runs the plan.  What compilers and make say passes through.  Returns whether make was content;
// the images it made are in the log.
bool RunMake(const MakePlan& plan, const MakeOptions& options);

// One run of make in `folder` with the kit's environment; `arguments` follow its own.
bool RunMakeIn(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
               const MakeOptions& options);

}  // namespace openr_host
