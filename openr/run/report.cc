#include "openr/run/report.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <variant>

#include "cli/colour.h"
#include "cli/counted.h"
#include "openr/decode/decode_message.h"
#include "openr/ending/ending.h"
#include "openr/explore/quantity.h"
#include "openr/simulation/simulation.h"
#include "runtime/base/terminal_text.h"
#include "runtime/core/api.h"
#include "runtime/core/current.h"
#include "runtime/core/system.h"
#include "virtualrobot/base/det_math.h"
#include "virtualrobot/base/rotation.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

// Returns `value` rounded to a multiple of `step`, so that the report shows 0.3 and not
// 0.30000000000000004.
double Rounded(double value, double step) {
  const double rounded = std::round(value / step) * step;
  return rounded == 0 ? 0 : std::round(rounded * 1e9) / 1e9;
}

Colour ColourOf(Severity severity) {
  if (severity == Severity::kError) return Colour::kError;
  return severity == Severity::kWarning ? Colour::kWarning : Colour::kNote;
}

Json Vector(const Eigen::Vector3d& v, double step) {
  return Json::array({Rounded(v.x(), step), Rounded(v.y(), step), Rounded(v.z(), step)});
}

Json RobotReport(const VirtualRobot& robot, bool standing, int rc_port) {
  const RobotModel& model = robot.model();
  const BodyState& state = robot.body().state();
  Json report = {{"model", model.name},
                 {"standing", standing},
                 {"base_position_m", Vector(state.X_WB.translation(), 1e-6)},
                 {"base_rpy_deg", Vector(RpyOf(state.X_WB.linear()).unaryExpr(&Degrees), 1e-4)}};
  Json joints = Json::object(), sensors = Json::object(), leds = Json::object();
  for (size_t i = 0; i < model.joints.size(); ++i) {
    joints[model.joints[i].locator] = Rounded(Degrees(state.joints[i].angle_rad), 1e-4);
  }
  for (size_t i = 0; i < model.sensors.size(); ++i) {
    if (model.sensors[i].kind == SensorKind::kJoint) continue;
    sensors[model.sensors[i].locator] = robot.sensor(static_cast<int>(i)).value;
  }
  for (size_t i = 0; i < model.leds.size(); ++i) {
    leds[model.leds[i].locator] = robot.devices().leds[i].intensity;
  }
  report["joints_deg"] = std::move(joints);
  report["sensors"] = std::move(sensors);
  report["leds"] = std::move(leds);
  Json things = Json::array();
  for (const WorldThing& thing : robot.body().MovableThings())
    things.push_back({{"name", thing.name}, {"position_m", Vector(thing.centre_m, 1e-6)}});
  if (!things.empty()) report["things"] = std::move(things);
  report["rc_port"] = rc_port;
  return report;
}

// Returns the values of the quantities `names` of robot `robot`, rounded to a multiple of `step`.
Json NumbersOf(const SimulationView& view, int robot, const std::vector<std::string>& names,
               double step) {
  Json numbers = Json::array();
  for (const std::string& name : names) {
    const Quantity quantity = FindQuantity(fmt::format("robots[{}].{}", robot, name), view.run());
    numbers.push_back(Rounded(std::get<double>(quantity(view.run())), step));
  }
  return numbers;
}

Json ObjectReport(const Object& object) {
  return {{"robot", object.robot},
          {"name", object.name},
          {"state", object.statistics().state()},
          {"messages", object.message_count()},
          {"dropped", object.statistics().dropped_count()},
          {"queue_max", object.waiting_max()},
          {"heap_bytes_max",
           object.memory().arena() == nullptr ? 0 : object.memory().arena()->bytes_in_use_max()},
          {"stack_bytes_max", object.statistics().stack_max()},
          {"stack_bytes_ocf", object.limits().stack_bytes},
          {"handler_us_max", object.statistics().handler_ns_max() / 1000}};
}

Json FindingReport(const Finding& finding) {
  Json report = {{"severity", SeverityName(finding.severity)},
                 {"robot", finding.robot},
                 {"object", finding.object},
                 {"message", finding.message},
                 {"said", finding.said},
                 {"time_s", static_cast<double>(finding.time_us) / 1e6},
                 {"count", finding.count},
                 {"text", finding.text}};
  if (!finding.also_at.empty()) {
    report["also_at"] = finding.also_at;
    report["also_at_left_out"] = finding.count - 1 - finding.also_at.size();
  }
  return report;
}

}  // namespace

