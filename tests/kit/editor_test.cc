// The files for Visual Studio Code that `openr new` and `openr editor` write, and
// compile_commands.json.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "cli/process.h"
#include "tests/kit/kit_folder.h"

namespace openr_host {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using Json = nlohmann::json;

// Returns `json` as an editor reads it that has `folder` open.
Json InFolder(const Json& json, const std::string& folder) {
  const std::string variable = "${workspaceFolder}";
  std::string text = json.dump();
  for (size_t at = text.find(variable); at != std::string::npos; at = text.find(variable, at))
    text.replace(at, variable.size(), folder);
  return Json::parse(text);
}

Json EditorFile(const KitFolder& folder, const std::string& name) {
  return InFolder(Json::parse(folder.Read(".vscode/" + name)), folder.File(""));
}

// Runs a program as an editor does: without a shell, in the folder that is open.
ProcessResult RunInEditor(const KitFolder& folder, const std::string& program,
                          const Json& arguments) {
  std::vector<std::string> words{program};
  for (const Json& argument : arguments) words.push_back(argument);
  return RunProcess(words,
                    {.folder = folder.File(""), .captures_error = true, .captures_out = true});
}

class EditorTest : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(RunProgram({"new", "Wag", folder_.File("")}).status, 0);
    const Json file = EditorFile(folder_, "tasks.json");
    for (const Json& task : file.at("tasks")) tasks_[task.at("label")] = task;
  }

  ProcessResult RunTask(const std::string& label) {
    const Json& task = tasks_.at(label);
    return RunInEditor(folder_, task.at("command"), task.at("args"));
  }

  Json Launch() const { return EditorFile(folder_, "launch.json").at("configurations").at(0); }

  const KitFolder folder_{""};
  Json tasks_;
};

TEST_F(EditorTest, TheTasksBuildAndRunTheObject) {
  const ProcessResult built = RunTask("build");
  ASSERT_TRUE(built.good()) << built.output;
  const ProcessResult ran = RunTask("run");
  EXPECT_TRUE(ran.good()) << ran.output;
  EXPECT_THAT(ran.output, HasSubstr("Wag hears 31 sensors\n"));
}

TEST_F(EditorTest, TheTasksRunTheTests) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the library for tests wants a program with sanitizers";
#endif
  for (const char* label : {"configure the tests", "build the tests", "test"}) {
    const ProcessResult result = RunTask(label);
    ASSERT_TRUE(result.good()) << label << "\n" << result.output;
  }
}

TEST_F(EditorTest, EachTaskThatAnotherWaitsForExists) {
  for (const Json& task : tasks_) {
    if (!task.contains("dependsOn")) continue;
    EXPECT_TRUE(tasks_.contains(task.at("dependsOn"))) << task;
  }
  const Json launch = Launch();
  EXPECT_TRUE(tasks_.contains(launch.at("preLaunchTask")));
}

TEST_F(EditorTest, TheDebuggerStopsAtALineOfTheUsersFile) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "leak checks do not work under a debugger";
#endif
  if (!HasProgram("gdb")) GTEST_SKIP() << "gdb is not installed";
  const Json launch = Launch();
  ASSERT_TRUE(RunTask(launch.at("preLaunchTask")).good());
  std::vector<std::string> words{"-q", "-batch"};
  const auto tell = [&words](const std::string& command) {
    words.insert(words.end(), {"-ex", command});
  };
  for (const Json& setting : launch.at("setupCommands")) tell(setting.at("text"));
  const std::string source = folder_.Read("Wag/Wag.cc");
  const long line =
      1 +
      std::count(source.begin(), source.begin() + source.find("observer[event.ObsIndex()]"), '\n');
  tell("break " + folder_.File("Wag/Wag.cc") + ":" + std::to_string(line));
  tell("run");
  tell("print vectors");
  tell("kill");
  words.insert(words.end(), {"--args", launch.at("program")});
  for (const Json& argument : launch.at("args")) words.push_back(argument);
  const ProcessResult result = RunInEditor(folder_, "gdb", words);
  EXPECT_THAT(result.output, HasSubstr("Wag::NotifySensor (this="));
  EXPECT_THAT(result.output, HasSubstr("Wag/Wag.cc:" + std::to_string(line)));
  EXPECT_THAT(result.output, HasSubstr("$1 = 1"));
}

