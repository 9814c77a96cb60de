// openr build: programs as they were written for the robot, with nothing added and nothing changed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>

#include "cli/process.h"
#include "tests/kit/kit_folder.h"
#include "tests/kit/robot_binary.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// A build that several tests look at.
class BuiltProgram : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new KitFolder("makefile");
    files_before_ = folder_->Files();
    result_ = folder_->Build();
  }
  static void TearDownTestSuite() { delete folder_; }

  static inline const KitFolder* folder_ = nullptr;
  static inline std::vector<std::string> files_before_;
  static inline ProgramResult result_;
};

TEST_F(BuiltProgram, IsBuiltThroughItsMakefiles) {
  ASSERT_EQ(result_.status, 0) << result_.err;
  EXPECT_THAT(result_.out, HasSubstr("SENDER.BIN   sender                   Makefile\n"));
  EXPECT_THAT(result_.out, HasSubstr("openr run --stick " + folder_->File("MS")));
  EXPECT_EQ(folder_->Say(), "heard: greeting 1\nheard: greeting 2\nheard: greeting 3\n");
}

TEST_F(BuiltProgram, HasNothingNewButImages) {
  std::vector<std::string> wanted = files_before_;
  for (const char* name : {"POWERMON", "RECEIVER", "SENDER"})
    wanted.push_back(std::string("MS/OPEN-R/MW/OBJS/") + name + ".BIN");
  std::sort(wanted.begin(), wanted.end());
  EXPECT_EQ(folder_->Files(), wanted);
}

TEST_F(BuiltProgram, HasAnImageOfTheKitWhereItBringsNone) {
  EXPECT_THAT(result_.out, HasSubstr("POWERMON.BIN                          the kit's own\n"));
}

TEST(BuildTest, AnOutputFolderLeavesTheProgramAsItIs) {
  const KitFolder folder("makefile");
  const std::vector<std::string> before = folder.Files();
  const std::string stick = folder.scratch().File("stick");
  ASSERT_EQ(folder.Build({"-o", stick}).status, 0);
  EXPECT_EQ(folder.Files(), before);
  EXPECT_THAT(KitFolder::SayOf(stick), HasSubstr("heard: greeting 3\n"));
}

TEST(BuildTest, TheCurrentFolderIsBuiltAndCheckedIfNoneIsNamed) {
  const KitFolder folder("makefile");
  const auto run_there = [&folder](const std::vector<std::string>& words) {
    return RunProcess(words,
                      {.folder = folder.File(""), .captures_error = true, .captures_out = true});
  };
  const ProcessResult built = run_there({OPENR_PROGRAM, "build", "--coverage"});
  ASSERT_EQ(built.status, 0) << built.output;
  EXPECT_THAT(folder.Say(), HasSubstr("heard: greeting 3\n"));
  const ProcessResult checked = run_there({OPENR_PROGRAM, "check"});
  EXPECT_EQ(checked.status, 0);
  EXPECT_THAT(checked.output, HasSubstr("notes\n"));
  EXPECT_EQ(checked.output, run_there({OPENR_PROGRAM, "check", "."}).output);
  EXPECT_EQ(run_there({OPENR_PROGRAM, "coverage"}).status, 0);
  EXPECT_EQ(run_there({OPENR_PROGRAM, "editor"}).status, 0);
  EXPECT_TRUE(std::filesystem::exists(folder.File(".vscode")));
}

TEST(BuildTest, TwoFoldersDoNotShareAWorkFolder) {
  const KitFolder one("convention"), other("convention");
  const std::string work = one.scratch().File("work");
  ASSERT_EQ(one.Build({"--work", work}).status, 0);
  const ProgramResult refused = other.Build({"--work", work});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("holds what was built of " + one.File("")));
  EXPECT_EQ(one.Build({"--work", work}).status, 0);
  EXPECT_EQ(other.Build({"--work", work, "--fresh"}).status, 0);
}

TEST(BuildTest, AWorkFolderWithSomebodysFilesIsLeftAlone) {
  const KitFolder folder("convention");
  folder.scratch().Write("mine/letter.txt", "dear");
  const ProgramResult refused = folder.Build({"--work", folder.scratch().File("mine")});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("holds files that are not of a build"));
  EXPECT_EQ(folder.scratch().Read("mine/letter.txt"), "dear");
}