Json MakeReport(Simulation* simulation, const RunFacts& facts) {
  System& system = simulation->system();
  const double virtual_time_s = static_cast<double>(system.now_us()) / 1e6;
  Json report;
  report["virtual_time_s"] = virtual_time_s;
  report["wall_time_s"] = Rounded(facts.wall_time_s, 1e-6);
  report["x_real_time"] =
      facts.wall_time_s > 0 ? Rounded(virtual_time_s / facts.wall_time_s, 0.01) : 0.0;
  report["ended_by"] = system.end() ? Json(EndName(system.end()->kind)) : Json();
  report["ended_why"] = system.end() ? Json(system.end()->why) : Json();
  report["frames"] = simulation->robots().empty() ? 0 : simulation->robots()[0]->frame();
  report["messages"] = system.message_count();
  report["seed"] = facts.seed;
  report["state_hash"] = fmt::format("{:016x}", system.state_hash());
  report["trace_hash"] = fmt::format("{:016x}", system.trace_hash());
  report["rc_port"] = simulation->RcPort(0);
  report["robots"] = Json::array();
  const SimulationView view(simulation);
  for (size_t i = 0; i < simulation->robots().size(); ++i) {
    const int robot = static_cast<int>(i);
    report["robots"].push_back(RobotReport(*simulation->robots()[i], facts.standing[i].standing(),
                                           simulation->RcPort(robot)));
    Json& last = report["robots"].back();
    last["base_velocity_m_s"] = NumbersOf(view, robot, {"forward_m_s", "left_m_s", "up_m_s"}, 1e-6);
    last["turn_deg_s"] = NumbersOf(view, robot, {"turn_deg_s"}, 1e-4)[0];
    const Robot& dog = system.robot(robot);
    last["ended_by"] = dog.powered_off && dog.end ? Json(EndName(dog.end->kind)) : Json();
  }
  report["objects"] = Json::array();
  for (const auto& object : system.objects()) report["objects"].push_back(ObjectReport(*object));
  report["findings"] = ReportOfFindings(system);
  return report;
}

Json ReportOfFindings(const System& system) {
  Json report = Json::array();
  for (const Finding& finding : system.findings().all()) report.push_back(FindingReport(finding));
  return report;
}

std::string DescribeObjects(Simulation* simulation) {
  const System& system = simulation->system();
  std::string text;
  for (const auto& object : system.objects()) {
    const std::string path = object->path.empty() ? "" : object->path + " ";
    const std::string dog =
        system.robot_count() > 1 ? fmt::format(", robot {}", object->robot) : "";
    text += fmt::format("[oid:{:#010x}] {}{}\n", OidValue(object->id),
                        TerminalLine(path + object->name), dog);
  }
  return text;
}

std::string DescribeFindings(Simulation* simulation, bool has_colours) {
  std::string text;
  const Findings& findings = simulation->system().findings();
  for (const Finding& finding : findings.all()) {
    std::string about;
    if (!finding.object.empty()) {
      about = fmt::format("{} ({}, t={:.3f} s): ", finding.object,
                          MessageText(finding.message, finding.said),
                          static_cast<double>(finding.time_us) / 1e6);
    }
    const std::string word = fmt::format("{}:", SeverityName(finding.severity));
    text += fmt::format("{} {}{}{}\n", Coloured(ColourOf(finding.severity), word, has_colours),
                        TerminalText(about), TerminalText(finding.text), RepetitionText(finding));
  }
  if (findings.not_kept() > 0) text += "and " + Counted(findings.not_kept(), "more finding") + "\n";
  return text;
}

void NoteTheEnding(const Ending& ending, Simulation* simulation) {
  System& system = simulation->system();
  const CurrentScope scope(&system, ending.object);
  system.AddFinding(Severity::kError, std::string(ending.finding.text()));
  system.robot_table().NoteRunEnd(EndOf(ending));
}

void PrintHandledMessage(const Ending& ending) {
  if (ending.object == nullptr || ending.object->running() == nullptr) return;
  const Message& message = *ending.object->running();
  const std::string said = DecodeHandled(*ending.object->system, message);
  // Uses fputs() because fmt::print() throws if nobody reads standard error, and no exception may
  // leave an EndingAction.
  std::fputs(TerminalText(fmt::format("openr: {}\n", MessageText(message.number, said))).c_str(),
             stderr);
}

}  // namespace openr_host
