// The progress line of openr build: how many sources are compiled, and how many there are.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <set>
#include <string>

#include "kit/build_variant.h"
#include "kit/convention_build.h"
#include "kit/kit_log.h"
#include "kit/make_build.h"
#include "kit/sdk_paths.h"
#include "tests/kit/kit_folder.h"
#include "tests/openr/terminal_run.h"

namespace openr_host {
namespace {

using testing::HasSubstr;

// Returns what openr build shows on a terminal.
std::string ShownByBuild(const KitFolder& folder) {
  setenv("OPENR_HOST_PROGRESS_MS", "0", 1);  // so that a short build shows the line
  TerminalRun build({"build", folder.File("")}, "(");
  unsetenv("OPENR_HOST_PROGRESS_MS");
  EXPECT_EQ(build.Finish(), 0) << build.shown();
  return build.shown();
}

TEST(BuildProgressTest, CounterAddsTheLogsOfABuildAndLeavesOutEarlierBuilds) {
  KitFolder folder("");
  const std::string old_line = "compile\told.cc\t/\n", new_line = "compile\tnew.cc\t/\n";
  folder.Write("a.txt", old_line);
  CompileCounter counter;
  EXPECT_EQ(counter.CountIn(folder.File("a.txt")), 0u);
  folder.Write("a.txt", old_line + new_line + "made\tnew.o\n" + new_line);
  EXPECT_EQ(counter.CountIn(folder.File("a.txt")), 2u);
  EXPECT_EQ(counter.CountIn(folder.File("b.txt")), 2u);  // the file does not exist yet
  folder.Write("b.txt", new_line);
  EXPECT_EQ(counter.CountIn(folder.File("b.txt")), 3u);
  // A log that gets shorter, when repeated lines are removed, takes nothing away.
  folder.Write("a.txt", old_line);
  EXPECT_EQ(counter.CountIn(folder.File("a.txt")), 3u);
}

TEST(BuildProgressTest, SourcesAreCountedInTheCommandsOfMake) {
  EXPECT_EQ(CountSourcesIn("cd Walker; make\nstubgen2 stub.cfg\n"
                           "/sdk/bin/mipsel-linux-g++ -O2 -o W.o -c W.cc\n"
                           "/sdk/bin/mipsel-linux-gcc -O2 \\\n  -c a.c b.c\n"
                           "mipsel-linux-g++ -M W.cc\nmkbin -o W.bin W.o\n"),
            3u);
  EXPECT_EQ(CountSourcesIn(""), 0u);
}

TEST(BuildProgressTest, SourcesThatNoMakefileNamesAreNotCounted) {
  KitFolder folder("");
  folder.AddObject("Walker", "Walker", "", "");
  folder.AddMakefile("Walker", "Walker");
  folder.AddStick("MS", {"WALKER.BIN"});
  folder.Write("Walker/Unused.cc", "int unused;\n");
  EXPECT_THAT(ShownByBuild(folder), HasSubstr(" of 2 sources compiled"));
}

// make -n runs lines with $(MAKE), and a build asks make whether there is a target `install`.
TEST(BuildProgressTest, LinesThatCallMakeRunOnceAndTheirSourcesAreNotCountedBefore) {
  KitFolder folder("");
  const std::string ran = folder.scratch().File("ran.txt");
  folder.AddObject("Walker", "Walker", "", "");
  folder.AddMakefile("Walker", "Walker");
  folder.AddStick("MS", {"WALKER.BIN"});
  folder.Write("Makefile", "all install:\n\techo $@ >> " + ran + "; $(MAKE) -C Walker $@\n");
  const std::string shown = ShownByBuild(folder);
  EXPECT_THAT(shown, HasSubstr(" sources compiled"));
  EXPECT_THAT(shown, testing::Not(HasSubstr(" of 2 sources compiled")));
  EXPECT_EQ(folder.scratch().Read("ran.txt"), "all\ninstall\n");
}

TEST(BuildProgressTest, SourcesOfObjectsWithoutMakefilesAreCounted) {
  KitFolder folder("");
  folder.AddObject("Walker", "Walker", "", "");
  folder.AddObject("Talker", "Talker", "", "");
  folder.AddStick("MS", {"WALKER.BIN", "TALKER.BIN"});
  folder.Write("common/Unused.cc", "int unused;\n");
  EXPECT_THAT(ShownByBuild(folder), HasSubstr(" of 4 sources compiled"));
}

TEST(BuildProgressTest, CompilationsOfObjectsWithoutMakefilesAreSeenWhileMakeRuns) {
  KitFolder folder("");
  folder.AddObject("Walker", "Walker", "", "");
  folder.AddObject("Talker", "Talker", "", "");
  const Project project = ScanProject({folder.File("")});
  CompileCounter counter;
  std::set<std::string> logs;
  MakeOptions options;
  options.sdk_root = SdkRoot();
  options.log = folder.File("log.txt");
  options.variant = VariantName(BuildVariant::kPlain);
  options.while_waiting = [&](const std::string& log) {
    logs.insert(log);
    counter.CountIn(log);
  };
  EXPECT_THAT(BuildByConvention(project, project.objects, {}, folder.File("work"), options),
              testing::IsEmpty());
  uint64_t count = 0;
  for (const std::string& log : logs) count = counter.CountIn(log);
  EXPECT_EQ(count, 4u);
  EXPECT_EQ(count, CountByConvention(project, project.objects));
}

}  // namespace
}  // namespace openr_host
