#include <fnmatch.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "cli/process.h"
#include "tests/kit/kit_folder.h"

namespace openr_host {
namespace {

using ::testing::HasSubstr;

TEST(NewTest, ANewObjectBuildsAndRuns) {
  const KitFolder folder("");
  const ProgramResult made = RunProgram({"new", "Wag", folder.File("")});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr("program/Wag/stub.cfg\n"));
  const ProgramResult built = folder.Build();
  ASSERT_EQ(built.status, 0) << built.err;
  EXPECT_EQ(folder.Say(), "Wag has started\nWag hears 31 sensors\n");
}

// Adds a source to the object Wag that Wag.cc calls.
void AddSecondSource(const KitFolder& folder) {
  folder.Write("Wag/Helper.h", "int Helper();\n");
  folder.Write("Wag/Helper.cc", "#include \"Helper.h\"\nint Helper() { return 42; }\n");
  std::string source = folder.Read("Wag/Wag.cc");
  const std::string line = "    OSYSPRINT((\"Wag has started\\n\"));\n";
  const size_t at = source.find(line);
  ASSERT_NE(at, std::string::npos);
  source.replace(at, line.size(), "    OSYSPRINT((\"helped by %d\\n\", Helper()));\n");
  folder.Write("Wag/Wag.cc", "#include \"Helper.h\"\n" + source);
}

TEST(NewTest, ASecondSourceOfTheFolderIsBuiltByTheMakefile) {
  const KitFolder folder("");
  ASSERT_EQ(RunProgram({"new", "Wag", folder.File("")}).status, 0);
  AddSecondSource(folder);
  const ProgramResult built = folder.Build();
  ASSERT_EQ(built.status, 0) << built.err;
  EXPECT_EQ(folder.Say(), "helped by 42\nWag hears 31 sensors\n");
}

TEST(NewTest, ASecondSourceOfTheFolderIsBuiltByCMake) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the package for CMake wants a program with sanitizers";
#endif
  const KitFolder folder("");
  ASSERT_EQ(RunProgram({"new", "Wag", folder.File("")}).status, 0);
  AddSecondSource(folder);
  // The robot's make leaves its stub in the folder.
  folder.Write("Wag/WagStub.cc", "#error made for the robot\n");
  const std::string prefix = std::filesystem::path(OPENR_PROGRAM).parent_path().parent_path();
  for (const std::vector<std::string>& command : std::vector<std::vector<std::string>>{
           {"cmake", "-S", folder.File(""), "-B", folder.File("build"),
            "-DCMAKE_PREFIX_PATH=" + prefix},
           {"cmake", "--build", folder.File("build"), "--target", "stick"}}) {
    const ProcessResult result =
        RunProcess(command, {.captures_error = true, .captures_out = true});
    ASSERT_TRUE(result.good()) << result.output;
  }
  EXPECT_EQ(KitFolder::SayOf(folder.File("build/stick")), "helped by 42\nWag hears 31 sensors\n");
}

TEST(NewTest, ANameOfAnObjectOfTheRobotIsRefused) {
  const KitFolder folder("");
  for (const char* name : {"OVirtualRobotComm", "OVirtualRobotAudioComm", "IPStack", "ipstack",
                           "TCPGateway", "OobjectManager"}) {
    const ProgramResult result = RunProgram({"new", name, folder.File("")});
    EXPECT_EQ(result.status, 2) << name;
    EXPECT_THAT(result.err, HasSubstr(" is an object of the robot itself, and two objects of one "
                                      "name cannot run; choose another name"));
  }
}

TEST(NewTest, ANameThatNoClassCanHaveIsRefused) {
  const KitFolder folder("");
  for (const char* name : {"WhoAmI", "OSubject", "destroy", "EOF"}) {
    const ProgramResult result = RunProgram({"new", name, folder.File("")});
    EXPECT_EQ(result.status, 2) << name;
    EXPECT_THAT(result.err, HasSubstr("no class can be called "));
    EXPECT_THAT(result.err, HasSubstr("use this name; choose another name"));
    EXPECT_FALSE(std::filesystem::exists(folder.File("stub.cfg")));
  }
}

