// Makefiles of which `make -n` runs commands.
#include "kit/dry_run.h"

#include <gtest/gtest.h>

#include <string>

namespace openr_host {
namespace {

TEST(DryRunTest, OrdinaryRulesOnlyPrintTheirCommands) {
  EXPECT_FALSE(DryRunRunsCommands(""));
  EXPECT_FALSE(
      DryRunRunsCommands("CXXFLAGS += -O2\nOBJS = a.o \\\n  b.o\n# calls $(MAKE)\n"
                         "%.o: %.cc\n\t@$(CXX) $(CXXFLAGS) -c $<\n"
                         "a.o b.o: def.h\nall: $(OBJS); @-echo +\n"));
}

TEST(DryRunTest, LinesMayBeLong) {
  const std::string data(100'000, 'f');
  EXPECT_FALSE(DryRunRunsCommands("define DATA\n" + data + "\nendef\nP = walk\n$(P) ." + data +
                                  ": walk.cc\n\tcp $< $@\n"));
}

TEST(DryRunTest, LinesThatCallMakeRun) {
  EXPECT_TRUE(DryRunRunsCommands("all:\n\tfor d in A B; do \\\n\t  (cd $$d; $(MAKE)); done\n"));
  EXPECT_TRUE(DryRunRunsCommands("all:\n\t${MAKE} -C Walker\n"));
}

TEST(DryRunTest, LinesWithThePrefixPlusRun) {
  EXPECT_TRUE(DryRunRunsCommands("all:\n\t+./build.sh\n"));
  EXPECT_TRUE(DryRunRunsCommands("all:\n\t@ -+./build.sh\n"));
  EXPECT_TRUE(DryRunRunsCommands("all: a.o; @+./build.sh\n"));
  EXPECT_FALSE(DryRunRunsCommands("all:\n\techo a + b\n"));
}

TEST(DryRunTest, IncludedMakefilesThatNoRuleMakesAreReadOnly) {
  EXPECT_FALSE(
      DryRunRunsCommands("TOP = ..\ninclude $(TOP)/Make.rules ../common.mk # both\n"
                         "all: a.o\n"));
}

TEST(DryRunTest, IncludedMakefilesThatARuleMakesAreMade) {
  const std::string include = "include ../settings.mk\n";
  for (const std::string rule :
       {"../settings.mk: settings.in\n\t./configure\n", "settings.mk other:; ./configure\n",
        "%.mk: %.in\n\tcp $< $@\n", ".in.mk:\n\tcp $< $@\n",
        "MADE := settings.mk\n$(MADE): settings.in\n\tcp $< $@\n"}) {
    EXPECT_TRUE(DryRunRunsCommands(include + rule)) << rule;
    EXPECT_FALSE(DryRunRunsCommands(rule)) << rule;
  }
  EXPECT_TRUE(DryRunRunsCommands("Makefile: Makefile.in\n\t./configure\n"));
}

TEST(DryRunTest, IncludedFilesOfUnknownTextMayBeMade) {
  EXPECT_TRUE(DryRunRunsCommands("-include $(SRCS:.cc=.d)\n"));
  EXPECT_TRUE(DryRunRunsCommands("  sinclude .depend\n"));
  EXPECT_TRUE(DryRunRunsCommands("include rules/*.mk\n"));
}

}  // namespace
}  // namespace openr_host
