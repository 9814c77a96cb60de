// openr build: programs of which something fails, and what is delivered and said then.
#include <elf.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "kit/make_build.h"
#include "tests/kit/kit_folder.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr char kLoop[] =
    "all install:\n\tfor d in $(DIRS); do (cd $$d && $(MAKE) $@) || exit 1; done\n";

// An archive with one object file for MIPS.
std::string MipsLibrary() {
  Elf32_Ehdr header{};
  std::memcpy(header.e_ident, ELFMAG, SELFMAG);
  header.e_ident[EI_CLASS] = ELFCLASS32;
  header.e_ident[EI_DATA] = ELFDATA2LSB;
  header.e_type = ET_REL;
  header.e_machine = EM_MIPS;
  const std::string object(reinterpret_cast<const char*>(&header), sizeof header);
  char member[61];
  std::snprintf(member, sizeof member, "%-16s%-12d%-6d%-6d%-8o%-10zu`\n", "vision.o/", 0, 0, 0,
                0644, object.size());
  return "!<arch>\n" + std::string(member) + object;
}

// Three objects in folders that a loop visits in order; the middle one does not compile.
class OneBrokenOfThree : public ::testing::Test {
 protected:
  OneBrokenOfThree() {
    for (const char* name : {"First", "Middle", "Last"}) {
      folder_.AddObject(name, name, "", KitFolder::Printing(std::string(name) + " runs"));
      folder_.AddMakefile(name, name);
    }
    folder_.Write("Middle/Middle.cc", "int broken(\n");
    folder_.Write("Makefile", std::string("DIRS = First Middle Last\n") + kLoop);
  }

  KitFolder folder_{""};
};

TEST_F(OneBrokenOfThree, TheOthersAreDeliveredWithStatusOne) {
  folder_.AddStick("MS", {"FIRST.BIN", "MIDDLE.BIN", "LAST.BIN"});
  const ProgramResult result = folder_.Build();
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.out, HasSubstr("FIRST.BIN"));
  EXPECT_THAT(result.out, HasSubstr("LAST.BIN"));
  EXPECT_THAT(result.err, HasSubstr("Middle.cc does not compile"));
  EXPECT_THAT(result.err, HasSubstr("OBJECT.CFG:2: /MS/OPEN-R/MW/OBJS/MIDDLE.BIN was not built"));
  EXPECT_TRUE(fs::exists(folder_.File("MS/OPEN-R/MW/OBJS/FIRST.BIN")));
  EXPECT_TRUE(fs::exists(folder_.File("MS/OPEN-R/MW/OBJS/LAST.BIN")));
}

TEST_F(OneBrokenOfThree, TheStatusIsZeroWhenObjectCfgDoesNotNameIt) {
  folder_.AddStick("MS", {"FIRST.BIN", "LAST.BIN"});
  const ProgramResult result = folder_.Build();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err,
              HasSubstr("note: Middle: " + folder_.File("Middle/Middle.cc") + " does not compile"));
  EXPECT_EQ(folder_.Say(), "First runs\nLast runs\n");
}

TEST_F(OneBrokenOfThree, TheSameHoldsWithoutMakefiles) {
  for (const char* name : {"Makefile", "First/Makefile", "Middle/Makefile", "Last/Makefile"})
    fs::remove(folder_.File(name));
  folder_.AddStick("MS", {"FIRST.BIN", "LAST.BIN"});
  const ProgramResult result = folder_.Build();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(folder_.Say(), "First runs\nLast runs\n");
}

TEST_F(OneBrokenOfThree, WithoutObjectCfgAllObjectsAreWanted) {
  const ProgramResult result = folder_.Build();
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("openr build: Middle: " + folder_.File("Middle/Middle.cc")));
  EXPECT_FALSE(fs::exists(folder_.File("MS/OPEN-R/MW/CONF/OBJECT.CFG")));
}

// The image of an earlier build is no image of this one.
TEST_F(OneBrokenOfThree, AnObjectThatCompiledBeforeAndNowDoesNotIsMissing) {
  folder_.AddStick("MS", {"FIRST.BIN", "MIDDLE.BIN", "LAST.BIN"});
  folder_.AddObject("Middle", "Middle", "", KitFolder::Printing("Middle runs"));
  ASSERT_EQ(folder_.Build().status, 0);
  folder_.Write("Middle/Middle.cc", "int broken(\n");
  const ProgramResult result = folder_.Build();
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.out, Not(HasSubstr("MIDDLE.BIN")));
  EXPECT_THAT(result.err, HasSubstr("OBJECT.CFG:2: /MS/OPEN-R/MW/OBJS/MIDDLE.BIN was not built"));
}