TEST(BuildTest, ASecondBuildOnlyBuildsWhatChanged) {
  const KitFolder folder("makefile");
  ASSERT_EQ(folder.Build({"--verbose"}).status, 0);
  EXPECT_THAT(folder.Build({"--verbose"}).err, Not(HasSubstr("mipsel-linux-g++")));
  folder.Write("common/Greeting.cc",
               "#include \"Greeting.h\"\n#include <stdio.h>\n"
               "void Greet(char* line, int number) { sprintf(line, \"again %d\", number); }\n");
  const ProgramResult result = folder.Build({"--verbose"});
  EXPECT_THAT(result.err, HasSubstr("../common/Greeting.cc"));
  EXPECT_THAT(result.err, Not(HasSubstr("-c Sender.cc")));
  EXPECT_EQ(folder.Say(), "heard: again 1\nheard: again 2\nheard: again 3\n");
}

// field-notes.md, 1.7: the new service comes first, so that sources compiled with the old generated
// headers would use it in place of the old one.
TEST(BuildTest, AServiceThatIsNewInStubCfgIsCompiledIntoAllSources) {
  const KitFolder folder("convention");
  ASSERT_EQ(folder.Build().status, 0);
  folder.Write("Counter/stub.cfg",
               "ObjectName : Counter\nNumOfOSubject : 2\nNumOfOObserver : 1\n"
               "Service : \"Counter.More.char.S\", null, null\n"
               "Service : \"Counter.Number.char.S\", null, Ready()\n"
               "Service : \"Counter.DummyObserver.DoNotConnect.O\", null, null\n");
  folder.Write("MS/OPEN-R/MW/CONF/CONNECT.CFG",
               "Counter.Number.char.S Printer.Number.char.O\n"
               "Counter.More.char.S Printer.Number.char.O\n");
  ASSERT_EQ(folder.Build().status, 0);
  const std::string said = folder.Say();
  EXPECT_THAT(said, HasSubstr("connected to Counter.More.char.S\n"));
  EXPECT_THAT(said, HasSubstr("number: [one]\nnumber: [two]\nnumber: [three]\n"));
}

// The Makefile does not say that the sources depend on headers.
TEST(BuildTest, AServiceThatIsNewInStubCfgIsCompiledIntoSourcesOfAMakefile) {
  const KitFolder folder("makefile");
  ASSERT_EQ(folder.Build().status, 0);
  const std::string stub = folder.Read("Sender/stub.cfg");
  folder.Write("Sender/stub.cfg", stub + "\n");
  EXPECT_THAT(folder.Build({"--verbose"}).err, HasSubstr("-c Sender.cc"));
  const std::string header = folder.Read("common/Greeting.h");
  folder.Write("common/Greeting.h", header + "\n");
  EXPECT_THAT(folder.Build({"--verbose"}).err, HasSubstr("-c Sender.cc"));
  EXPECT_THAT(folder.Build({"--verbose"}).err, Not(HasSubstr("-c Sender.cc")));
  EXPECT_EQ(folder.Say(), "heard: greeting 1\nheard: greeting 2\nheard: greeting 3\n");
}

TEST(BuildTest, AChangedHeaderIsNoticedWithACompilerCacheThatWritesRelativePaths) {
  if (!std::filesystem::exists("/usr/bin/ccache")) GTEST_SKIP() << "ccache is not installed";
  const KitFolder folder("convention");
  const NamedCompiler cached("ccache g++");
  const NamedVariable base("CCACHE_BASEDIR", std::filesystem::path(folder.File("")).parent_path());
  ASSERT_EQ(folder.Build().status, 0);
  folder.Write("Printer/text/Frame.h",
               "#include <string>\n#define Framed Unframed\n"
               "std::string Framed(const char* text);\n");
  EXPECT_THAT(folder.Build({"--verbose"}).err, HasSubstr("Frame.cpp"));
}