// "Clock" is a member of a class of the headers, "Called" a word of a comment: neither is in the
// way.
TEST(NewTest, WordsOfTheHeadersThatAreNotInTheWayCanNameAnObject) {
  for (const char* name : {"Clock", "Called"}) {
    const KitFolder folder("");
    const ProgramResult made = RunProgram({"new", name, folder.File("")});
    EXPECT_EQ(made.status, 0) << made.err;
    EXPECT_EQ(folder.Build().status, 0) << name;
  }
}

TEST(NewTest, WithoutACompilerANameIsNotRefused) {
  const KitFolder folder("");
  const NamedCompiler compiler("/bin/false");
  const ProgramResult made = RunProgram({"new", "Wag", folder.File("")});
  EXPECT_EQ(made.status, 0) << made.err;
}

TEST(NewTest, AStickWithOnlyConnectionsGetsTheListOfItsObjects) {
  const KitFolder folder("");
  ASSERT_EQ(RunProgram({"new", "Wag", folder.File("")}).status, 0);
  const std::string config = "MS/OPEN-R/MW/CONF/";
  const std::string connections = folder.Read(config + "CONNECT.CFG");
  std::filesystem::remove(folder.File(config + "OBJECT.CFG"));
  const ProgramResult built = folder.Build();
  ASSERT_EQ(built.status, 0) << built.err;
  EXPECT_THAT(built.err, HasSubstr("there is no OBJECT.CFG; one that lists every object was "
                                   "written\n"));
  EXPECT_EQ(folder.Read(config + "CONNECT.CFG"), connections);
  EXPECT_EQ(folder.Say(), "Wag has started\nWag hears 31 sensors\n");
}

TEST(NewTest, MessagesAboutAnOcfFileNameTheFileOfTheUser) {
  const KitFolder folder("");
  ASSERT_EQ(RunProgram({"new", "Wag", folder.File("")}).status, 0);
  folder.Write("Wag/wag.ocf", "object wag 3072 16384 128 cashe tlb user\n");
  const ProgramResult built = folder.Build();
  EXPECT_EQ(built.status, 0) << built.err;
  EXPECT_THAT(built.err, HasSubstr("\n" + folder.File("Wag/wag.ocf") +
                                   ":1: warning: 'cashe' counts as 'nocache'"));
}

// Runs what `openr new` of `program` prints, line by line, where a person stands.
void RunPrintedCommands(const std::string& program, const std::string& path) {
  const ScratchFolder scratch;
  scratch.Write("with blanks/here.txt", "");
  const std::string here = scratch.File("with blanks");
  const auto shell = [&](const std::string& line) {
    return RunProcess(
        {"sh", "-c", line},
        {{{"XDG_CACHE_HOME", scratch.File("cache")}, {"PATH", path}, {"MAKEFLAGS", ""}},
         here,
         true,
         true});
  };
  const ProcessResult made = shell("'" + program + "' new Wag 'my dog'");
  ASSERT_TRUE(made.good()) << made.output;
  std::istringstream lines(made.output);
  int commands = 0, runs = 0;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("my dog/") || line.empty() || line.ends_with(":")) continue;
    ++commands;
    const ProcessResult result = shell(line);
    EXPECT_TRUE(result.good()) << line << "\n" << result.output;
    if (line.find(" run ") == std::string::npos) continue;
    ++runs;
    EXPECT_THAT(result.output, HasSubstr("Wag hears 31 sensors\n"));
    EXPECT_THAT(result.output, ::testing::Not(HasSubstr("warning: ")));
  }
  EXPECT_EQ(commands, 6) << made.output;
  EXPECT_EQ(runs, 2);
  // The rules for the robot, with the host's SDK.
  std::filesystem::remove_all(here + "/my dog/MS/OPEN-R/MW/OBJS");
  const std::string sdk =
      std::filesystem::path(program).parent_path().parent_path() / "share/openr-host/sdk";
  const ProcessResult installed = shell("make -C 'my dog' install OPENRSDK_ROOT='" + sdk + "'");
  ASSERT_TRUE(installed.good()) << installed.output;
  EXPECT_EQ(KitFolder::SayOf(here + "/my dog/MS"), "Wag has started\nWag hears 31 sensors\n");
}

TEST(NewTest, TheCommandsThatItPrintsWorkWithABuildFolder) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the library for tests wants a program with sanitizers";
#endif
  RunPrintedCommands(OPENR_PROGRAM, getenv("PATH"));
}

