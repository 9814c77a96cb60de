// --wrap: a worker under a tool of the developer.
#include <gmock/gmock.h>

#include "tests/distribution/same_run.h"

namespace openr_host {
namespace {

TEST(WrapTest, UnderValgrindTheObjectDoesTheSame) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "no sanitizers under Valgrind";
#endif
  if (std::system("valgrind --version > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "valgrind is not installed";
  const Words flags = {"--for", "500ms", "--body", "ideal"};
  const RecordedRun one = Record(flags);
  const RecordedRun watched = Record(flags + Isolated({"JointMover"}) +
                                     Words{"--handler-limit", "0s", "--wrap", "valgrind -q"});
  ExpectSame(one, watched);
  EXPECT_THAT(watched.err, ::testing::Not(::testing::HasSubstr("Invalid "))) << "false reports";
}

TEST(WrapTest, ValgrindReportsWhatAnObjectDoesWrong) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "no sanitizers under Valgrind";
#endif
  if (std::system("valgrind --version > /dev/null 2>&1") != 0)
    GTEST_SKIP() << "valgrind is not installed";
  const ScratchFolder stick;
  stick.MakeTrouble("crash");
  const ProgramResult result =
      RunProgram(kQuickly + Words{"--for", "100ms", "--stick", stick.path(), "--isolate", "Trouble",
                                  "--handler-limit", "0s", "--wrap", "valgrind -q"});
  EXPECT_THAT(result.err, ::testing::HasSubstr("Invalid write of size 4"));
}

bool MayDebug() {
#if defined(__SANITIZE_ADDRESS__)
  return false;  // leak checks do not work under a debugger
#endif
  const std::string gdb = "/usr/bin/gdb";
  if (!std::filesystem::exists(gdb)) return false;
  return ProgramRun({"-q", "-batch", "-ex", "run", "--args", "/bin/true"}, gdb)
             .Finish()
             .out.find("exited normally") != std::string::npos;
}

TEST(WrapTest, UnderGdbABreakpointStopsAndTheRunIsTheSame) {
  if (!MayDebug()) GTEST_SKIP() << "gdb is not installed, or may not debug";
  const ScratchFolder folder;
  folder.Write("commands",
               "set breakpoint pending on\nbreak JointMover::DoStart\nrun\nbt 1\ncontinue\n");
  const Words flags = {"--for", "500ms", "--body", "ideal"};
  const RecordedRun debugged =
      Record(flags + Isolated({"JointMover"}) +
             Words{"--handler-limit", "0s", "--stdin", "/dev/null", "--wrap",
                   "gdb -q -batch -x " + folder.File("commands") + " --args"});
  ExpectSame(Record(flags), debugged);
  // The run may print between the two texts.
  EXPECT_THAT(debugged.err, ::testing::HasSubstr("Breakpoint 1, "));
  EXPECT_THAT(debugged.err, ::testing::HasSubstr("JointMover::DoStart (this="));
  EXPECT_THAT(debugged.err, ::testing::HasSubstr("exited normally"));
}

// A tool is started with its own words, followed by the command of the worker.
TEST(WrapTest, UnderAScriptTheObjectDoesTheSame) {
  const ScratchFolder folder;
  folder.Write("tool", "#!/bin/sh\necho \"$1 of $$: $*\" >> " + folder.File("told") +
                           "\nshift\nexec \"$@\"\n");
  std::filesystem::permissions(folder.File("tool"), std::filesystem::perms::owner_all);
  const Words flags = {"--for", "500ms", "--body", "ideal"};
  const RecordedRun wrapped =
      Record(flags + Isolated({"JointMover"}) + Words{"--wrap", folder.File("tool") + "  -word"});
  ExpectSame(Record(flags), wrapped);
  const std::string told = folder.Read("told");
  EXPECT_THAT(told, ::testing::HasSubstr(" join --child-of "));
  EXPECT_THAT(told, ::testing::HasSubstr("--process JointMover"));
  EXPECT_EQ(std::count(told.begin(), told.end(), '\n'), 1);
  const json& process = wrapped.report["processes"][0];
  EXPECT_EQ(told.find("-word of " + process["pid"].dump() + ": -word "), 0u) << told;
}

TEST(WrapTest, AMissingToolIsNamed) {
  const ProgramResult result = RunProgram(
      kQuickly + Words{"--for", "1s", "--isolate", "JointMover", "--wrap", "no-such-tool -q"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, ::testing::HasSubstr("no-such-tool"));
}

}  // namespace
}  // namespace openr_host
