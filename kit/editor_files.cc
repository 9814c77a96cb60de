#include "kit/editor_files.h"

#include <nlohmann/json.hpp>

#include "cli/json_text.h"
#include "kit/gdb_settings.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

constexpr char kFolder[] = "${workspaceFolder}";
constexpr char kStick[] = "${workspaceFolder}/MS";
constexpr char kTestFolder[] = "${workspaceFolder}/build";
constexpr char kBuildTask[] = "build";
constexpr char kDebugBuildTask[] = "build for the debugger";

// Returns a task that starts a program.  The arguments need no quotes, since no shell reads them.
Json Task(const std::string& label, const std::string& program, const Json& arguments) {
  return {{"label", label},
          {"type", "process"},
          {"command", program},
          {"args", arguments},
          {"problemMatcher", Json::array({"$gcc"})}};
}

Json Tasks(const EditorPlaces& places) {
  const std::string& openr = places.program;
  Json build = Task(kBuildTask, openr, {"build", "--compile-commands", kFolder});
  build["group"] = {{"kind", "build"}, {"isDefault", true}};
  const Json debug_build =
      Task(kDebugBuildTask, openr, {"build", "--debug", "--compile-commands", kFolder});
  Json run = Task("run", openr, {"run", "--stick", kStick, "--rate", "max", "--for", "10s"});
  run["dependsOn"] = kBuildTask;
  const Json configure =
      Task("configure the tests", "cmake",
           {"-S", kFolder, "-B", kTestFolder, "-DCMAKE_PREFIX_PATH=" + places.prefix});
  Json build_tests = Task("build the tests", "cmake", {"--build", kTestFolder});
  build_tests["dependsOn"] = "configure the tests";
  Json test = Task("test", "ctest", {"--test-dir", kTestFolder, "--output-on-failure"});
  test["dependsOn"] = "build the tests";
  test["group"] = {{"kind", "test"}, {"isDefault", true}};
  return {{"version", "2.0.0"},
          {"tasks", Json::array({build, debug_build, run, configure, build_tests, test})}};
}

// Returns the settings for a run under gdb.  The run has no time limit for handlers, because the
// user may stop inside one.  Its standard input is /dev/null, because gdb reads the terminal.
Json Launch(const EditorPlaces& places) {
  Json settings = Json::array();
  for (const std::string& command : GdbSettings(places.printers))
    settings.push_back({{"text", command}});
  const Json arguments = {"run",     "--stick",  kStick,       "--rate",          "max",
                          "--for",   "10s",      "--no-panel", "--handler-limit", "0s",
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
                                           {"preLaunchTask", kDebugBuildTask}}})}};
}

}  // namespace

std::vector<NewFile> EditorFiles(const EditorPlaces& places) {
  const Json settings = {
      {"C_Cpp.default.compileCommands", std::string(kFolder) + "/compile_commands.json"},
      {"files.associations", {{"stub.cfg", "plaintext"}, {"*.ocf", "plaintext"}}}};
  const Json extensions = {{"recommendations", Json::array({"ms-vscode.cpptools"})}};
  const auto text = [](const Json& json) { return JsonText(json, 2) + "\n"; };
  return {{".vscode/tasks.json", text(Tasks(places))},
          {".vscode/launch.json", text(Launch(places))},
          {".vscode/settings.json", text(settings)},
          {".vscode/extensions.json", text(extensions)}};
}

}  // namespace openr_host
