#include "openr/commands/command_tree.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <sstream>

#include "openr/commands/common_flags.h"

namespace openr_host {
namespace {

// Returns the words in the first braces of `type`, which is CLI11's text for an option with a list
// of values: "TEXT:{ers210,ers220}" or "{basic->BASIC,...} OR {BASIC,...}".  Returns an empty list
// if `type` has no braces.
std::vector<std::string> ChoicesIn(const std::string& type) {
  const size_t begin = type.find('{'), end = type.find('}', begin);
  std::vector<std::string> choices;
  if (begin == std::string::npos || end == std::string::npos) return choices;
  std::istringstream words(type.substr(begin + 1, end - begin - 1));
  for (std::string word; std::getline(words, word, ',');)
    choices.push_back(word.substr(0, word.find("->")));
  return choices;
}

bool IsOneOf(const std::string& word, std::initializer_list<const char*> words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

// Returns the kind of an option's value.  `type` is CLI11's text for the option.  `name` is the
// option's name in the help if the option is a positional argument, and "" if the option begins
// with '-'.
OptionInfo::Value ValueOf(const std::string& type, const std::string& name) {
  using Value = OptionInfo::Value;
  if (!ChoicesIn(type).empty()) return Value::kChoice;
  if (type.find("FOLDER") != std::string::npos || IsOneOf(name, {"DIR"})) return Value::kFolder;
  const bool is_file = type.find("FILE") != std::string::npos;
  if (is_file || IsOneOf(name, {"FILE", "LOG", "SOURCE"})) return Value::kFile;
  if (IsOneOf(name, {"JOINT", "QUANTITY"})) return Value::kJoint;
  if (IsOneOf(name, {"MODEL"})) return Value::kModel;
  if (type == kWorldType) return Value::kWorld;
  return Value::kText;
}

// Returns the name that the help shows for an option's value: "FILE" if `type` is "TEXT:FILE",
// "INT" if `type` is "INT:INT in [1 - 9]".
std::string ValueName(const std::string& type, OptionInfo::Value value) {
  if (value == OptionInfo::Value::kFile) return "FILE";
  if (value == OptionInfo::Value::kFolder) return "FOLDER";
  return type.substr(0, type.find_first_of(": "));
}

OptionInfo DescribeOption(const CLI::Option& option) {
  OptionInfo info;
  const bool is_positional = option.get_positional();
  if (is_positional) info.names.push_back(option.get_name(true, false));
  if (!is_positional) {
    for (const std::string& name : option.get_snames()) info.names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) info.names.push_back("--" + name);
  }
  info.description = option.get_description();
  info.is_required = option.get_required();
  info.is_repeatable = option.get_expected_max() >= CLI::detail::expected_max_vector_size;
  if (option.get_type_size() == 0) return info;
  const std::string type = option.get_type_name();
  info.value = ValueOf(type, is_positional ? info.names[0] : "");
  info.value_name = ValueName(type, info.value);
  info.choices = ChoicesIn(type);
  info.default_value = option.get_default_str();
  return info;
}

CommandInfo DescribeCommand(const CLI::App& app, const std::string& above) {
  CommandInfo info;
  info.name = app.get_name();
  info.path = above.empty() ? info.name : above + " " + info.name;
  info.description = app.get_description();
  info.footer = app.get_footer();
  info.takes_input = app.get_prefix_command();
  // Leaves out options that are in no group of the help.  They are hidden from users, because only
  // openr itself gives them to a program that it starts.
  const auto is_shown = [](const CLI::Option* option) { return !option->get_group().empty(); };
  for (const CLI::Option* const option : app.get_options(is_shown))
    (option->get_positional() ? info.positionals : info.options).push_back(DescribeOption(*option));
  for (const CLI::App* const command : app.get_subcommands({}))
    info.commands.push_back(DescribeCommand(*command, info.path));
  return info;
}

}  // namespace

CommandInfo DescribeCommands(const CLI::App& app) { return DescribeCommand(app, ""); }

}  // namespace openr_host