TEST(BuildTest, ANewHeaderLeavesLibrariesOfTheUserAlone) {
  const KitFolder folder("makefile");
  const std::string precious = folder.scratch().File("precious");
  std::filesystem::create_directory(precious);
  folder.scratch().Write("precious/libmine.a", "mine");
  folder.Write("Sender/libmine.a", "!<arch>\n");
  std::string makefile = folder.Read("Sender/Makefile");
  makefile += "\n$(shell test -e lib || ln -s " + precious + " lib)\n$(shell echo >>libmine.a)\n";
  folder.Write("Sender/Makefile", makefile);
  ASSERT_EQ(folder.Build({"--work", folder.scratch().File("work")}).status, 0);
  folder.Write("common/Greeting.h", folder.Read("common/Greeting.h") + "\n");
  ASSERT_EQ(folder.Build({"--work", folder.scratch().File("work")}).status, 0);
  EXPECT_EQ(folder.scratch().Read("precious/libmine.a"), "mine");
  const std::string copy = "work/src" + folder.File("Sender/libmine.a");
  EXPECT_TRUE(std::filesystem::exists(folder.scratch().File(copy)));
}

TEST(BuildTest, WhatABuildForTheRobotLeftIsNotUsed) {
  const KitFolder folder("makefile");
  folder.Write("Sender/Sender.o", RobotBinary());
  folder.Write("Sender/SenderStub.cc", "#error of another generator\n");
  folder.Write("Sender/def.h", "#error of another generator\n");
  folder.Write("MS/OPEN-R/MW/OBJS/SENDER.BIN", RobotBinary());
  ASSERT_EQ(folder.Build().status, 0);
  EXPECT_THAT(folder.Say(), HasSubstr("heard: greeting 3\n"));
}

// A user builds for the robot and for the host in turn.
TEST(BuildTest, EachBinaryForTheRobotThatWasInTheWayIsKept) {
  const KitFolder folder("makefile");
  const std::string robot_image = RobotBinary();
  const auto kept = [&] {
    std::map<std::string, std::string> files;
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(folder.scratch().File("cache"))) {
      const std::string name = entry.path().filename();
      if (!name.starts_with("SENDER.BIN") && !name.starts_with("RECEIVER.BIN")) continue;
      if (entry.path().string().find("/robot/") == std::string::npos) continue;
      std::ifstream file(entry.path(), std::ios::binary);
      files[name] =
          std::string(std::istreambuf_iterator<char>(file), {}).substr(robot_image.size());
    }
    return files;
  };
  for (const auto& [sender, receiver] :
       {std::pair("1", "one"), {"2", "one"}, {"3", "two"}, {"2", "two"}}) {
    folder.Write("MS/OPEN-R/MW/OBJS/SENDER.BIN", robot_image + sender);
    folder.Write("MS/OPEN-R/MW/OBJS/RECEIVER.BIN", robot_image + receiver);
    ASSERT_EQ(folder.Build().status, 0);
  }
  const std::map<std::string, std::string> all = {{"SENDER.BIN", "1"},
                                                  {"SENDER.BIN.2", "2"},
                                                  {"SENDER.BIN.3", "3"},
                                                  {"RECEIVER.BIN", "one"},
                                                  {"RECEIVER.BIN.2", "two"}};
  EXPECT_EQ(kept(), all);
}

TEST(BuildTest, WithoutMakefilesFoldersWithAStubAreObjects) {
  const KitFolder folder("convention");
  const ProgramResult result = folder.Build();
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("CNTR.BIN     counter                  by its name\n"));
  EXPECT_EQ(result.err, "");  // sources that do not compile were not needed
  EXPECT_EQ(folder.Say(),
            "connected to Counter.Number.char.S\nnumber: [one]\nnumber: [two]\nnumber: [three]\n");
}

TEST(BuildTest, AStubWrittenByHandIsEnough) {
  const KitFolder folder("handmade");
  const ProgramResult result = folder.Build();
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(folder.Say(), "handmade: init\nhandmade: start\n");
}

// CR LF, headers of C++ before the standard, names without std::, a missing return, pointers cast
// to int, K&R C, flags for the robot's processor and -Werror.
TEST(BuildTest, OldCodeCompilesAndDoesWhatItDid) {
  const KitFolder folder("oldstyle");
  const ProgramResult result = folder.Build();
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("no return statement"));  // warnings stay
  folder.Write("typed.txt", "hello there\n");
  EXPECT_EQ(
      folder.Say("MS", {"--stdin", folder.File("typed.txt")}),
      "sum 10   42\nold 1 7 5\ncast\nsame\nkr 23 pi 3.142\nff\nhello there\nanswer hello there\n");
}

