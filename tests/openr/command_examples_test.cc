// Every command has examples in its help, and what they say is a command line that is understood.
#include "openr/commands/command_examples.h"

#include <gmock/gmock.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <sstream>

#include "openr/commands/command_tree.h"
#include "openr/commands/commands.h"
#include "tests/openr/command_check.h"
#include "tests/openr/program_run.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;

// Returns the words behind "openr" in an example; none if it is no call of openr.
CallWords WordsOf(const std::string& line) {
  const std::vector<CallWords> calls = CallsIn(line);
  return calls.empty() ? CallWords{} : calls.front();
}

// Returns why the program does not understand an example; "" if it does.
std::string CommandProblem(const std::string& line) {
  const CallWords words = WordsOf(line);
  if (words.empty()) return "is no call of openr";
  const std::optional<CLI::ParseError> error = ParseErrorOf(words, Arguments::kAll);
  return error ? error->what() : "";
}

// Returns whether a command line calls the command `path`.  Other words may stand between those of
// the path ("openr rc ADDRESS info").
bool Calls(const std::string& line, const std::string& path) {
  const CallWords words = WordsOf(line);
  std::istringstream wanted(path);
  auto from = words.begin();
  for (std::string word; wanted >> word; ++from) {
    from = std::find(from, words.end(), word);
    if (from == words.end()) return false;
  }
  return true;
}

void AddPaths(const CommandInfo& command, std::vector<std::string>* paths) {
  for (const CommandInfo& below : command.commands) {
    paths->push_back(below.path.substr(below.path.find(' ') + 1));
    AddPaths(below, paths);
  }
}

std::vector<std::string> AllPaths() {
  CLI::App app;
  int exit_code = 0;
  DescribeProgram(&app, &exit_code, "");
  std::vector<std::string> paths = {""};
  AddPaths(DescribeCommands(app), &paths);
  return paths;
}

// A folder with the files that examples name, as the working folder.
class CommandExamplesTest : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"run.trace", "WALK.MTN", "MINE.MTN", "CONTROLL.BIN", "walk.log",
                             "walk.csv", "MOTION.ODA", "stub.cfg"})
      folder_.Write(name, "");
    for (const char* name : {"mystick", "Greeter", "wag"})
      std::filesystem::create_directory(folder_.File(name));
    before_ = std::filesystem::current_path();
    std::filesystem::current_path(folder_.path());
  }
  void TearDown() override { std::filesystem::current_path(before_); }

  const ScratchFolder folder_;
  std::filesystem::path before_;
};

TEST_F(CommandExamplesTest, EveryCommandHasExamplesThatAreUnderstood) {
  const std::vector<std::string> paths = AllPaths();
  EXPECT_GT(paths.size(), 60u);
  for (const std::string& path : paths) {
    const std::vector<std::string> lines = ExamplesOf(path);
    EXPECT_FALSE(lines.empty()) << "openr " << path << " has no example (command_examples.cc)";
    for (const std::string& line : lines) {
      EXPECT_EQ(CommandProblem(line), "") << line;
      EXPECT_TRUE(Calls(line, path)) << line << " is no example of " << path;
    }
  }
}

TEST_F(CommandExamplesTest, AWrongExampleWouldBeFound) {
  EXPECT_NE(CommandProblem("openr run --fro 20s"), "");
  EXPECT_NE(CommandProblem("openr mtn plya WALK.MTN"), "");
  EXPECT_NE(CommandProblem("openr run --robot ers9"), "");
  EXPECT_EQ(CommandProblem("openr run --for 20s   # comment --nonsense"), "");
}

TEST_F(CommandExamplesTest, TheHelpOfTheProgramAndOfCommandsShowsThem) {
  EXPECT_THAT(RunProgram({"--help"}).out, HasSubstr("Examples:\n  openr run "));
  EXPECT_THAT(RunProgram({"mtn", "plot", "--help"}).out,
              HasSubstr("Examples:\n  openr mtn plot WALK.MTN -o walk.svg\n"));
  EXPECT_THAT(RunProgram({"help", "explore"}).out, HasSubstr("Examples:\n  openr explore"));
}

}  // namespace
}  // namespace openr_host
