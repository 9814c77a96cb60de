// docs/cli.md and the program's own help name the same flags.
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <sstream>

#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

std::string CliPage() {
  std::ifstream stream(OPENR_DOCS "/cli.md");
  std::ostringstream text;
  text << stream.rdbuf();
  const size_t begin = text.str().find("## openr\n");
  return begin == std::string::npos ? "" : text.str().substr(begin);
}

// The help of `command` and of all commands below it.
std::string HelpOf(std::vector<std::string> command) {
  command.insert(command.begin(), "help");
  std::string text = RunProgram(command).out;
  const size_t list = text.find("\nSubcommands:\n");
  if (list == std::string::npos) return text;
  std::istringstream lines(text.substr(list + 14));
  for (std::string line; std::getline(lines, line) && !line.empty();) {
    if (line[2] == ' ') continue;  // a description goes on
    std::vector<std::string> below(command.begin() + 1, command.end());
    below.push_back(line.substr(2, line.find(' ', 2) - 2));
    text += HelpOf(below);
  }
  return text;
}

std::set<std::string> FlagsIn(const std::string& text) {
  static const std::regex kFlag("--[a-z][a-z0-9-]*");
  std::set<std::string> flags;
  for (std::sregex_iterator it(text.begin(), text.end(), kFlag), end; it != end; ++it)
    flags.insert(it->str());
  return flags;
}

// The names of one line of the help: "-o,--output TEXT" is {"-o", "--output"}.
std::vector<std::string> NamesIn(const std::string& line) {
  static const std::regex kNames("^ +(?:(-[a-zA-Z]),?)?(--[a-z][a-z0-9-]*)?(?: .*)?$");
  std::smatch match;
  std::vector<std::string> names;
  if (!std::regex_match(line, match, kNames)) return names;
  for (size_t i = 1; i < match.size(); ++i) {
    if (match[i].matched) names.push_back(match[i]);
  }
  return names;
}

// "`-o OUT`" or "`--for D`, ..." somewhere on the page.
bool IsDocumented(const std::string& page, const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (std::regex_search(page, std::regex("[^a-z-]" + name + "(?![a-z-])"))) return true;
  }
  return false;
}

TEST(DocumentedFlagsTest, EveryFlagOfTheHelpIsOnThePage) {
  const std::string page = CliPage();
  ASSERT_FALSE(page.empty());
  std::istringstream help(HelpOf({}));
  int count = 0;
  for (std::string line; std::getline(help, line);) {
    const std::vector<std::string> names = NamesIn(line);
    if (names.empty() || names.back() == "--help" || names.back() == "--help-all") continue;
    ++count;
    EXPECT_TRUE(IsDocumented(page, names)) << "docs/cli.md does not tell of: " << line;
  }
  EXPECT_GT(count, 60);  // the help was understood
}

TEST(DocumentedFlagsTest, EveryFlagOnThePageIsInTheHelp) {
  const std::set<std::string> known = FlagsIn(HelpOf({}));
  for (const std::string& flag : FlagsIn(CliPage()))
    EXPECT_TRUE(known.contains(flag)) << flag << " of docs/cli.md is in no command's help";
}

}  // namespace
}  // namespace openr_host
