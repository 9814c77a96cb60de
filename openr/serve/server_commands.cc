// The part of RunServer for commands that make a run, let the run go on and watch its messages.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "openr/decode/decode_message.h"
#include "openr/explore/property_file.h"
#include "openr/serve/run_server.h"
#include "openr/serve/server_answer.h"
#include "openr/simulation/network_setup.h"
#include "openr/simulation/sanitizer_start.h"
#include "runtime/config/diagnostic.h"
#include "runtime/core/system.h"
#include "virtualrobot/base/det_math.h"

namespace openr_host {
namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr double kTimeMax_s = 1e6;

double Number(const nlohmann::json& request, const char* name) {
  return request.at(name).get<double>();
}

std::string TextOf(const nlohmann::json& request, const char* name) {
  return request.at(name).get<std::string>();
}

int64_t InUs(double time_s) {
  if (!(time_s >= 0 && time_s <= kTimeMax_s))
    throw std::runtime_error(fmt::format("{} s is no time from 0 to {} s", time_s, kTimeMax_s));
  return static_cast<int64_t>(std::llround(time_s * 1e6));
}

void CheckOneOf(const char* name, const std::string& value, const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), value) == known.end())
    throw std::runtime_error(
        fmt::format("{} is one of {}, not '{}'", name, fmt::join(known, ", "), value));
}

int Count(const nlohmann::json& request, const char* name, int max) {
  const auto count = request.at(name).get<int64_t>();
  if (count < 1 || count > max)
    throw std::runtime_error(fmt::format("{} is 1 to {}, not {}", name, max, count));
  return static_cast<int>(count);
}

ServedRunOptions OptionsOf(const nlohmann::json& request) {
  ServedRunOptions options;
  SimulationOptions& simulation = options.simulation;
  simulation.stick = TextOf(request, "stick");
  if (!MissingSanitizer(simulation.stick).empty()) {
    throw std::runtime_error(
        fmt::format("{}: its objects were built with --sanitize; start the server with openr serve "
                    "--stick {}",
                    simulation.stick, simulation.stick));
  }
  simulation.robot = TextOf(request, "robot");
  simulation.world = TextOf(request, "world");
  simulation.body = TextOf(request, "body");
  simulation.battery = TextOf(request, "battery");
  simulation.images = TextOf(request, "images");
  simulation.cost_file = TextOf(request, "cost");
  if (!request.at("seed").is_number_unsigned())
    throw std::runtime_error("the seed is a whole number, 0 or more");
  simulation.seed = request.at("seed").get<uint64_t>();
  simulation.robots = Count(request, "robots", 100);
  simulation.together = request.at("together").get<bool>();
  simulation.strict = request.at("strict").get<bool>();
  simulation.writable_stick = request.at("writable").get<bool>();
  const std::string network = TextOf(request, "network"), log = TextOf(request, "log");
  CheckOneOf("network", network, {"inside", "host"});
  CheckOneOf("body", simulation.body, {"ode", "ideal"});
  CheckOneOf("log", log, {"error", "warning", "info"});
  if (simulation.together && simulation.body != "ode")
    throw std::runtime_error("robots that are together need body='ode'");
  simulation.host_network = network == "host";
  simulation.rc_port = request.at("rc_port").get<int>();
  if (simulation.host_network) {
    const std::string problem = PortProblem(simulation.rc_port);
    if (!problem.empty()) throw std::runtime_error(problem);
  }
  simulation.log_level = log == "error" ? 1 : log == "warning" ? 2 : 3;
  options.record_file = TextOf(request, "record");
  options.payloads = request.at("payloads").get<bool>();
  options.echo = request.at("echo").get<bool>();
  return options;
}

// Returns a description of the robot as JSON: the names of its devices, and the limits of its
// joints.
OrderedJson DescribeModel(const RobotModel& model) {
  OrderedJson joints = OrderedJson::array(), sensors = joints, leds = joints, limits = joints;
  OrderedJson locators = joints;
  for (const JointModel& joint : model.joints) {
    joints.push_back(joint.name);
    locators.push_back(joint.locator);
    limits.push_back(
        {Degrees(joint.soft_rad.min), Degrees(joint.soft_rad.max), Degrees(joint.speed_rad_s.max)});
  }
  for (const Sensor& sensor : model.sensors) {
    if (sensor.joint < 0) sensors.push_back(sensor.short_name);
  }
  for (const Led& led : model.leds) leds.push_back(led.name);
  return {{"model", model.name},  {"design", model.design}, {"joints", joints},
          {"locators", locators}, {"limits", limits},       {"sensors", sensors},
          {"leds", leds}};
}

