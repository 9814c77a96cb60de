// The script by which a shell completes the words of a command line.
#pragma once

#include <string>
#include <vector>

#include "openr/commands/command_tree.h"

namespace openr_host {

// An input (docs/inputs.md), such as "press chin".
struct InputInfo {
  std::string kind;                // first word of the input, such as "press"
  std::vector<std::string> words;  // the words that may follow, such as names of sensors
};

// Names that users type in command lines: of robot models, of their joints and sensors, and of
// worlds.  Also has the inputs (docs/inputs.md).  Each list is sorted.
struct DataNames {
  std::vector<std::string> joints;   // joints of all robot models
  std::vector<std::string> sensors;  // sensors of all robot models, without the sensors of joints
  std::vector<std::string> models;
  std::vector<std::string> worlds;
  std::vector<InputInfo> inputs;
};

// Returns a script for bash that completes commands, flags, and the values of flags.  Such a value
// is a word of a list, a name from `names`, a file or a folder.
std::string BashCompletion(const CommandInfo& program, const DataNames& names);

}  // namespace openr_host