std::set<std::string> TasksOf(const KitFolder& folder) {
  std::set<std::string> labels;
  const Json file = EditorFile(folder, "tasks.json");
  for (const Json& task : file.at("tasks")) labels.insert(task.at("label"));
  return labels;
}

TEST_F(EditorTest, AFolderThatExistsGetsTheSameFiles) {
  constexpr const char* kFiles[] = {"tasks.json", "launch.json", "settings.json",
                                    "extensions.json"};
  std::vector<std::string> before;
  for (const std::string name : kFiles) before.push_back(folder_.Read(".vscode/" + name));
  std::filesystem::remove_all(folder_.File(".vscode"));
  const ProgramResult made = RunProgram({"editor", folder_.File("")});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr("/.vscode/tasks.json\n"));
  EXPECT_THAT(made.out, HasSubstr("the tasks run this stick: MS\n"));
  std::vector<std::string> after;
  for (const std::string name : kFiles) after.push_back(folder_.Read(".vscode/" + name));
  EXPECT_EQ(after, before);
}

TEST_F(EditorTest, FilesOfTheUserAreNotOverwritten) {
  folder_.Write(".vscode/settings.json", "mine");
  std::filesystem::remove(folder_.File(".vscode/tasks.json"));
  const ProgramResult made = RunProgram({"editor", folder_.File("")});
  EXPECT_EQ(made.status, 1);
  EXPECT_THAT(made.err, HasSubstr(" is there already; nothing was written"));
  EXPECT_EQ(folder_.Read(".vscode/settings.json"), "mine");
  EXPECT_FALSE(std::filesystem::exists(folder_.File(".vscode/tasks.json")));
}

TEST_F(EditorTest, WithoutTestsForTheHostThereIsNoTaskForThem) {
  std::filesystem::remove_all(folder_.File(".vscode"));
  std::filesystem::remove(folder_.File("CMakeLists.txt"));
  ASSERT_EQ(RunProgram({"editor", folder_.File("")}).status, 0);
  EXPECT_THAT(TasksOf(folder_), ElementsAre("build", "build for the debugger", "run"));
}

TEST_F(EditorTest, TheTasksRunTheNearestOfSeveralSticks) {
  std::filesystem::remove_all(folder_.File(".vscode"));
  folder_.Write("A/OPEN-R/MW/CONF/CONNECT.CFG", "");
  folder_.Write("build/stick/OPEN-R/MW/CONF/CONNECT.CFG", "");
  const ProgramResult made = RunProgram({"editor", folder_.File("")});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(made.out, HasSubstr("the tasks run this stick: A\n"));
  const Json arguments = Launch().at("args");
  EXPECT_THAT(arguments.at(2), folder_.File("A"));
}

TEST(EditorFolderTest, TheTasksOfAControllerBuildAndRunIt) {
  const KitFolder folder("");
  ASSERT_EQ(RunProgram({"controller", "new", "blink", folder.File("")}).status, 0);
  const ProgramResult made = RunProgram({"editor", folder.File("")});
  ASSERT_EQ(made.status, 0) << made.err;
  EXPECT_THAT(TasksOf(folder), ElementsAre("build", "run"));
  const Json file = EditorFile(folder, "tasks.json");
  for (const Json& task : file.at("tasks")) {
    const ProcessResult result = RunInEditor(folder, task.at("command"), task.at("args"));
    EXPECT_TRUE(result.good()) << task << result.output;
  }
  EXPECT_TRUE(std::filesystem::exists(folder.File("OPEN-R/MW/OBJS/CONTROLL.BIN")));
  EXPECT_EQ(EditorFile(folder, "launch.json").at("configurations").at(0).at("preLaunchTask"),
            "build");
  const Json headers = EditorFile(folder, "settings.json").at("C_Cpp.default.includePath");
  EXPECT_TRUE(std::filesystem::exists(std::string(headers.at(1)) + "/device/robot.h"));
}

