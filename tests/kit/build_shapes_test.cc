// openr build: legal but odd shapes of programs, and old C++ that needs help.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "kit/image_match.h"
#include "kit/shell_words.h"
#include "tests/kit/kit_folder.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

// Four sources include a header that has to be repaired.  Compilers of two jobs meet in it: each
// includes it first and takes long afterwards.
TEST(BuildShapesTest, AHeaderThatTwoCompilersNeedRepairedDoesNotFailTheFirstBuild) {
  const KitFolder folder("");
  folder.AddObject("Walker", "Walker", "#include \"Gait.h\"\n", "    Step(1, 2);");
  std::string objects;
  for (int i = 0; i < 6; ++i) {
    const std::string name = "part" + std::to_string(i);
    objects += name + ".o ";
    folder.Write("Walker/" + name + ".cc",
                 "#include \"Gait.h\"\n#include <map>\n#include <iostream>\n"
                 "std::map<int, std::string> names" +
                     std::to_string(i) + ";\n");
  }
  folder.Write("Walker/Step.cc", "#include \"Gait.h\"\nvoid Step(int a, int b) { Loops(); }\n");
  folder.Write("Walker/Gait.h",
               "#ifndef GAIT_H\n#define GAIT_H\n#include <string>\nvoid Step(int a, int a);\n"
               "inline int Loops() { for (int i = 0; i < 2; i++) {} return i; }\n#endif\n");
  folder.AddMakefile("Walker", "Walker", "", objects + "Step.o");
  // The shell's loop hides the status of make, as many did.
  folder.Write("Makefile",
               "all install:\n\tfor d in Walker; do (cd $$d; $(MAKE) $@); done; true\n");
  folder.AddStick("MS", {"WALKER.BIN"});
  const ProgramResult result = folder.Build({"-j", "2", "--verbose"});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, Not(HasSubstr("redefinition of")));
  EXPECT_THAT(result.err, HasSubstr("Gait.h:4: the second parameter called 'a'"));
}

TEST(BuildShapesTest, ANameOfTheGlobalScopeMayBeQualified) {
  const KitFolder folder("");
  folder.AddObject("Walker", "Walker",
                   "int ::Legs();\nstatic const char* ::Name(int (*)(int)) { return \"walker\"; }\n"
                   "int ::Legs() { return 4; }\n",
                   "    OSYSPRINT((\"%s %d\\n\", Name(0), Legs()));");
  folder.AddStick("MS", {"WALKER.BIN"});
  const ProgramResult result = folder.Build();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(folder.Say(), "walker 4\n");
}

TEST(BuildShapesTest, AssemblyCostsATrapAndNotTheObject) {
  const KitFolder folder("");
  folder.Write(
      "Walker/cycles.h",
      "#define CACHE(p) __asm__ __volatile__ (\"cache 0x15, 0(%0)\" \\\n"
      "                                       : : \"r\"(p))\n"
      "inline unsigned Cycles()\n{\n    unsigned n;\n    asm volatile (\"mfc0 %0, $9\\n\\t\"\n"
      "                  \"nop\"\n                  : \"=r\" (n));\n    return n;\n}\n");
  folder.AddObject("Walker", "Walker",
                   "#include \"cycles.h\"\nasm(\".globl tick\\ntick: jr $31\\n\");\n"
                   "int Sum(int a, int b) { int c; asm(\"addu %0,%1,%2\" : \"=r\"(c) : \"r\"(a), "
                   "\"r\"(b) : \"$8\"); return c; }\n"
                   "unsigned Stack() { register unsigned sp asm(\"$29\"); return sp; }\n"
                   "void Flush(char* p) { CACHE(p); }\n",
                   "    asm volatile (\"sync\");\n    asm (\"\" : : : \"memory\");\n"
                   "    if (event.dummy == 1) { Cycles(); Sum(1, 2); Stack(); Flush(0); }\n" +
                       KitFolder::Printing("still here"));
  std::string source = folder.Read("Walker/Walker.cc");
  source.replace(source.find("event.dummy == 1"), 16, "subject[0] == 0");
  folder.Write("Walker/Walker.cc", source);
  folder.AddStick("MS", {"WALKER.BIN"});
  const ProgramResult result = folder.Build();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("note: " + folder.File("Walker/cycles.h") +
                                    ":6: assembly for the "
                                    "robot's processor left out; the object stops with a trap"));
  EXPECT_THAT(result.err, HasSubstr("sync of the robot's processor became a barrier"));
  EXPECT_THAT(result.err, Not(HasSubstr("rror:")));
  EXPECT_EQ(folder.Say(), "still here\n");
}