// Each object has a Makefile of its own, and none calls the others.  Make finds nothing to do for
// Last, whose image is older than a source that its Makefile does not name.
TEST(BuildFailuresTest, MakeLinksAgainAnImageThatWasRemovedAsOld) {
  const KitFolder folder("");
  folder.AddObject("First", "First", "", KitFolder::Printing("First runs"));
  folder.AddMakefile("First", "First");
  folder.AddObject("Last", "Last", "", "    OSYSPRINT((\"Last has %d\\n\", NUMBER));");
  folder.AddMakefile("Last", "Last", "DEFS=-DNUMBER=7\n");
  folder.AddStick("MS", {"LAST.BIN"});
  ASSERT_EQ(folder.Build().status, 0);
  folder.Write("First/First.cc", "int broken(\n");
  folder.Write("Last/Unused.cc", "int unused;\n");
  const ProgramResult result = folder.Build();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, Not(HasSubstr("the Makefiles made no image of Last")));
  EXPECT_EQ(folder.Say(), "Last has 7\n");
}

// Two objects that each compile common/Util.cc.  First comes first.
class OneSourceOfTwo : public ::testing::Test {
 protected:
  OneSourceOfTwo() {
    for (const std::string name : {"First", "Last"}) {
      folder_.AddObject(name, name, "const char* Util();\n",
                        "    OSYSPRINT((\"" + name + " has %s\\n\", Util()));");
      folder_.AddMakefile(name, name, "", "Util.o");
      folder_.Write(name + "/Makefile", folder_.Read(name + "/Makefile") +
                                            "\nUtil.o: ../common/Util.cc\n"
                                            "\t$(CXX) $(CXXFLAGS) -o $@ -c $<\n");
    }
    folder_.Write("common/Util.cc", "const char* Util() { return \"one\"; }\n");
    folder_.Write("Makefile", std::string("DIRS = First Last\n") + kLoop);
  }

  KitFolder folder_{""};
};

// The loop ends at the first object, before make looks at the second one.
TEST_F(OneSourceOfTwo, AnImageOlderThanASourceOutsideOfItsFolderIsMadeAgain) {
  folder_.AddStick("MS", {"LAST.BIN"});
  ASSERT_EQ(folder_.Build().status, 0);
  folder_.Write("common/Util.cc", "const char* Util() { return \"two\"; }\n");
  folder_.Write("First/First.cc", "int broken(\n");
  const ProgramResult result = folder_.Build();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(folder_.Say(), "Last has two\n");
}

// The Makefile ignores that the source compiles for no object.
TEST_F(OneSourceOfTwo, ASourceThatFailsForBothLeavesNoOldImage) {
  folder_.AddStick("MS", {"FIRST.BIN"});
  folder_.Write("Makefile",
                "all install:\n\t-for d in First Last; do (cd $$d && $(MAKE) $@); done\n");
  ASSERT_EQ(folder_.Build().status, 0);
  folder_.Write("common/Util.cc", "int broken(\n");
  const ProgramResult result = folder_.Build();
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.out, Not(HasSubstr("FIRST.BIN")));
  EXPECT_THAT(result.err, HasSubstr("OBJECT.CFG:1: /MS/OPEN-R/MW/OBJS/FIRST.BIN was not built"));
  EXPECT_THAT(result.err, HasSubstr("Util.cc does not compile"));
  EXPECT_EQ(result.err.find("Util.cc does not compile"),
            result.err.rfind("Util.cc does not compile"));
}

// make lacks a tool; the sources need what their Makefile defines, and the right of two headers.
TEST(BuildFailuresTest, WithoutTheMakefileItsFlagsHold) {
  const KitFolder folder("");
  folder.AddObject("Walker", "Walker",
                   "#include \"Gait.h\"\n#if LEGS != 4\n#error no LEGS\n#endif\n",
                   "    OSYSPRINT((\"%s on %d legs\\n\", GAIT, LEGS));");
  folder.AddMakefile("Walker", "Walker", "DEFS = -DLEGS=4 -I../lib/new\n");
  folder.Write("Walker/Makefile",
               folder.Read("Walker/Makefile") +
                   "\nWalker.o: table.h\n\ntable.h:\n\tmaketable --all > table.h\n");
  folder.Write("lib/a_old/Gait.h", "#error the wrong header\n");
  folder.Write("lib/new/Gait.h", "#define GAIT \"trot\"\n");
  folder.AddStick("MS", {"WALKER.BIN"});
  const ProgramResult result = folder.Build();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("note: make failed: the rule for 'table.h'"));
  EXPECT_THAT(result.err, HasSubstr("maketable: command not found"));
  EXPECT_EQ(folder.Say(), "trot on 4 legs\n");
}