TEST(EditorFolderTest, AFolderWithoutAProgramIsRefused) {
  const KitFolder folder("");
  folder.Write("notes.txt", "");
  const ProgramResult made = RunProgram({"editor", folder.File("")});
  EXPECT_EQ(made.status, 1);
  EXPECT_THAT(made.err,
              HasSubstr("no stub.cfg, no entry table, no Makefile and no controller in it"));
  EXPECT_FALSE(std::filesystem::exists(folder.File(".vscode")));
}

// Builds the folder, compiles its files with the commands of compile_commands.json, and returns the
// names of the files below the folder.
std::set<std::string> FilesThatCompile(const KitFolder& folder) {
  EXPECT_EQ(folder.Build({"--compile-commands"}).status, 0);
  std::set<std::string> files;
  for (const Json& command : Json::parse(folder.Read("compile_commands.json"))) {
    std::vector<std::string> words = command.at("arguments");
    words.push_back("-fsyntax-only");
    const ProcessResult result =
        RunProcess(words, {.folder = command.at("directory"), .captures_error = true});
    EXPECT_TRUE(result.good()) << result.output;
    files.insert(std::filesystem::path(command.at("file")).lexically_relative(folder.File("")));
  }
  return files;
}

TEST_F(EditorTest, TheCommandsForEditorsCompileTheUsersFiles) {
  EXPECT_THAT(FilesThatCompile(folder_), ElementsAre("Wag/Wag.cc"));
}

TEST_F(EditorTest, TheCommandsForEditorsNeedNoMakefile) {
  std::filesystem::remove(folder_.File("Makefile"));
  EXPECT_THAT(FilesThatCompile(folder_), ElementsAre("Wag/Wag.cc"));
}

// clangd compiles with clang, which takes an unknown flag for an error.
TEST_F(EditorTest, ClangKnowsTheFlagsOfTheCommandsForEditors) {
  if (!HasProgram("clang++")) GTEST_SKIP() << "clang++ is not installed";
  // A function that returns no value, because a source with one is compiled with more flags.
  folder_.Write("Wag/Wag.cc", folder_.Read("Wag/Wag.cc") + "int Nothing() {}\n");
  ASSERT_EQ(folder_.Build({"--compile-commands"}).status, 0);
  const Json commands = Json::parse(folder_.Read("compile_commands.json"));
  ASSERT_EQ(commands.size(), 1u);
  std::vector<std::string> words = commands.at(0).at("arguments");
  if (words.front() == "ccache") words.erase(words.begin());
  words.front() = "clang++";
  words.push_back("-fsyntax-only");
  const ProcessResult result =
      RunProcess(words, {.folder = commands.at(0).at("directory"), .captures_error = true});
  EXPECT_TRUE(result.good()) << result.output;
}

// Old sources need more than the flags of their Makefile: declarations that headers once had.
TEST_F(EditorTest, TheCommandsForEditorsCompileOldSources) {
  folder_.Write("Wag/Wag.cc", folder_.Read("Wag/Wag.cc") + "double largest = DBL_MAX;\n");
  EXPECT_THAT(FilesThatCompile(folder_), ElementsAre("Wag/Wag.cc"));
  EXPECT_THAT(folder_.Read("compile_commands.json"), HasSubstr("openr_prelude.h"));
}

TEST_F(EditorTest, AFolderThatCannotBeWrittenIsNamed) {
  std::filesystem::create_directory(folder_.File("compile_commands.json"));
  const ProgramResult result = folder_.Build({"--compile-commands"});
  EXPECT_EQ(result.status, 1);
  EXPECT_THAT(result.err, HasSubstr("compile_commands.json"));
}

TEST_F(EditorTest, ABuildAddsNoFileOfCommandsUnasked) {
  ASSERT_EQ(folder_.Build().status, 0);
  EXPECT_FALSE(std::filesystem::exists(folder_.File("compile_commands.json")));
}

}  // namespace
}  // namespace openr_host
