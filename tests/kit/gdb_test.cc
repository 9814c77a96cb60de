// openr run --gdb, and the pretty printers of gdb.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "cli/process.h"
#include "openr/run/gdb_start.h"
#include "tests/kit/kit_folder.h"

namespace openr_host {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

bool MayDebug() {
#if defined(__SANITIZE_ADDRESS__)
  return false;  // leak checks do not work under a debugger
#endif
  if (!std::filesystem::exists("/usr/bin/gdb")) return false;
  return ProgramRun({"-q", "-batch", "-ex", "run", "--args", "/bin/true"}, "/usr/bin/gdb")
             .Finish()
             .out.find("exited normally") != std::string::npos;
}

// Runs a new object Wag under gdb, which gets `commands` after it has stopped at the first handler.
std::string UnderGdb(const std::string& commands) {
  const KitFolder folder("");
  EXPECT_EQ(RunProgram({"new", "Wag", folder.File("")}).status, 0);
  EXPECT_EQ(folder.Build({"--debug"}).status, 0);
  const ProcessResult result =
      RunProcess({OPENR_PROGRAM, "run", "--stick", folder.File("MS"), "--for", "200ms", "--rate",
                  "max", "--no-panel", "--rc-port", "0", "--gdb", "wag"},
                 {.captures_error = true, .captures_out = true, .input = commands});
  return result.output;
}

TEST(GdbTest, ItStopsInEveryHandlerOfTheObject) {
  if (!MayDebug()) GTEST_SKIP() << "gdb is not installed, or may not debug";
  const std::string said = UnderGdb("continue\ncontinue\nbt 1\nkill\nquit\n");
  EXPECT_THAT(said, HasSubstr("Wag::DoInit (this="));
  EXPECT_THAT(said, HasSubstr("Wag::DoStart (this="));
  EXPECT_THAT(said, HasSubstr("Wag::NotifySensor (this="));
  EXPECT_THAT(said, HasSubstr("Wag/Wag.cc:"));
}

TEST(GdbTest, PrintersShowRegionsAndVectors) {
  if (!MayDebug()) GTEST_SKIP() << "gdb is not installed, or may not debug";
  const std::string said = UnderGdb(
      "continue\ncontinue\nnext\nnext\nprint event\nprint *event.rcr_[0]\nprint "
      "*vector\nprint (OPrimitiveID)vector->info[0].primitiveID\nkill\nquit\n");
  EXPECT_THAT(said, HasSubstr("notification for observer 0, 1 data"));
  EXPECT_THAT(said, HasSubstr(" references"));
  EXPECT_THAT(said, HasSubstr("OSensorFrameVectorData, 31 of "));
  EXPECT_THAT(said, HasSubstr("[0] = PRM:/r1/c1-Joint2:j1, frame "));
  EXPECT_THAT(said, HasSubstr(" = 4096 PRM:/r1/c1-Joint2:j1\n"));
}

// The commands of gdb in the section "Debug an object" of docs/hacking.md.
TEST(GdbTest, TheExampleForTheObjectsOfThisTreeStopsWhereItSays) {
  if (!MayDebug()) GTEST_SKIP() << "gdb is not installed, or may not debug";
  std::ifstream page(std::string(OPENR_KIT_FIXTURES) + "/../../../docs/hacking.md");
  std::vector<std::string> words = {"-q", "-batch"};
  int commands = 0;
  for (std::string line; std::getline(page, line);) {
    constexpr char kPrompt[] = "    (gdb) ";
    if (!line.starts_with(kPrompt)) continue;
    words.insert(words.end(), {"-ex", line.substr(sizeof kPrompt - 1)});
    ++commands;
  }
  ASSERT_EQ(commands, 3);
  words.insert(words.end(), {"-ex", "bt", "-ex", "kill", "--args", OPENR_PROGRAM, "run", "--rate",
                             "max", "--handler-limit", "0s", "--no-panel", "--rc-port", "0"});
  const std::string said = ProgramRun(words, "/usr/bin/gdb").Finish().out;
  EXPECT_THAT(said, HasSubstr("Breakpoint 1, JointMover::DoStart (this="));
  EXPECT_THAT(said, HasSubstr("JointMover.cc:"));
  EXPECT_THAT(said, HasSubstr("openr_host::Dispatcher::"));
}

TEST(GdbTest, AnUnknownObjectIsRefused) {
  const ProgramResult result = RunProgram({"run", "--gdb", "JointMovr"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("--gdb: no object 'JointMovr' on "));
  EXPECT_THAT(result.err, HasSubstr("did you mean 'JointMover'?"));
}

// gdb itself is not needed: the object has been found when gdb cannot be.
TEST(GdbTest, TheNameOfTheObjectMayBeInAnotherCase) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nowhere", 1);
  const ProgramResult result = RunProgram({"run", "--gdb", "jointmover"});
  setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("--gdb: gdb cannot be started: "));
}

TEST(GdbTest, HandlersAreMethodsThatTakeEvents) {
  EXPECT_THAT(
      HandlersAmong({"_ZN3Wag6DoInitERK12OSystemEvent", "_ZN3Wag12NotifySensorERK12ONotifyEvent",
                     "_ZN3Wag4HelpEv", "_ZN5Other7DoStartERK12OSystemEvent", "main"}),
      ElementsAre("Wag::DoInit(OSystemEvent const&)", "Wag::NotifySensor(ONotifyEvent const&)"));
}

}  // namespace
}  // namespace openr_host