// The folder gcc3 has code that g++ 3.3 accepted and that today's compiler refuses.
TEST(BuildTest, WhatTodaysCompilerRefusesIsRepairedInTheCopy) {
  const KitFolder folder("gcc3");
  const std::string source = folder.Read("Obj/Odd.cc");
  const ProgramResult result = folder.Build();
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err,
              HasSubstr("note: " + folder.File("Obj/Odd.cc") +
                        ":21: the second parameter called 'angle' left without a name"));
  EXPECT_EQ(folder.Say(), "5 21 313 2 30 21 2.5 0 3 4 helped\nturn 1 2\n");
  EXPECT_EQ(folder.Read("Obj/Odd.cc"), source);
}

// Folders in folders, a library, a compiler in a variable of a variable, a stick elsewhere.
TEST(BuildTest, AProjectFindsCompilerAndStickWhereverItsVariablesLead) {
  const KitFolder folder("nested");
  const ProgramResult result = folder.Build();
  ASSERT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(folder.Say("stick"),
            "Walker: stride 40 of platform 210\nWalker: stride 55 of platform 210\n"
            "Viewer: stride 40 of platform 210\nViewer: stride 55 of platform 210\n");
  EXPECT_EQ(folder.Read("stick/OPEN-R/MW/DATA/P/WALKER.TXT"), "made for walker\n");
}

// field-notes.md 15.4: a variable CXX for the cross compiler broke Sony's build for the PC.
TEST(BuildTest, ACrossCompilerInTheEnvironmentIsNotTaken) {
  const KitFolder folder("makefile");
  for (const std::string name : {"Sender/Makefile", "Receiver/Makefile"}) {
    std::string makefile = folder.Read(name);
    const size_t at = makefile.find("CXX=");
    ASSERT_NE(at, std::string::npos) << name;
    folder.Write(name, makefile.replace(at, 4, "CXX?="));
  }
  setenv("CXX", "/usr/local/OPEN_R_SDK/bin/mipsel-linux-g++", 1);
  const ProgramResult built = folder.Build();
  unsetenv("CXX");
  ASSERT_EQ(built.status, 0) << built.err;
  EXPECT_EQ(folder.Say(), "heard: greeting 1\nheard: greeting 2\nheard: greeting 3\n");
}

TEST(BuildTest, RulesNeverReachFoldersOutsideOfTheCopy) {
  const KitFolder folder("handmade");
  const std::string outside = folder.scratch().File("elsewhere");
  std::filesystem::create_directories(outside + "/OPEN-R/MW/OBJS");
  folder.Write("Greeter/Makefile",
               "DEST = " + outside +
                   "/OPEN-R/MW/OBJS\n"
                   "CXX = mipsel-linux-g++\n"
                   "greeter.bin: Greeter.o GreeterEntries.o greeter.ocf\n\tmkbin -o $@ $^\n"
                   "install: greeter.bin\n\tgzip -c greeter.bin > $(DEST)/HANDMADE.BIN\n");
  const ProgramResult result = folder.Build();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("HANDMADE.BIN greeter                  Makefile\n"));
  EXPECT_FALSE(std::filesystem::exists(outside + "/OPEN-R/MW/OBJS/HANDMADE.BIN"));
}

TEST(BuildTest, RulesFindThemselvesWhereTheirMakefileIs) {
  const KitFolder folder("handmade");
  folder.Write("Makefile",
               "INSTALLDIR = $(PWD)/MS\nexport INSTALLDIR\n"
               "install:\n\tcd Greeter; make $@\n");
  folder.Write("Greeter/Makefile",
               "greeter.bin: Greeter.o GreeterEntries.o greeter.ocf\n\tmkbin -o $@ $^\n"
               "install: greeter.bin\n"
               "\tcp greeter.bin $(INSTALLDIR)/OPEN-R/MW/OBJS/HANDMADE.BIN\n");
  const ProgramResult result = folder.Build();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("HANDMADE.BIN greeter                  Makefile\n"));
}