TEST(BuildShapesTest, AssemblyThatIsReachedStopsTheObject) {
  const KitFolder folder("");
  folder.AddObject("Walker", "Walker", "",
                   "    asm(\"mtc0 $0, $11\");\n" + KitFolder::Printing("too far"));
  folder.AddStick("MS", {"WALKER.BIN"});
  ASSERT_EQ(folder.Build().status, 0);
  const std::string said = folder.Say();
  EXPECT_THAT(said, Not(HasSubstr("too far")));
}

TEST(BuildShapesTest, TheLanguageLevelOfAMakefileCounts) {
  const KitFolder folder("");
  folder.AddObject("Walker", "Walker", "extern \"C\" int Count(int n);\n",
                   "    OSYSPRINT((\"%d\\n\", Count(3)));");
  folder.Write(
      "Walker/count.c",
      "int Count(int n) { int sum = 0; for (int i = 0; i <= n; i++) sum += i; return sum; }\n");
  folder.AddMakefile("Walker", "Walker", "CC=$(PREFIX)/bin/mipsel-linux-gcc\nCFLAGS=-std=c99 -O2\n",
                     "count.o");
  folder.AddStick("MS", {"WALKER.BIN"});
  const ProgramResult result = folder.Build();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(folder.Say(), "6\n");
}

// The Makefile puts the image on one of two sticks, under a name of its own.
TEST(BuildShapesTest, ANameThatMakeUsesOnOneStickServesTheOthers) {
  const KitFolder folder("");
  folder.AddObject("Walker", "Walker", "", KitFolder::Printing("walking"));
  folder.AddMakefile("Walker", "Walker", "INSTALL=$(shell echo ZZ1).BIN\n");
  folder.AddObject("Talker", "Talker", "", KitFolder::Printing("talking"));
  folder.AddMakefile("Talker", "Talker", "INSTALL=$(shell echo ZZ2).BIN\n");
  folder.Write("Makefile", "all install:\n\tcd Walker; $(MAKE) $@\n\tcd Talker; $(MAKE) $@\n");
  folder.AddStick("MS", {"ZZ1.BIN", "ZZ2.BIN"});
  folder.AddStick("MS2", {"ZZ1.BIN", "ZZ2.BIN"});
  const ProgramResult result = folder.Build();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(folder.Say("MS"), "walking\ntalking\n");
  EXPECT_EQ(folder.Say("MS2"), "walking\ntalking\n");
}

// Samples side by side, each with a stick; the images have the same name.
TEST(BuildShapesTest, EachStickGetsTheImagesOfTheFoldersAroundIt) {
  for (const bool has_makefiles : {false, true}) {
    const KitFolder folder("");
    for (const char* sample : {"one", "two"}) {
      const std::string object = std::string(sample) + "/Walker";
      folder.AddObject(object, "Walker", "", KitFolder::Printing(sample));
      folder.AddStick(std::string(sample) + "/MS", {"WALKER.BIN"});
      if (!has_makefiles) continue;
      folder.AddMakefile(object, "Walker", "INSTALLDIR=/mnt/memstick\n");
      folder.Write(std::string(sample) + "/Makefile", "all install:\n\t$(MAKE) -C Walker $@\n");
    }
    if (has_makefiles)
      folder.Write("Makefile", "all install:\n\tfor d in one two; do $(MAKE) -C $$d $@; done\n");
    const ProgramResult result = folder.Build();
    EXPECT_EQ(result.status, 0) << result.err;
    EXPECT_EQ(folder.Say("one/MS"), "one\n");
    EXPECT_EQ(folder.Say("two/MS"), "two\n");
  }
}

