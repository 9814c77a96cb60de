#include "openr/live/live_answers.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "openr/simulation/simulation.h"
#include "runtime/base/spelling.h"
#include "runtime/core/api.h"
#include "runtime/core/connection_state.h"
#include "runtime/core/stalls.h"
#include "virtualrobot/det_math.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

// One request, and the run that it is about.
struct Asked {
  Simulation* simulation;
  const nlohmann::json& request;

  System& system() const { return simulation->system(); }
  int robot() const { return request.value("robot", 0); }
};

Json Error(const std::string& text) { return {{"error", text}}; }

double TimeOf(const Asked& asked) { return static_cast<double>(asked.system().now_us()) / 1e6; }

Json AnswerInput(const Asked& asked) {
  const std::string line = asked.request.at("line").get<std::string>();
  const std::string problem = asked.system().inputs().Add(asked.robot(), line);
  if (!problem.empty()) return Error(problem);
  return {{"time_s", TimeOf(asked)}};
}

Json AnswerInputs(const Asked& asked) {
  Json inputs = Json::array();
  for (const Inputs::Verb* const verb : asked.system().inputs().VerbsOf(asked.robot()))
    inputs.push_back({{"usage", verb->usage}, {"help", verb->help}});
  return {{"inputs", inputs}};
}

Json AnswerStatus(const Asked& asked) {
  System& system = asked.system();
  Json waits = Json::array();
  for (const std::string& line : system.WhoWaits()) waits.push_back(line);
  return {{"time_s", TimeOf(asked)},
          {"robots", system.robot_count()},
          {"model", asked.simulation->model().name},
          {"messages", system.message_count()},
          {"findings", system.findings().all().size()},
          {"waits", waits}};
}

Json AnswerObjects(const Asked& asked) {
  Json objects = Json::array();
  for (const auto& object : asked.system().objects()) {
    objects.push_back({{"robot", object->robot},
                       {"name", object->name},
                       {"state", object->state},
                       {"messages", object->message_count},
                       {"waiting", object->waiting},
                       {"waits_for", object->handler.blocked_why}});
  }
  return {{"time_s", TimeOf(asked)}, {"objects", objects}};
}

// Returns the name of the service that `entry`, a handler of the object `id`, belongs to:
// "RCServer.Move.MoveCommand.S".  Returns "(gone)" if the object does not exist any more.
std::string ServiceAt(const System& system, const OServiceEntry& entry, ObjectId id) {
  const Object* const object = system.object(id);
  if (object == nullptr) return "(gone)";
  const std::string name = object->EntryName(entry.GetSelector());
  return name.substr(0, name.find(" ("));
}

Json AnswerObject(const Asked& asked) {
  const System& system = asked.system();
  const std::string name = asked.request.at("name").get<std::string>();
  const Object* const object = system.FindObject(asked.robot(), name);
  if (object == nullptr) {
    std::vector<std::string> known;
    for (const auto& each : system.objects()) known.push_back(each->name);
    return Error(
        fmt::format("robot {} has no object '{}'{}", asked.robot(), name, DidYouMean(name, known)));
  }
  Json subjects = Json::array(), observers = Json::array(), findings = Json::array();
  for (const auto& subject : object->subjects) {
    for (const auto& link : subject->links) {
      const ObjectId observer = ObjectIdOf(link->observer.GetOID());
      subjects.push_back({{"service", subject->service},
                          {"observer", ServiceAt(system, link->observer, observer)},
                          {"ready", link->ready > 0},
                          {"waiting", link->units.size()},
                          {"sent", link->sent}});
    }
  }
  for (const auto& observer : object->observers) {
    for (const OSubjectInfo& info : observer->subjects) {
      const ObjectId subject = ObjectIdOf(info.GetSubjectID().GetOID());
      observers.push_back({{"service", ServiceAt(system, observer->id, object->id)},
                           {"subject", ServiceAt(system, info.GetSubjectID(), subject)}});
    }
  }
  for (const Finding& finding : system.findings().all()) {
    if (finding.object == object->name && finding.robot == object->robot)
      findings.push_back(fmt::format("{}: {}", SeverityName(finding.severity), finding.text));
  }
  return {{"time_s", TimeOf(asked)},
          {"name", object->name},
          {"path", object->path},
          {"state", object->state},
          {"messages", object->message_count},
          {"dropped", object->dropped_count},
          {"waiting", object->waiting},
          {"waits_for", object->handler.blocked_why},
          {"subjects", subjects},
          {"observers", observers},
          {"findings", findings}};
}

