// Finds calls of openr in lines of a shell and reads them with the parser of the program, without
// doing their work.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <optional>
#include <regex>
#include <string>
#include <utility>
#include <vector>

#include "openr/commands/commands.h"

namespace openr_host {

using CallWords = std::vector<std::string>;

// Splits a line of a shell into commands, and each command into words.  Knows quotes, comments and
// redirections, and replaces no variables.  The output of a command, $(...), becomes "$output".
class ShellLine {
 public:
  explicit ShellLine(const std::string& line) {
    static const std::regex kOutput("\\$\\([^()]*\\)");
    for (const char c : std::regex_replace(line, kOutput, "$$output")) {
      if (c == '#' && !word_ && quote_ == 0) break;
      AddCharacter(c);
    }
    EndCommand();
  }
  const std::vector<CallWords>& commands() const { return commands_; }

 private:
  void AddCharacter(char c) {
    if (quote_ != 0) return AddInQuotes(c);
    if (c == ' ') return EndWord();
    if (c == '<' || c == '>') return BeginRedirection();
    if (c == '&' && is_redirection_ && !word_) return;  // the & of 2>&1
    if (std::string("|&;()").find(c) != std::string::npos) return EndCommand();
    if (!word_) word_ = "";
    if (c == '\'' || c == '"') {
      quote_ = c;
    } else {
      *word_ += c;
    }
  }
  void AddInQuotes(char c) {
    if (c == quote_) {
      quote_ = 0;
    } else {
      *word_ += c;
    }
  }
  void BeginRedirection() {
    if (word_ && word_->find_first_not_of("0123456789") == std::string::npos) word_.reset();
    EndWord();
    is_redirection_ = true;
  }
  void EndWord() {
    if (!word_) return;
    if (!is_redirection_) words_.push_back(*word_);
    is_redirection_ = false;
    word_.reset();
  }
  void EndCommand() {
    EndWord();
    is_redirection_ = false;
    if (!words_.empty()) commands_.push_back(std::move(words_));
    words_.clear();
  }

  std::vector<CallWords> commands_;
  CallWords words_;                  // words of the command that has begun
  std::optional<std::string> word_;  // word that has begun
  char quote_ = 0;                   // quote that is open; 0: none
  bool is_redirection_ = false;      // the next word is the file of a redirection
};

// Returns the calls of openr in a line of a shell, each as the words behind "openr".  Words before
// it, such as ./dev or gdb, are left out, and so is an openr without words.
inline std::vector<CallWords> CallsIn(const std::string& line) {
  const auto is_openr = [](const std::string& word) {
    return word == "openr" || word == "$openr" || word.ends_with("bin/openr");
  };
  std::vector<CallWords> calls;
  const ShellLine shell_line(line);
  for (const CallWords& words : shell_line.commands()) {
    const auto openr = std::find_if(words.begin(), words.end(), is_openr);
    if (openr != words.end() && openr + 1 != words.end())
      calls.emplace_back(openr + 1, words.end());
  }
  return calls;
}

// Says whether a call has all arguments that its command requires.
enum class Arguments { kAll, kSome };

// Lets `app` and the commands below it accept calls without commands and flags that are required.
// Keeps required words: without them CLI11 would take a word such as HOST for a command.
inline void RequireOnlyWords(CLI::App* app) {
  app->require_subcommand(0, 1);
  for (CLI::Option* const option : app->get_options([](CLI::Option*) { return true; })) {
    if (!option->get_positional()) option->required(false);
  }
  for (CLI::App* const command : app->get_subcommands([](CLI::App*) { return true; }))
    RequireOnlyWords(command);
}

// Reads the words of a call without doing the work.  Returns the error; nullopt if there is none.
inline std::optional<CLI::ParseError> ParseErrorOf(const CallWords& words, Arguments arguments) {
  CLI::App app;
  int exit_code = 0;
  DescribeProgram(&app, &exit_code, words.front());
  if (arguments == Arguments::kSome) RequireOnlyWords(&app);
  // Ends the reading when all is understood, before the command does its work.
  app.parse_complete_callback([] { throw CLI::Success(); });
  // CLI11 takes the words from the back.
  std::vector<std::string> reversed(words.rbegin(), words.rend());
  try {
    app.parse(reversed);
  } catch (const CLI::Success&) {
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    return error;
  }
  return CLI::ParseError("was understood without an end", CLI::ExitCodes::BaseClass);
}

}  // namespace openr_host