TEST(BuildShapesTest, NamesOfImagesNeedNotBeginAsTheirObjects) {
  const std::vector<ImageCandidate> candidates = {
      {{"ballTracker.", "BallTracker"}}, {{"motionPlayer.", "MotionPlayer"}}, {{"ears.", "Ears"}}};
  EXPECT_THAT(MatchImages({"MYEARS.BIN", "TRACKER.BIN", "PLAYMTN.BIN"}, candidates),
              ElementsAre(2, 0, 1));
}

TEST(BuildShapesTest, AFolderReachedFromFarMayTakeItsSourcesFromTheOneAroundIt) {
  const KitFolder folder("");
  // The program is program/robot/Walker; its library lies in program/tools/math/robot.
  folder.AddObject("robot/Walker", "Walker", "#include \"Angle.h\"\n",
                   "    OSYSPRINT((\"%d\\n\", HalfTurn()));");
  folder.AddMakefile("robot/Walker", "Walker",
                     "DEFS=-I../../tools/math\nLIBS=../../tools/math/robot/libangle.a\n",
                     "../../tools/math/robot/libangle.a");
  folder.Write("robot/Walker/Makefile", folder.Read("robot/Walker/Makefile") +
                                            "\n../../tools/math/robot/libangle.a:\n"
                                            "\t$(MAKE) -C ../../tools/math/robot\n");
  folder.Write("tools/math/robot/Makefile",
               "VPATH=..\nCXX=/usr/local/OPEN_R_SDK/bin/mipsel-linux-g++\n"
               "libangle.a: Angle.o\n\t/usr/local/OPEN_R_SDK/bin/mipsel-linux-ar rc $@ $^\n"
               "%.o: %.cc\n\t$(CXX) -O2 -I.. -c -o $@ $<\n");
  folder.Write("tools/math/Angle.cc", "#include \"Angle.h\"\nint HalfTurn() { return 180; }\n");
  folder.Write("tools/math/Angle.h", "int HalfTurn();\n");
  folder.AddStick("robot/MS", {"WALKER.BIN"});
  const ProgramResult result = RunProgram({"build", folder.File("robot")});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(folder.Say("robot/MS"), "180\n");
}

TEST(BuildShapesTest, AStubIsFoundByTheNameOfItsFolder) {
  const KitFolder folder("");
  folder.AddObject("Walker", "Walker", "#include \"Talker/def.h\"\n#include \"../Talker/def.h\"\n",
                   KitFolder::Printing("included"));
  folder.AddObject("Talker", "Talker", "#include \"Talker/def.h\"\n",
                   KitFolder::Printing("talking"));
  std::string header = folder.Read("Talker/Talker.h");
  folder.Write("Talker/src/deep.cc", "#include \"../def.h\"\nint subjects = numOfSubject;\n");
  folder.AddStick("MS", {"WALKER.BIN", "TALKER.BIN"});
  const ProgramResult result = folder.Build();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(folder.Say(), "included\ntalking\n");
}

// The rule has no dependencies, and sources are compiled before it: old files hid both.
TEST(BuildShapesTest, AStubThatLiesAboutIsMadeAnew) {
  const KitFolder folder("");
  folder.AddObject("Walker", "Walker", "", KitFolder::Printing("walking"));
  folder.AddMakefile("Walker", "Walker");
  std::string rules = folder.Read("Walker/Makefile");
  rules.replace(rules.find("WalkerStub.cc: stub.cfg"), 23, "WalkerStub.cc:");
  folder.Write("Walker/Makefile", rules);
  const std::string old = "const int numOfSubject = 1;\n#error of another generator\n";
  for (const char* name : {"def.h", "entry.h", "WalkerStub.h", "WalkerStub.cc"})
    folder.Write(std::string("Walker/") + name, old);
  folder.AddStick("MS", {"WALKER.BIN"});
  const ProgramResult result = folder.Build();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(folder.Say(), "walking\n");
  EXPECT_EQ(folder.Read("Walker/def.h"), old);
}