TEST(BuildTest, ACompilersComplaintPassesThroughAndIsSummedUp) {
  const KitFolder folder("makefile");
  folder.Write("Sender/Sender.cc", "int broken(\n");
  const ProgramResult result = folder.Build();
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("Sender.cc:1:12: error: expected"));
  EXPECT_THAT(result.err,
              HasSubstr("openr build: Sender: " + folder.File("Sender/Sender.cc") +
                        " does not compile; the compiler says above what to correct\n"));
  EXPECT_THAT(result.out, Not(HasSubstr("SENDER.BIN")));
  EXPECT_THAT(result.out, Not(HasSubstr("openr run")));
}

TEST(BuildTest, WhatIsUndefinedIsNamed) {
  const KitFolder folder("handmade");
  folder.Write("Greeter/More.cc", "void Missing(int);\nvoid Use() { Missing(1); }\n");
  const ProgramResult result = folder.Build();
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err,
              HasSubstr("is undefined: Missing(int); is a source or a library missing?"));
}

TEST(BuildTest, ABadStubIsSaidWithItsLine) {
  const KitFolder folder("convention");
  folder.Write("Counter/stub.cfg",
               "ObjectName : Counter\nNumOfOSubject : 2\nNumOfOObserver : 1\n"
               "Service : \"Counter.Number.char.S\", null, Ready()\n"
               "Service : \"Counter.D.DoNotConnect.O\", null, null\n");
  const ProgramResult result = folder.Build();
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("stub.cfg:2: NumOfOSubject is 2, but the file has 1 subject"));
  EXPECT_THAT(result.err, HasSubstr("OBJECT.CFG:2: /MS/OPEN-R/MW/OBJS/CNTR.BIN was not built"));
}

TEST(BuildTest, AnImageNobodyMakesIsAnErrorWithItsLine) {
  const KitFolder folder("handmade");
  folder.Write("MS/OPEN-R/MW/CONF/OBJECT.CFG",
               "/MS/OPEN-R/MW/OBJS/GREETER.BIN\n/MS/OPEN-R/MW/OBJS/OTHER.BIN\n");
  const ProgramResult result = folder.Build();
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("openr build: OBJECT.CFG:2: /MS/OPEN-R/MW/OBJS/OTHER.BIN was "
                                    "not built: no object here has such a name\n"));
}

TEST(BuildTest, AMakefileThatFailsIsDoneWithout) {
  const KitFolder folder("handmade");
  folder.Write("Makefile", "all:\n\tno_such_tool --version\n");
  const ProgramResult result = folder.Build();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("note: the Makefiles made no image of Greeter; built without"));
  EXPECT_EQ(folder.Say(), "handmade: init\nhandmade: start\n");
}

TEST(BuildTest, AnImageOfAnEarlierBuildIsNotTakenForANewOne) {
  const KitFolder folder("handmade");
  folder.Write("Greeter/Makefile",
               "greeter.bin: Greeter.o GreeterEntries.o greeter.ocf\n\tmkbin -o $@ $^\n");
  ASSERT_EQ(folder.Build().status, 0);
  folder.Write("Greeter/Makefile", "all:\n\tno_such_tool\n");
  std::string source = folder.Read("Greeter/Greeter.cc");
  source.replace(source.find("handmade: start"), 15, "made anew");
  folder.Write("Greeter/Greeter.cc", source);
  const ProgramResult result = folder.Build();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("note: the Makefiles made no image of Greeter; built without"));
  EXPECT_EQ(folder.Say(), "handmade: init\nmade anew\n");
}

TEST(BuildTest, ObjectsWithoutAStickGetOne) {
  const KitFolder folder("handmade");
  std::filesystem::remove_all(folder.File("MS"));
  const ProgramResult result = folder.Build();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(folder.Read("MS/OPEN-R/MW/CONF/OBJECT.CFG"), "/MS/OPEN-R/MW/OBJS/GREETER.BIN\n");
  EXPECT_EQ(folder.Say(), "handmade: init\nhandmade: start\n");
}

// As trees look that were copied from a stick on some systems.
TEST(BuildTest, BlanksInThePathDoNoHarm) {
  const KitFolder folder("");
  const std::string odd = folder.File("my $program");
  std::filesystem::copy(std::string(OPENR_KIT_FIXTURES) + "/handmade", odd,
                        std::filesystem::copy_options::recursive);
  const ProgramResult result = RunProgram({"build", odd});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(folder.Say("my $program/MS"), "handmade: init\nhandmade: start\n");
}

