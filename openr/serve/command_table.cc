#include "openr/serve/command_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "cli/json_text.h"
#include "runtime/base/spelling.h"

namespace openr_host {
namespace {

constexpr char kTime[] = "time_s: number";
constexpr CommandParameter kRobot = {"robot", "integer", "0", "number of the robot"};

std::vector<RunCommand> MakeStartCommands() {
  return {
      {"start",
       "Makes the run, ready to boot.",
       {{"stick", "text", "\"\"", "folder that holds OPEN-R; without it the default stick"},
        {"robot", "text", "\"ers210\"", "model: ers210, ers220 or ers7"},
        {"world", "text", "\"\"", "world file"},
        {"body", "text", "\"ode\"", "ode: physics; ideal: joints follow exactly"},
        {"seed", "integer", "1", "seed of the run"},
        {"robots", "integer", "1", "number of robots"},
        {"together", "flag", "false", "all robots are in one world"},
        {"battery", "text", "\"drain\"", "drain, 100% or N%"},
        {"images", "text", "\"world\"", "what cameras see: world, pattern or a folder"},
        {"cost", "text", "\"\"", "cost file of handlers"},
        {"strict", "flag", "false", "enforce the limits of the robot"},
        {"network", "text", "\"inside\"",
         "inside: connections are made by connect; host: by sockets of this computer"},
        {"rc_port", "integer", "0",
         "with network host: port of the remote control, 0: any free one"},
        {"writable", "flag", "true", "objects may write to the stick"},
        {"record", "text", "\"\"", "file of a recording"},
        {"payloads", "flag", "true", "the recording has the bytes of messages"},
        {"log", "text", "\"info\"", "log lines of objects that are kept: error, warning, info"},
        {"echo", "flag", "false", "print on standard error what objects print"},
        {"handler_limit_s", "number", "10.0",
         "processor time after which a handler ends the run; 0: never"}},
       "model: text, joints, sensors, leds: texts, limits: for each joint [min, max, speed] in "
       "degrees"},
      {"boot", "Begins the boot: DoInit and DoStart of all objects follow.", {}, kTime},
  };
}

std::vector<RunCommand> MakeRunCommands() {
  return {
      {"run",
       "Runs for a time, or to a time.",
       {{"for_s", "number", "0.0", "virtual time"},
        {"to_s", "number", "-1.0", "virtual time to run to; -1: for_s says how long"}},
       kTime},
      {"step",
       "Runs over messages, to the ends of frames of 8 ms, or over sensor vectors.",
       {{"over", "text", "\"frame\"", "message, frame or vector"},
        {"count", "integer", "1", "how many"}},
       kTime},
      {"until",
       "Runs until a comparison holds at the end of a frame.",
       {{"condition", "text", nullptr, "QUANTITY OP VALUE, as in docs/exploring.md"},
        {"within_s", "number", nullptr, "the longest virtual time"}},
       "time_s: number, met: flag"},
      {"expect",
       "Runs until a message that fits has been handled.",
       {{"kind", "text", "\"\"", "notify, ready, not ready, reply or other; empty: any"},
        {"sender", "text", "\"\"", "object or service of the sender; empty: any"},
        {"receiver", "text", "\"\"", "object or service of the receiver; empty: any"},
        {"entry", "text", "\"\"", "name of the receiver's handler; empty: any"},
        {"within_s", "number", nullptr, "the longest virtual time"}},
       "time_s: number, met: flag, message: its number, cause, time_s, kind, from, to, entry, text "
       "(content in words); bytes: its content"},
      {"watch",
       "Keeps messages that fit from now on.",
       {{"kind", "text", "\"\"", "as in expect"},
        {"sender", "text", "\"\"", "as in expect"},
        {"receiver", "text", "\"\"", "as in expect"},
        {"entry", "text", "\"\"", "as in expect"}},
       kTime},
      {"watched",
       "Takes the messages that were kept, at most the last 10,000, with at most 64 MiB.",
       {},
       "messages: as in expect, each with size; lost: integer, those that gave way since the "
       "start; bytes: their contents"},
      {"observe",
       "Chooses the values that act and observe answer, and answers them.",
       {{"names", "texts", "[]", "quantities and groups; empty: those chosen before"}},
       "names: texts, where they were chosen; bytes: numbers"},
      {"actuate",
       "Chooses the joints whose set points act has.",
       {{"names", "texts", nullptr, "joints; empty: all"}},
       "names: texts"},
      {"act",
       "Gives the chosen joints set points, runs some frames, and answers the chosen values.  "
       "Without set points the joints keep theirs.",
       {{"frames", "integer", "4", "frames of 8 ms"},
        {"ramp", "flag", "true", "set points move evenly in these frames; else they jump"}},
       "time_s: number; bytes: numbers",
       "set points in degrees, one for each chosen joint"},
  };
}

std::vector<RunCommand> MakeInputCommands() {
  return {
      {"input",
       "Gives the run an input (docs/inputs.md) for the next frame boundary.",
       {{"line", "text", nullptr, "press chin for 300ms"}, kRobot},
       kTime},
      {"inputs",
       "Lists the inputs that the run knows.",
       {kRobot},
       "inputs: usage and help of each"},
      {"connect",
       "Connects to a TCP port of a robot.",
       {{"port", "integer", nullptr, "54000 is the remote control"}, kRobot},
       "connection: integer"},
      {"send",
       "Sends bytes to the robot.",
       {{"connection", "integer", nullptr, "the number that connect answered"}},
       kTime,
       "what to send"},
      {"receive",
       "Takes bytes that the robot has sent; runs until so many are there.",
       {{"connection", "integer", nullptr, "the number that connect answered"},
        {"count", "integer", "0", "bytes to wait for; 0: takes those that are there"},
        {"within_s", "number", "1.0", "the longest virtual time to wait"}},
       "time_s: number, open: flag; bytes: what came"},
      {"disconnect",
       "Closes a connection.",
       {{"connection", "integer", nullptr, "the number that connect answered"}},
       kTime},
      {"fork",
       "Copies the process.  The copy goes on from this state at a socket of its own, the "
       "descriptor that comes with the request.",
       {{"record", "text", "\"\"", "file in which the copy goes on with the recording"}},
       "process: integer"},
  };
}

std::vector<RunCommand> MakeReadCommands() {
  return {
      {"read",
       "Reads values by their names.",
       {{"names", "texts", nullptr, "quantities and groups; texts are allowed"}},
       "values: by name"},
      {"motion",
       "Makes a motion file (MTN); needs no run.",
       {{"csv", "text", nullptr, "its key frames, as openr mtn dump prints them"},
        {"name", "text", "\"motion\"", "name of the motion in the file"}},
       "bytes: the file"},
      {"status", "Time, robots, messages, who waits.", {}, "as in docs/inputs.md"},
      {"objects", "The objects with their states.", {}, "objects"},
      {"object",
       "An object with its services and connections.",
       {{"name", "text", nullptr, "name of the object"}, kRobot},
       "subjects, observers, findings"},
      {"sensors", "The sensors by name, in OPEN-R's units.", {kRobot}, "sensors"},
      {"joints", "The joints: measured and commanded angle.", {kRobot}, "joints"},
      {"findings", "Errors, warnings and notes about programs.", {}, "findings"},
      {"hashes", "Hashes of messages and state.", {}, "trace_hash, state_hash: texts"},
      {"console",
       "What objects have printed: the last 1000 lines.",
       {{"first", "integer", "0", "number of the first line wanted"}},
       "first, next: integers, lines: texts"},
      {"camera",
       "The picture of a robot's camera.",
       {{"layer", "text", "\"picture\"", "picture or colour"}, kRobot},
       "width, height: integers, png: Base64"},
      {"picture",
       "Writes a picture of the robot to a PNG file.",
       {{"file", "text", nullptr, "the file"},
        {"view", "text", "\"iso\"", "iso, side, front, top, follow, world or camera"},
        {"size", "text", "\"1280x720\"", "width and height"},
        kRobot},
       kTime},
      {"report", "The report, as openr run writes it.", {}, "docs/cli.md, The report"},
      {"finish",
       "Ends the run, and completes its recording.  The run can be read still, but not go on.",
       {},
       "the report"},
  };
}

bool IsOfType(const nlohmann::json& value, std::string_view type) {
  if (type == "text") return value.is_string();
  if (type == "number") return value.is_number();
  if (type == "integer") return value.is_number_integer();
  if (type == "flag") return value.is_boolean();
  return value.is_array() &&
         std::all_of(value.begin(), value.end(),
                     [](const nlohmann::json& each) { return each.is_string(); });
}

std::string CheckParameter(const RunCommand& command, const std::string& name,
                           const nlohmann::json& value) {
  for (const CommandParameter& parameter : command.parameters) {
    if (name != parameter.name) continue;
    if (IsOfType(value, parameter.type)) return "";
    return fmt::format("{}: '{}' is of the wrong type, it must be: {}", command.name, name,
                       parameter.type);
  }
  std::vector<std::string> known;
  for (const CommandParameter& parameter : command.parameters) known.push_back(parameter.name);
  return fmt::format("{} has no parameter '{}'{}", command.name, name, DidYouMean(name, known));
}

}  // namespace

const std::vector<RunCommand>& RunCommands() {
  static const std::vector<RunCommand> all = [] {
    std::vector<RunCommand> commands;
    for (auto make :
         {&MakeStartCommands, &MakeRunCommands, &MakeInputCommands, &MakeReadCommands}) {
      for (RunCommand& command : make()) commands.push_back(std::move(command));
    }
    return commands;
  }();
  return all;
}

const RunCommand* FindRunCommand(const std::string& name) {
  for (const RunCommand& command : RunCommands()) {
    if (name == command.name) return &command;
  }
  return nullptr;
}

nlohmann::ordered_json DescribeRunCommands() {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const RunCommand& command : RunCommands()) {
    nlohmann::ordered_json parameters = nlohmann::ordered_json::array();
    for (const CommandParameter& parameter : command.parameters) {
      nlohmann::ordered_json each = {
          {"name", parameter.name}, {"type", parameter.type}, {"help", parameter.help}};
      if (parameter.otherwise != nullptr)
        each["otherwise"] = ParseJson<nlohmann::ordered_json>(parameter.otherwise);
      parameters.push_back(std::move(each));
    }
    all.push_back({{"name", command.name},
                   {"help", command.help},
                   {"parameters", std::move(parameters)},
                   {"takes", command.takes},
                   {"answer", command.answer}});
  }
  return {{"commands", std::move(all)}};
}

std::string CompleteRequest(nlohmann::json* request) {
  if (!request->is_object() || !request->contains("do") || !(*request)["do"].is_string())
    return "a request is a JSON object with the name of the command in 'do'";
  const auto name = (*request)["do"].get<std::string>();
  const RunCommand* const command = FindRunCommand(name);
  if (command == nullptr) {
    std::vector<std::string> known;
    for (const RunCommand& each : RunCommands()) known.push_back(each.name);
    return fmt::format("'{}' is no command{}", name, DidYouMean(name, known));
  }
  for (const auto& [key, value] : request->items()) {
    if (key == "do") continue;
    if (std::string problem = CheckParameter(*command, key, value); !problem.empty())
      return problem;
  }
  for (const CommandParameter& parameter : command->parameters) {
    if (request->contains(parameter.name)) continue;
    if (parameter.otherwise == nullptr) return fmt::format("{} needs '{}'", name, parameter.name);
    (*request)[parameter.name] = ParseJson<nlohmann::json>(parameter.otherwise);
  }
  return "";
}

}  // namespace openr_host
