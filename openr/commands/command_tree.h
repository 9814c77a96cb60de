// The one description of all commands, as data: what help, completion and manual pages are made of.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace openr_host {

// A flag, or a word without a name in a fixed place (a positional).
struct OptionInfo {
  enum class Value {
    kNone,    // a flag without a value
    kText,    // a number, a duration, a name
    kChoice,  // one of `choices`
    kFile,
    kFolder,
  };

  std::vector<std::string> names;  // "-o", "--output"; of a positional only what help calls it
  Value value = Value::kNone;
  std::string value_name;  // "FILE"; "" without a value
  std::vector<std::string> choices;
  std::string default_value;  // "": none is shown
  std::string description;
  bool is_required = false;
  bool is_repeatable = false;
};

struct CommandInfo {
  std::string path;  // "openr rc mtn play"
  std::string name;  // "play"
  std::string description;
  std::string footer;  // what help shows last: the examples, and lists of words
  std::vector<OptionInfo> positionals;
  std::vector<OptionInfo> options;
  std::vector<CommandInfo> commands;  // those below, in the order of the help
};

// Returns the description of `app`, the whole program.
CommandInfo DescribeCommands(const CLI::App& app);

}  // namespace openr_host