MessageFilter FilterOf(const nlohmann::json& request, const System& system) {
  MessageFilter filter{TextOf(request, "kind"), TextOf(request, "sender"),
                       TextOf(request, "receiver"), TextOf(request, "entry")};
  // Checks the names in the filter only after the boot, because services have no names before the
  // boot.
  const std::string problem = system.booted() ? filter.Check(system) : "";
  if (!problem.empty()) throw std::runtime_error(problem);
  return filter;
}

OrderedJson MessageJson(const System& system, const DeliveredMessage& message) {
  return {{"number", message.number},
          {"cause", message.cause},
          {"time_s", static_cast<double>(message.time_us) / 1e6},
          {"kind", message.kind},
          {"from", message.from},
          {"to", message.to},
          {"entry", message.entry},
          {"text", DecodeReceived(system, message.target, message.selector, message.content)},
          {"size", message.content.size()}};
}

// Reads a condition "QUANTITY OP VALUE", by the rules of property files.
PropertyRule ReadCondition(const std::string& text) {
  std::vector<Diagnostic> diagnostics;
  auto rules = ParseProperties("condition", "always " + text, &diagnostics);
  if (rules.size() != 1)
    throw std::runtime_error(
        fmt::format("'{}': write QUANTITY OP VALUE, as 'robots[0].pitch_deg > 10'", text));
  return rules.front();
}

}  // namespace

RunServer::Answer RunServer::DoStart(const Request& request) {
  if (run_ != nullptr) throw std::runtime_error("there is a run already; a process makes one only");
  const double limit_s = Number(request.json, "handler_limit_s");
  const int64_t limit_us = InUs(limit_s);
  ServedRunOptions options = OptionsOf(request.json);
  options.before_loading = [this, limit_us](const std::vector<std::string>& crash_logs) {
    BeginGuards(crash_logs, limit_us);
  };
  run_ = std::make_unique<ServedRun>(options);
  for (const JointModel& joint : run_->simulation().model().joints)
    actuators_.push_back(joint.name);
  return {DescribeModel(run_->simulation().model()), ""};
}

RunServer::Answer RunServer::DoBoot(const Request&) {
  if (run().has_booted()) throw std::runtime_error("the robot has booted already");
  run_->Boot();
  return Time();
}

RunServer::Answer RunServer::DoRun(const Request& request) {
  CheckIsNotFinished();
  const int64_t now_us = run_->system().now_us();
  const double to_s = Number(request.json, "to_s");
  const int64_t to_us = to_s < 0 ? now_us + InUs(Number(request.json, "for_s")) : InUs(to_s);
  if (to_us < now_us)
    throw std::runtime_error(
        fmt::format("t={} s is in the past; a fork of an earlier state goes "
                    "back",
                    to_s));
  run_->RunUntil(to_us);
  return Time();
}

RunServer::Answer RunServer::DoStep(const Request& request) {
  constexpr int kStepsMax = 1'000'000;
  CheckIsNotFinished();
  const std::string over = TextOf(request.json, "over");
  RunClock::Step step;
  if (!RunClock::ParseStep(over, &step))
    throw std::runtime_error(fmt::format("a step is frame, message or vector, not '{}'", over));
  run_->MakeSteps(step, Count(request.json, "count", kStepsMax));
  return Time();
}

// Returns the virtual time at which the command in `request` gives up waiting, for example for a
// message.
int64_t RunServer::LimitOf(const Request& request) {
  return run().system().now_us() + InUs(Number(request.json, "within_s"));
}