TEST(BuildTest, AStickInLowerCaseIsAStick) {
  const KitFolder folder("handmade");
  std::filesystem::remove_all(folder.File("MS"));
  folder.Write("ms/open-r/mw/conf/object.cfg", "/ms/open-r/mw/objs/greeter.bin\n");
  folder.Write("ms/open-r/mw/conf/connect.cfg", "");
  const ProgramResult result = folder.Build();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(folder.Say("ms"), "handmade: init\nhandmade: start\n");
}

TEST(BuildTest, OneObjectFindsWhatItsMakefileNamesOutside) {
  const KitFolder folder("makefile");
  const ProgramResult result = RunProgram({"build", folder.File("Sender")});
  EXPECT_THAT(result.out, HasSubstr("SENDER.BIN   sender                   Makefile\n"));
  EXPECT_THAT(result.err, HasSubstr("OBJECT.CFG:3: /MS/OPEN-R/MW/OBJS/RECEIVER.BIN was not built"));
}

// ".." in a common Makefile is the folder of the object whose Makefile includes it: here it seemed
// to be the one around everything, and neighbours were built and their sticks written.
TEST(BuildTest, NeighboursOfTheFolderAreLeftAlone) {
  const KitFolder folder("handmade");
  folder.scratch().Write("neighbour/stub.cfg", "not a stub\n");
  folder.scratch().Write("neighbour/MS/OPEN-R/MW/CONF/OBJECT.CFG",
                         "/MS/OPEN-R/MW/OBJS/GREETER.BIN\n");
  folder.Write("Makefile.common", "ROOT = ..\ninclude $(ROOT)/rules.mk\n");
  folder.Write("Greeter.h", "#include \"../neighbour/nothing.h\"\n");
  folder.scratch().Write("neighbour/nothing.h", "");
  const ProgramResult result = folder.Build();
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_THAT(result.err, Not(HasSubstr("neighbour")));
  EXPECT_THAT(result.out, Not(HasSubstr("neighbour")));
  EXPECT_FALSE(
      std::filesystem::exists(folder.scratch().File("neighbour/MS/OPEN-R/MW/OBJS/GREETER.BIN")));
}

// The sources name a header in the folder above them, and only this folder shows that they are a
// program.
TEST(BuildTest, SourcesMayBeInAFolderBelowTheirEntryTable) {
  const KitFolder folder("handmade");
  const std::string header = "#include \"Greeter.h\"";
  std::string source = folder.Read("Greeter/Greeter.cc");
  ASSERT_EQ(source.find(header), 0u);
  source.replace(0, header.size(), "#include \"../Greeter.h\"");
  std::filesystem::remove(folder.File("Greeter/Greeter.cc"));
  folder.Write("Greeter/src/Greeter.cc", source);
  const ProgramResult result = RunProgram({"build", folder.File("Greeter/src")});
  EXPECT_EQ(result.status, 0) << result.err;
  EXPECT_EQ(folder.Say("Greeter/src/MS"), "handmade: init\nhandmade: start\n");
}

// A work folder within DIR, the folder to build, holds copies of sources that were built before.
// These copies are not built again.
TEST(BuildTest, AnOldWorkFolderIsNothingToBuild) {
  const KitFolder folder("handmade");
  const std::string work = folder.File("work");
  ASSERT_EQ(folder.Build({"--work", work}).status, 0);
  std::filesystem::remove_all(folder.File("Greeter"));
  std::filesystem::remove_all(folder.File("MS"));
  const ProgramResult result = folder.Build({"--work", work});
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.out, "");
  EXPECT_THAT(result.err, HasSubstr("no stub.cfg, no entry table and no Makefile"));
}

TEST(BuildTest, AFolderWithNothingToBuildIsSaidSo) {
  const KitFolder folder("");
  const ProgramResult result = folder.Build();
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("no stub.cfg, no entry table and no Makefile"));
  EXPECT_FALSE(std::filesystem::exists(folder.scratch().File("cache"))) << "the folder was copied";
}

}  // namespace
}  // namespace openr_host
