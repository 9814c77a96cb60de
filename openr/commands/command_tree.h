// The description of all commands as data.  The manual pages, and the script by which bash
// completes command lines, are made from this description.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace openr_host {

// A flag or a positional.  A positional is a word without a flag; its place in the command line
// gives its meaning.
struct OptionInfo {
  enum class Value {
    kNone,    // a flag without a value
    kText,    // a value of none of the other kinds, such as a number, a duration or a name
    kChoice,  // a word of `choices`
    kFile,
    kFolder,
    kJoint,  // the name of a joint of a robot
    kModel,  // the name of a robot model
    kWorld,  // a file, or the name of a world that came with the program
  };

  // Names of the flag, such as "-o" and "--output".  A positional has only one name, which help
  // shows.
  std::vector<std::string> names;
  Value value = Value::kNone;
  // Name of the value in the help, such as "FILE"; "": the option has no value.
  std::string value_name;
  std::vector<std::string> choices;
  std::string default_value;  // default value that help shows; "": none
  std::string description;
  bool is_required = false;
  bool is_repeatable = false;
};

struct CommandInfo {
  std::string path;  // the words that call the command, such as "openr rc mtn play"
  std::string name;  // the last word of `path`, such as "play"
  std::string description;
  std::string footer;  // the last part of the help: examples, and for openr explore the properties
  std::vector<OptionInfo> positionals;
  std::vector<OptionInfo> options;
  bool takes_input = false;  // true: the words of an input (docs/inputs.md) follow the positionals
  std::vector<CommandInfo> commands;  // the subcommands, in the order in which the help lists them
};

// Returns the description of `app`, the whole program.
CommandInfo DescribeCommands(const CLI::App& app);

}  // namespace openr_host