TEST(BuildFailuresTest, TheLastLineIsWhatMakeLacked) {
  const KitFolder folder("");
  folder.AddObject("Walker", "Walker", "#include \"table.h\"\n", "    int legs = TABLE;");
  folder.AddMakefile("Walker", "Walker", "", "");
  folder.Write("Walker/Makefile", folder.Read("Walker/Makefile") + "\nWalker.o: ../gen/table.h\n");
  folder.AddStick("MS", {"WALKER.BIN"});
  const ProgramResult result = folder.Build();
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, ::testing::EndsWith("openr build: make failed: No rule to make target "
                                              "'../gen/table.h', needed by 'Walker.o'\n"));
}

TEST(BuildFailuresTest, TheCauseIsTheFirstComplaintOfMake) {
  EXPECT_EQ(CauseOf("a.cc:1: warning\nmake[1]: *** No rule to make target 'x.h', needed by 'a.o'.\n"
                    "make[1]: Target 'all' not remade because of errors.\n"
                    "make: *** [Makefile:3: all] Error 2\n"),
            "No rule to make target 'x.h', needed by 'a.o'");
  EXPECT_EQ(CauseOf("/bin/bash: line 1: perl5: command not found\n"
                    "make: *** [Makefile:3: all] Error 127\n"),
            "the rule for 'all' (Makefile:3) failed: /bin/bash: line 1: perl5: command not found");
  EXPECT_EQ(CauseOf("a.cc:1: error\nmake: *** [Makefile:3: a.o] Error 1\n"
                    "make: *** No rule to make target 'x.h', needed by 'b.o'.\n"),
            "No rule to make target 'x.h', needed by 'b.o'");
  EXPECT_EQ(CauseOf("Makefile:7: *** missing separator.  Stop.\n"),
            "Makefile:7: missing separator");
  EXPECT_EQ(
      CauseOf("\x1b[01m\x1b[Ka.cc:1:\x1b[m\x1b[K error\nmake: *** [Makefile:3: a.o] Error 1\n"),
      "the rule for 'a.o' (Makefile:3) failed: a.cc:1: error");
  EXPECT_EQ(CauseOf("all went well\n"), "");
  EXPECT_EQ(CauseOf(std::string(100'000, 'x') + "\nmake: *** No rule to make target 'y'.  Stop.\n"),
            "No rule to make target 'y'");
}

TEST(BuildFailuresTest, ALibraryForAnotherProcessorIsCalledThat) {
  for (const char* library : {"../lib/libvision.a", "-L../lib -lvision"}) {
    const KitFolder folder("");
    folder.AddObject("Seer", "Seer", "extern int See();\n", "    See();");
    folder.AddMakefile("Seer", "Seer", std::string("LIBS = ") + library + "\n");
    folder.Write("lib/libvision.a", MipsLibrary());
    folder.AddStick("MS", {"SEER.BIN"});
    const ProgramResult result = folder.Build();
    EXPECT_EQ(result.status, 1);
    EXPECT_THAT(result.err, HasSubstr("openr build: " + folder.File("lib/libvision.a") +
                                      ": is a library for another processor (MIPS)"));
  }
}

TEST(BuildFailuresTest, ALibraryForAnotherProcessorIsRefusedWhereverItLies) {
  const KitFolder folder("");
  folder.scratch().Write("elsewhere/libvision.a", MipsLibrary());
  const std::string library = folder.scratch().File("elsewhere/libvision.a");
  folder.AddObject("Seer", "Seer", "extern int See();\n", "    See();");
  folder.AddMakefile("Seer", "Seer", "LIBS = " + library + "\n");
  folder.AddStick("MS", {"SEER.BIN"});
  const ProgramResult result = folder.Build();
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err,
              HasSubstr("mkbin: " + library + " is a library for another processor (MIPS)"));
}

}  // namespace
}  // namespace openr_host