TEST(NewTest, TheCommandsThatItPrintsWorkWithAnInstallation) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the installed library wants a program with sanitizers";
#endif
  const ScratchFolder prefix;
  const ProcessResult installed = RunProcess(
      {"cmake", "--install", OPENR_BUILD, "--prefix", prefix.File("opt")}, {{}, "", true, true});
  ASSERT_TRUE(installed.good()) << installed.output;
  // Found by its name, as after an installation into /usr/local.
  const std::string path = prefix.File("opt/bin") + ":" + getenv("PATH");
  RunPrintedCommands(prefix.File("opt/bin/openr"), path);
}

TEST(NewTest, NothingIsOverwritten) {
  const KitFolder folder("");
  folder.Write("Makefile", "mine\n");
  const ProgramResult result = RunProgram({"new", "Wag", folder.File("")});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("Makefile is there already; nothing was written"));
  EXPECT_EQ(folder.Files(), std::vector<std::string>{"Makefile"});
}

// Whether a line of .gitignore names `file`.  The lines that `openr new` writes begin with "/"; one
// that ends in "/" names a folder with all that is in it.
bool IsIgnored(const std::string& file, const std::string& lines) {
  std::istringstream text(lines);
  for (std::string line; std::getline(text, line);) {
    if (!line.starts_with("/")) continue;
    if (line.ends_with("/")) line += "*";
    if (fnmatch(line.c_str(), ("/" + file).c_str(), 0) == 0) return true;
  }
  return false;
}

TEST(NewTest, GitIgnoresWhatBuildsAndRunsLeaveBehind) {
  const KitFolder folder("");
  ASSERT_EQ(RunProgram({"new", "Wag", folder.File("")}).status, 0);
  const std::vector<std::string> sources = folder.Files();
  ASSERT_EQ(folder.Build().status, 0);
  const std::string sdk = std::string("OPENRSDK_ROOT=") + OPENR_BUILD + "/share/openr-host/sdk";
  const ProcessResult made =
      RunProcess({"make", "-C", folder.File(""), "install", sdk}, {{}, "", true, true});
  ASSERT_TRUE(made.good()) << made.output;
  folder.Say();
  const std::string lines = folder.Read(".gitignore");
  EXPECT_GT(folder.Files().size(), sources.size());
  for (const std::string& file : folder.Files()) {
    const bool is_source = std::ranges::find(sources, file) != sources.end();
    EXPECT_EQ(IsIgnored(file, lines), !is_source) << file;
  }
}

TEST(NewTest, AGitignoreThatIsThereStays) {
  const KitFolder folder("");
  folder.Write(".gitignore", "mine\n");
  const ProgramResult made = RunProgram({"new", "Wag", folder.File("")});
  EXPECT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr("\n\n" + folder.File("") +
                                  "/.gitignore was there already and stays as it is; add these "
                                  "lines, so that git ignores what builds and runs leave behind:\n"
                                  "/build/\n/compile_commands.json\n/MS/OPEN-R/MW/OBJS/\n"));
  EXPECT_EQ(folder.Read(".gitignore"), "mine\n");
}

TEST(NewTest, OnlyLinesThatAGitignoreLacksAreToBeAdded) {
  const KitFolder first(""), some("");
  ASSERT_EQ(RunProgram({"new", "Wag", first.File("")}).status, 0);
  some.Write(".gitignore", "/MS/OPEN-R/MW/OBJS/ \r\n/build/\n");
  EXPECT_THAT(RunProgram({"new", "Wag", some.File("")}).out,
              HasSubstr("leave behind:\n/compile_commands.json\n/MS/OPEN-R/EMON.LOG\n"));
  const KitFolder all("");
  all.Write(".gitignore", first.Read(".gitignore"));
  EXPECT_THAT(RunProgram({"new", "Wag", all.File("")}).out,
              ::testing::Not(HasSubstr(".gitignore")));
}

TEST(NewTest, ANameThatIsNoClassIsRefused) {
  const ProgramResult result = RunProgram({"new", "9lives"});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.err, HasSubstr("'9lives' cannot be the name of an object"));
}

}  // namespace
}  // namespace openr_host
