#include "openr/commands/command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <sstream>
#include <vector>

#include "cli/colour.h"
#include "cli/exit_code.h"
#include "cli/install_paths.h"
#include "cli/standard_streams.h"
#include "kit/shell_words.h"
#include "openr/commands/commands.h"
#include "runtime/base/spelling.h"

namespace openr_host {
namespace {

// Returns the words after "openr" with which the user calls `command`, such as "rc mtn"; "" for the
// program itself.
std::string PathOf(const CLI::App& command) {
  if (command.get_parent() == nullptr) return "";
  const std::string parent = PathOf(*command.get_parent());
  return parent.empty() ? command.get_name() : parent + " " + command.get_name();
}

// Returns the command that the user has given, such as `mtn` for "openr rc mtn".  Returns `app`,
// the program itself, if the user has given no command.
const CLI::App& ChosenCommand(const CLI::App& app) {
  const std::vector<CLI::App*> next = app.get_subcommands();
  return next.empty() ? app : ChosenCommand(*next.back());
}

const CLI::App* FindCommand(const CLI::App& parent, const std::string& word) {
  for (const CLI::App* const command : parent.get_subcommands({})) {
    if (command->get_name() == word) return command;
  }
  return nullptr;
}

std::vector<std::string> CommandNames(const CLI::App& parent) {
  std::vector<std::string> names;
  for (const CLI::App* const command : parent.get_subcommands({})) {
    names.push_back(command->get_name());
  }
  return names;
}

// Returns the error message for `word`, which stands in the place of a command of `parent` but is
// no command.  If `word` is "", the message says that the command is missing.
std::string NoSuchCommand(const CLI::App& parent, const std::string& word) {
  const std::vector<std::string> names = CommandNames(parent);
  const std::string path = PathOf(parent);
  std::string wrong = "a command is missing";
  if (word.empty() && !path.empty()) wrong += fmt::format(" after '{}'", path);
  if (!word.empty())
    wrong = fmt::format("'{}{}' is no command", path.empty() ? "" : path + " ", word);
  return fmt::format("{}; there are {}{}", wrong, fmt::join(names, ", "), DidYouMean(word, names));
}

bool IsFlag(const std::string& word) { return word.starts_with('-'); }

// Returns whether the last command on the command line, `command`, lacks the subcommand that must
// follow it.  A missing option does not count, because it is a different error.
bool NeedsCommand(const CLI::App& command) {
  const auto is_missing = [](const CLI::Option* o) { return o->get_required() && o->count() == 0; };
  const auto options = command.get_options();
  return command.get_require_subcommand_min() > 0 &&
         std::none_of(options.begin(), options.end(), is_missing);
}

// Returns the error message for `word`, which belongs to no command and no flag.
std::string NotExpected(const CLI::App& command, const std::string& word) {
  std::vector<std::string> flags;
  for (const CLI::App* app = &command; app != nullptr; app = app->get_parent()) {
    for (const CLI::Option* const option : app->get_options()) {
      for (const std::string& name : option->get_lnames()) flags.push_back("--" + name);
    }
  }
  if (!IsFlag(word)) return fmt::format("'{}' is one word too many", word);
  return fmt::format("there is no flag {}{}", word, DidYouMean(word, flags));
}

// Returns the help text about `command`.  Does not use help() of CLI11, because help() describes
// the command that the user has called: for "openr help run" this is `help`, not `run`.
std::string HelpAbout(const CLI::App& app, const CLI::App& command) {
  const std::string path = PathOf(command);
  const std::string name = path.empty() ? app.get_name() : app.get_name() + " " + path;
  return app.get_formatter()->make_help(&command, name, CLI::AppFormatMode::Normal);
}

void PrintHelp(const CLI::App& app, const std::vector<std::string>& words) {
  const CLI::App* about = &app;
  for (const std::string& word : words) {
    const CLI::App* const next = FindCommand(*about, word);
    if (next == nullptr) throw CLI::ValidationError(NoSuchCommand(*about, word));
    about = next;
  }
  PrintAnswerWithCodes(ForTerminal(HelpAbout(app, *about)));
}

class HelpFormatter : public CLI::Formatter {
 public:
  std::string make_usage(const CLI::App* app, std::string name) const override {
    if (app->get_parent() != nullptr) name = WordsUpTo(*app->get_parent()) + app->get_name();
    return CLI::Formatter::make_usage(app, name);
  }

 private:
  // Returns the beginning of a command line that calls a subcommand of `command`: all words before
  // the name of the subcommand, with a blank at the end, such as "openr rc HOST ".
  std::string WordsUpTo(const CLI::App& command) const {
    std::string words = command.get_parent() == nullptr ? "" : WordsUpTo(*command.get_parent());
    words += command.get_name() + " ";
    const auto is_positional = [](const CLI::Option* option) { return option->get_positional(); };
    for (const CLI::Option* const option : command.get_options(is_positional))
      words += make_option_usage(option) + " ";
    return words;
  }
};

}  // namespace

std::shared_ptr<CLI::FormatterBase> MakeHelpFormatter() {
  return std::make_shared<HelpFormatter>();
}

std::string ForTerminal(const std::string& help) {
  if (!HasColours(StandardOutput())) return help;
  std::string text;
  std::istringstream lines(help);
  for (std::string line; std::getline(lines, line);) {
    const bool is_usage = line.starts_with("Usage:");
    const bool is_heading = line.ends_with(':') && !line.starts_with(' ');
    text += (is_usage || is_heading ? Coloured(Colour::kBold, line, true) : line) + "\n";
  }
  return text;
}

// Finds the command to describe by the words in `argv`.  Does not use the command that CLI11 has
// found: in "openr rc move --help" CLI11 takes `move` for the positional HOST, so it would describe
// `rc`.
std::string HelpAskedFor(const CLI::App& app, int argc, char** argv) {
  const CLI::App* about = &app;
  for (int i = 1; i < argc; ++i) {
    if (const CLI::App* const next = FindCommand(*about, argv[i]); next != nullptr) about = next;
  }
  return HelpAbout(app, *about);
}

std::string HelpWords(const CLI::App& app) {
  const std::string path = PathOf(ChosenCommand(app));
  return ShellWord(ProgramCall()) + (path.empty() || path == "help" ? " help" : " help " + path);
}

std::string ExplainCommandLine(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = ChosenCommand(app);
  const std::vector<std::string> rest = app.remaining(true);
  const auto is = [&error](CLI::ExitCodes kind) {
    return error.get_exit_code() == static_cast<int>(kind);
  };
  // Looks for a missing command before it looks for an unknown word.  A misspelt command causes
  // both errors, but only NoSuchCommand() suggests the right spelling.
  if (is(CLI::ExitCodes::RequiredError) && NeedsCommand(command)) {
    const auto word = std::find_if_not(rest.begin(), rest.end(), &IsFlag);
    if (word != rest.end()) return NoSuchCommand(command, *word);
    return rest.empty() ? NoSuchCommand(command, "") : NotExpected(command, rest[0]);
  }
  if (is(CLI::ExitCodes::ExtrasError) && !rest.empty()) return NotExpected(command, rest[0]);
  return error.what();
}

void AddHelpCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command = app->add_subcommand("help", "Tells of the program or of a command");
  auto words = std::make_shared<std::vector<std::string>>();
  command->add_option("COMMAND", *words, "The command: run; rc mtn play");
  command->callback([app, words, exit_code] {
    PrintHelp(*app, *words);
    *exit_code = kExitGood;
  });
}

}  // namespace openr_host
