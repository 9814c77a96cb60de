// The flags of openr explore.
#pragma once

#include <string>
#include <vector>

#include "openr/commands/show_run.h"
#include "openr/explore/explorer.h"
#include "openr/explore/schedule_file.h"

namespace openr_host {

struct ExploreFlags {
  ExploredStick stick;
  ExplorePlan plan;
  std::vector<std::string> vary;
  int faults = 0;
  bool exhaustive = false;
  bool no_reduction = false;
  bool verify = false;
  bool keep_going = false;
  bool guard = false;
  bool no_guard = false;
  std::string replay_file;
  std::string console_file;
  std::string file;
  bool json = false;
  bool panel = false;
  ShowOptions show;
  std::string record_file;
};

// Adds the flags of openr explore, with their defaults, to `command`.  Also adds a list of
// properties to the end of the help of `command`.
void AddExploreFlags(CLI::App* command, ExploreFlags* flags);

}  // namespace openr_host