// Names in lower case everywhere, CR LF at the end of every line, a variable of the environment.
TEST(BuildShapesTest, AStickInLowerCaseGetsNoSecondFolders) {
  const KitFolder folder("");
  folder.AddObject("Walker", "Walker", "", KitFolder::Printing("walking"));
  folder.AddMakefile("Walker", "Walker", "INSTALLDIR=$(MEMORY_STICK_OF_MINE)\n");
  std::string text = folder.Read("Walker/Makefile");
  text.replace(text.find("/OPEN-R/MW/OBJS"), 15, "/open-r/mw/objs");
  std::string lines;
  for (const char c : text) lines += c == '\n' ? "\r\n" : std::string(1, c);
  folder.Write("Walker/Makefile", lines);
  folder.Write("ms/open-r/mw/conf/object.cfg", "\r\n\t/MS/OPEN-R/MW/OBJS/WALKER.BIN  \r\n");
  folder.Write("ms/open-r/mw/conf/connect.cfg", "");
  folder.Write("ms/open-r/mw/objs/readme.txt", "");
  const ProgramResult result = folder.Build();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("WALKER.BIN   Walker                   Makefile"));
  EXPECT_FALSE(fs::exists(folder.File("ms/open-r/mw/OBJS")));
  EXPECT_TRUE(fs::exists(folder.File("ms/open-r/mw/objs/WALKER.BIN")));
  EXPECT_EQ(folder.Say("ms"), "walking\n");
}

// The stub's def.h is made elsewhere by this object's own build; the one here is the author's.
TEST(BuildShapesTest, ADefinitionHeaderOfTheObjectsOwnIsLeftAlone) {
  const KitFolder folder("");
  folder.AddObject("Walker", "Walker", "", "    OSYSPRINT((\"%d\\n\", LEGS));");
  std::string header = folder.Read("Walker/Walker.h");
  header.replace(header.find("#include \"def.h\""), 16,
                 "#include \"def.h\"\n#include \"gen/def.h\"");
  folder.Write("Walker/Walker.h", header);
  folder.Write("Walker/def.h", "#define LEGS 4\nenum { numbers = 1 };\n");
  folder.AddStick("MS", {"WALKER.BIN"});
  const ProgramResult result = folder.Build();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(folder.Say(), "4\n");
}

TEST(BuildShapesTest, EveryStickHasTheFolderForData) {
  const KitFolder folder("");
  folder.AddObject("Walker", "Walker", "#include <stdio.h>\n",
                   "    FILE* f = fopen(\"/MS/OPEN-R/MW/DATA/P/LOG.TXT\", \"w\");\n"
                   "    OSYSPRINT((\"%s\\n\", f ? \"open\" : \"no\"));");
  folder.AddStick("MS", {"WALKER.BIN"});
  ASSERT_EQ(folder.Build().status, 0);
  EXPECT_EQ(folder.Say(), "open\n");
  const std::string other = folder.scratch().File("out");
  ASSERT_EQ(folder.Build({"-o", other}).status, 0);
  EXPECT_TRUE(fs::is_directory(other + "/OPEN-R/MW/DATA/P"));
}

TEST(BuildShapesTest, ACommandThatIsPrintedCanBeCopiedWhateverThePath) {
  EXPECT_EQ(ShellWord("a/b-1_2.c"), "a/b-1_2.c");
  EXPECT_EQ(ShellWord("my dog's"), "'my dog'\\''s'");
  EXPECT_EQ(ShellWord(""), "''");
  const KitFolder folder("");
  folder.AddObject("my dog/Walker", "Walker", "", "");
  folder.AddStick("my dog/MS", {"WALKER.BIN"});
  const ProgramResult result = RunProgram({"build", folder.File("my dog")});
  EXPECT_THAT(result.out, HasSubstr("openr run --stick '" + folder.File("my dog/MS") + "'\n"));
}

TEST(BuildShapesTest, WordsOfACommandAreSplitAsAShellDoes) {
  EXPECT_THAT(SplitShellWords("-DA=\\\"x\\\" '-DB=\"y z\"' \"-I../a b\" ''"),
              ElementsAre("-DA=\"x\"", "-DB=\"y z\"", "-I../a b", ""));
}

}  // namespace
}  // namespace openr_host