// Returns the robot whose number the request gives in "robot" (without it, robot 0); null if the
// simulation has no robot of this number.
const VirtualRobot* RobotOf(const Asked& asked) {
  const auto& robots = asked.simulation->robots();
  const int robot = asked.robot();
  return robot < 0 || robot >= static_cast<int>(robots.size()) ? nullptr
                                                               : robots[static_cast<size_t>(robot)];
}

Json AnswerSensors(const Asked& asked) {
  const VirtualRobot* const robot = RobotOf(asked);
  if (robot == nullptr) return Error(fmt::format("there is no robot {}", asked.robot()));
  Json sensors = Json::array();
  const auto& models = robot->model().sensors;
  for (size_t i = 0; i < models.size(); ++i) {
    if (models[i].joint >= 0) continue;
    sensors.push_back({{"name", models[i].short_name},
                       {"value", robot->sensor(static_cast<int>(i)).value},
                       {"long_name", models[i].name},
                       {"locator", models[i].locator}});
  }
  return {{"time_s", TimeOf(asked)}, {"sensors", sensors}};
}

Json AnswerJoints(const Asked& asked) {
  const VirtualRobot* const robot = RobotOf(asked);
  if (robot == nullptr) return Error(fmt::format("there is no robot {}", asked.robot()));
  Json joints = Json::array();
  const auto& models = robot->model().joints;
  for (size_t i = 0; i < models.size(); ++i) {
    const JointDevice& device = robot->devices().joints[i];
    joints.push_back({{"name", models[i].name},
                      {"deg", Degrees(robot->body().state().joints[i].angle_rad)},
                      {"target_deg", Degrees(device.target_urad * 1e-6)},
                      {"gain", device.gain_enabled}});
  }
  return {{"time_s", TimeOf(asked)}, {"joints", joints}};
}

Json AnswerFindings(const Asked& asked) {
  Json findings = Json::array();
  for (const Finding& finding : asked.system().findings().all()) {
    findings.push_back({{"severity", SeverityName(finding.severity)},
                        {"robot", finding.robot},
                        {"object", finding.object},
                        {"time_s", static_cast<double>(finding.time_us) / 1e6},
                        {"count", finding.count},
                        {"text", finding.text}});
  }
  return {{"time_s", TimeOf(asked)}, {"findings", findings}};
}

const std::map<std::string, Json (*)(const Asked&)>& KnownRequests() {
  static const std::map<std::string, Json (*)(const Asked&)> requests = {
      {"input", &AnswerInput},     {"inputs", &AnswerInputs},    {"status", &AnswerStatus},
      {"objects", &AnswerObjects}, {"object", &AnswerObject},    {"sensors", &AnswerSensors},
      {"joints", &AnswerJoints},   {"findings", &AnswerFindings}};
  return requests;
}

}  // namespace

Json AnswerLive(Simulation* simulation, const nlohmann::json& request) {
  const std::string name = request.at("do").get<std::string>();
  const auto found = KnownRequests().find(name);
  if (found != KnownRequests().end()) return found->second({simulation, request});
  std::vector<std::string> known;
  for (const auto& [each, answer] : KnownRequests()) known.push_back(each);
  return Error(fmt::format("'{}' is no request; known are {}", name, fmt::join(known, ", ")));
}

}  // namespace openr_host