RunServer::Answer RunServer::DoUntil(const Request& request) {
  CheckIsNotFinished();
  const PropertyRule rule = ReadCondition(TextOf(request.json, "condition"));
  const std::vector<ReadValue> values = FindValues(rule.quantity, run_->view());
  if (values.size() != 1)
    throw std::runtime_error(fmt::format("'{}' are several values; name one", rule.quantity));
  const auto holds = [&] { return Compares(values[0].read(run_->view()), rule.op, rule.value); };
  const bool met = holds() || run_->RunUntilHolds(holds, LimitOf(request));
  Answer answer = Time();
  answer.json["met"] = met;
  return answer;
}

RunServer::Answer RunServer::DoExpect(const Request& request) {
  CheckIsNotFinished();
  const MessageFilter filter = FilterOf(request.json, run_->system());
  const auto message = run_->RunUntilMessage(filter, LimitOf(request));
  Answer answer = Time();
  answer.json["met"] = message.has_value();
  answer.json["wanted"] = filter.Text();
  if (!message) return answer;
  answer.json["message"] = MessageJson(run_->system(), *message);
  answer.bytes = message->content;
  return answer;
}

RunServer::Answer RunServer::DoWatch(const Request& request) {
  run().Watch(FilterOf(request.json, run_->system()));
  return Time();
}

RunServer::Answer RunServer::DoWatched(const Request&) {
  Answer answer;
  OrderedJson messages = OrderedJson::array();
  for (const DeliveredMessage& message : run().TakeWatched()) {
    messages.push_back(MessageJson(run_->system(), message));
    answer.bytes += message.content;
  }
  answer.json = {{"messages", std::move(messages)}, {"lost", run_->lost_count()}};
  return answer;
}

RunServer::Answer RunServer::DoObserve(const Request& request) {
  const auto names = request.json.at("names").get<std::vector<std::string>>();
  Answer answer;
  if (!names.empty()) {
    observation_.Choose(names, run().view());
    OrderedJson full = OrderedJson::array();
    for (const ReadValue& value : observation_.values()) full.push_back(value.name);
    answer.json["names"] = std::move(full);
  }
  answer.bytes = observation_.Bytes(run().view());
  if (names.empty()) answer.json = Time().json;
  return answer;
}

RunServer::Answer RunServer::DoActuate(const Request& request) {
  const RobotModel& model = run().simulation().model();
  auto names = request.json.at("names").get<std::vector<std::string>>();
  for (std::string& name : names) {
    const int joint = model.JointNamed(name);
    if (joint < 0)
      throw std::runtime_error(fmt::format("the {} has no joint '{}'", model.name, name));
    name = model.joints[static_cast<size_t>(joint)].name;
  }
  if (names.empty()) {
    for (const JointModel& joint : model.joints) names.push_back(joint.name);
  }
  actuators_ = std::move(names);
  return {{{"names", actuators_}}, ""};
}

// Gives the set points of joints in `request` to the run as the input `target`, so that a recording
// has them.
RunServer::Answer RunServer::DoAct(const Request& request) {
  constexpr int kFramesMax = 100'000;
  CheckIsNotFinished();
  const int frames = Count(request.json, "frames", kFramesMax);
  if (!request.bytes.empty()) {
    if (request.bytes.size() != actuators_.size() * sizeof(double)) {
      throw std::runtime_error(fmt::format("act has {} bytes of set points, {} joints need {}",
                                           request.bytes.size(), actuators_.size(),
                                           actuators_.size() * sizeof(double)));
    }
    std::string line = "target";
    for (size_t i = 0; i < actuators_.size(); ++i) {
      double degrees = 0;
      std::memcpy(&degrees, request.bytes.data() + i * sizeof degrees, sizeof degrees);
      // Five decimals are enough, because 0.00001 degrees is less than 1 urad, the unit of set
      // points.
      fmt::format_to(std::back_inserter(line), " {} {:.5f}", actuators_[i], degrees);
    }
    if (request.json.at("ramp").get<bool>())
      fmt::format_to(std::back_inserter(line), " in {}ms", frames * kFrameUs / 1000);
    const std::string problem = run_->system().inputs().Add(0, line);
    if (!problem.empty()) throw std::runtime_error(problem);
  }
  const int64_t frame = run_->system().now_us() / kFrameUs;
  run_->RunUntil((frame + frames) * kFrameUs);
  Answer answer = Time();
  answer.bytes = observation_.Bytes(run_->view());
  return answer;
}

}  // namespace openr_host
