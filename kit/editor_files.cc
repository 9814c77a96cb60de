#include "kit/editor_files.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cli/install_paths.h"
#include "cli/json_text.h"
#include "kit/controller_sources.h"
#include "kit/gdb_settings.h"
#include "kit/project.h"
#include "kit/sdk_paths.h"
#include "kit/text_files.h"

namespace openr_host {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr char kFolder[] = "${workspaceFolder}";
constexpr char kTestFolder[] = "${workspaceFolder}/build";
constexpr char kBuildTask[] = "build";
constexpr char kDebugBuildTask[] = "build for the debugger";

// Returns an editor's task that starts `program`.  The arguments need no quotes, since no shell
// reads them.
Json Task(const std::string& label, const std::string& program, const Json& arguments) {
  return {{"label", label},
          {"type", "process"},
          {"command", program},
          {"args", arguments},
          {"problemMatcher", Json::array({"$gcc"})}};
}

std::string StickOf(const EditorFolder& folder) {
  return folder.stick == "." ? kFolder : std::string(kFolder) + "/" + folder.stick;
}

// Returns how long the editor's tasks run the stick, in virtual time.  A controller gets more time,
// because its main() is called only when the robot has stood up, which takes more than 10 s.
const char* DurationOf(const EditorFolder& folder) { return folder.is_controller ? "30s" : "10s"; }

// Returns the name of the editor's task that builds the images for the debugger.  A controller is
// always built with debug information, so its ordinary build task is also the task for the
// debugger.
const char* TaskBeforeDebugger(const EditorFolder& folder) {
  return folder.is_controller ? kBuildTask : kDebugBuildTask;
}

Json BuildTasks(const EditorPlaces& places, const EditorFolder& folder) {
  const std::string& openr = places.program;
  const Json arguments = folder.is_controller ? Json{"controller", "build", kFolder}
                                              : Json{"build", "--compile-commands", kFolder};
  Json build = Task(kBuildTask, openr, arguments);
  build["group"] = {{"kind", "build"}, {"isDefault", true}};
  Json tasks = Json::array({build});
  if (!folder.is_controller)
    tasks.push_back(
        Task(kDebugBuildTask, openr, {"build", "--debug", "--compile-commands", kFolder}));
  Json run =
      Task("run", openr,
           {"run", "--stick", StickOf(folder), "--rate", "max", "--for", DurationOf(folder)});
  run["dependsOn"] = kBuildTask;
  tasks.push_back(run);
  return tasks;
}

Json TestTasks(const EditorPlaces& places) {
  const Json configure =
      Task("configure the tests", "cmake",
           {"-S", kFolder, "-B", kTestFolder, "-DCMAKE_PREFIX_PATH=" + places.prefix});
  Json build_tests = Task("build the tests", "cmake", {"--build", kTestFolder});
  build_tests["dependsOn"] = "configure the tests";
  Json test = Task("test", "ctest", {"--test-dir", kTestFolder, "--output-on-failure"});
  test["dependsOn"] = "build the tests";
  test["group"] = {{"kind", "test"}, {"isDefault", true}};
  return Json::array({configure, build_tests, test});
}

Json Tasks(const EditorPlaces& places, const EditorFolder& folder) {
  Json tasks = BuildTasks(places, folder);
  if (folder.has_tests) {
    for (const Json& task : TestTasks(places)) tasks.push_back(task);
  }
  return {{"version", "2.0.0"}, {"tasks", tasks}};
}

// Returns the settings for a run under gdb.  The run has no time limit for handlers, because the
// user may stop inside a handler.  The standard input of the run is /dev/null, because gdb reads
// the terminal.
Json Launch(const EditorPlaces& places, const EditorFolder& folder) {
  Json settings = Json::array();
  for (const std::string& command : GdbSettings(places.printers))
    settings.push_back({{"text", command}});
  const Json arguments = {"run",     "--stick",          StickOf(folder), "--rate",          "max",
                          "--for",   DurationOf(folder), "--no-panel",    "--handler-limit", "0s",
                          "--stdin", "/dev/null"};
  return {{"version", "0.2.0"},
          {"configurations", Json::array({{{"name", "run under gdb"},
                                           {"type", "cppdbg"},
                                           {"request", "launch"},
                                           {"program", places.program},
                                           {"args", arguments},
                                           {"cwd", kFolder},
                                           {"MIMode", "gdb"},
                                           {"stopAtEntry", false},
                                           {"setupCommands", settings},
                                           {"preLaunchTask", TaskBeforeDebugger(folder)}}})}};
}

// Returns the settings with which the editor finds headers.  For objects, the settings name the
// file of compile commands that the build writes.  The build of a controller writes no such file,
// so for a controller the settings list the folders in which `openr controller build` finds
// headers.
Json Settings(const EditorPlaces& places, const EditorFolder& folder) {
  if (folder.is_controller)
    return {{"C_Cpp.default.includePath",
             Json::array({kFolder, places.headers, places.headers + "/device"})}};
  return {{"C_Cpp.default.compileCommands", std::string(kFolder) + "/compile_commands.json"},
          {"files.associations", {{"stub.cfg", "plaintext"}, {"*.ocf", "plaintext"}}}};
}

// Returns the path of the stick that is nearest to the root of the project, relative to the root.
// If there is no stick, returns the path of the stick that `openr build` will make.
std::string NearestStick(const Project& project) {
  std::vector<std::string> sticks;
  for (const StickFolder& stick : project.sticks)
    sticks.push_back(stick.root.lexically_normal().lexically_relative(project.root));
  if (sticks.empty()) return "MS";
  const auto is_nearer = [](const std::string& a, const std::string& b) {
    const fs::path path_a(a), path_b(b);
    const auto depth_a = std::distance(path_a.begin(), path_a.end());
    const auto depth_b = std::distance(path_b.begin(), path_b.end());
    return depth_a != depth_b ? depth_a < depth_b : a < b;
  };
  return *std::min_element(sticks.begin(), sticks.end(), is_nearer);
}

}  // namespace

EditorPlaces FindEditorPlaces() {
  return {ProgramFile(), fs::path(ProgramFolder()).parent_path(), GdbPrinters(),
          SdkRoot() + "/controller/include"};
}

EditorFolder DescribeEditorFolder(const std::string& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error)) throw std::runtime_error(folder + ": is no folder");
  const fs::path root = fs::canonical(folder);
  const Project project = ScanProject({root});
  if (project.objects.empty() && IsControllerFolder(root))
    return {.is_controller = true, .stick = ".", .has_tests = false};
  if (project.objects.empty() && project.makefiles.empty())
    throw std::runtime_error(folder +
                             ": no stub.cfg, no entry table, no Makefile and no controller in it; "
                             "'openr new' and 'openr "
                             "controller new' make something to begin with");
  const std::string cmake = ReadText(root / "CMakeLists.txt").value_or("");
  return {.stick = NearestStick(project), .has_tests = cmake.find("openr-host") != cmake.npos};
}

std::vector<NewFile> EditorFiles(const EditorPlaces& places, const EditorFolder& folder) {
  const Json extensions = {{"recommendations", Json::array({"ms-vscode.cpptools"})}};
  const auto text = [](const Json& json) { return JsonText(json, 2) + "\n"; };
  return {{".vscode/tasks.json", text(Tasks(places, folder))},
          {".vscode/launch.json", text(Launch(places, folder))},
          {".vscode/settings.json", text(Settings(places, folder))},
          {".vscode/extensions.json", text(extensions)}};
}

}  // namespace openr_host
