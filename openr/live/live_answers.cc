#include "openr/live/live_answers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "openr/decode/decode_message.h"
#include "openr/live/live_context.h"
#include "openr/live/live_events.h"
#include "openr/live/message_history.h"
#include "openr/live/request_reader.h"
#include "openr/live/run_clock.h"
#include "openr/live/scene_json.h"
#include "openr/render/png_file.h"
#include "openr/rewind/rewind.h"
#include "openr/simulation/known_run.h"
#include "openr/simulation/pacer.h"
#include "openr/simulation/simulation.h"
#include "runtime/base/spelling.h"
#include "runtime/core/api.h"
#include "runtime/core/observer_state.h"
#include "runtime/core/stalls.h"
#include "runtime/core/subject_state.h"
#include "runtime/core/system.h"
#include "virtualrobot/base/det_math.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

// A request of a client, and the run to which it was sent.
struct RequestContext {
  const LiveContext& live;
  const nlohmann::json& request;

  Simulation* simulation() const { return live.simulation; }
  System& system() const { return live.simulation->system(); }
  JsonReader reader() const { return RequestReader(request); }
  // Returns the robot that the request is about.  Throws if the run has no such robot.
  int robot() const { return RobotOfRequest(request, std::max(1, system().robot_count())); }
};

// Returns `bytes` in Base64 (RFC 4648).
std::string Base64(const std::string& bytes) {
  constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t group = 0;
    for (size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? static_cast<uint8_t>(bytes[i + k]) : 0);
    for (size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : kDigits[group >> (18 - 6 * k) & 63];
  }
  return text;
}

Json Error(const std::string& text) { return {{"error", text}}; }

double TimeOf(const RequestContext& context) {
  return static_cast<double>(context.system().now_us()) / 1e6;
}

Json AnswerInput(const RequestContext& context) {
  const std::string line = context.reader().At("line").Text();
  if (context.live.known != nullptr) return Error("this is a recording; nothing can be changed");
  const std::string problem = context.system().inputs().Add(context.robot(), line);
  if (!problem.empty()) return Error(problem);
  return {{"time_s", TimeOf(context)}};
}

Json AnswerInputs(const RequestContext& context) {
  Json inputs = Json::array();
  for (const Inputs::Kind* const kind : context.system().inputs().KindsOf(context.robot()))
    inputs.push_back({{"usage", kind->usage}, {"help", kind->help}});
  return {{"inputs", inputs}};
}

Json AnswerStatus(const RequestContext& context) {
  System& system = context.system();
  Json waits = Json::array();
  for (const std::string& line : DescribeWaits(system)) waits.push_back(line);
  Json ports = Json::array();
  for (int i = 0; i < system.robot_count(); ++i) ports.push_back(context.simulation()->RcPort(i));
  return {{"time_s", TimeOf(context)},
          {"robots", system.robot_count()},
          {"model", context.simulation()->model().name},
          {"messages", system.message_count()},
          {"findings", system.findings().all().size()},
          {"rc_ports", ports},
          {"waits", waits}};
}

Json AnswerObjects(const RequestContext& context) {
  Json objects = Json::array();
  for (const auto& object : context.system().objects()) {
    objects.push_back({{"robot", object->robot},
                       {"name", object->name},
                       {"state", object->statistics().state()},
                       {"messages", object->message_count()},
                       {"waiting", object->waiting()},
                       {"waits_for", object->wait().why()}});
  }
  return {{"time_s", TimeOf(context)}, {"objects", objects}};
}

// Returns the name of the service to which `entry`, a handler of the object `id`, belongs, such as
// "RCServer.Move.MoveCommand.S".  Returns "(gone)" if the object does not exist any more.
std::string ServiceAt(const System& system, const OServiceEntry& entry, ObjectId id) {
  const Object* const object = system.object(id);
  if (object == nullptr) return "(gone)";
  return ServiceOfEntry(*object, entry.GetSelector());
}

Json AnswerObject(const RequestContext& context) {
  const System& system = context.system();
  const std::string name = context.reader().At("name").Text();
  const Object* const object = system.FindObject(context.robot(), name);
  if (object == nullptr) {
    std::vector<std::string> known;
    for (const auto& each : system.objects()) known.push_back(each->name);
    return Error(fmt::format("robot {} has no object '{}'{}", context.robot(), name,
                             DidYouMean(name, known)));
  }
  Json subjects = Json::array(), observers = Json::array(), findings = Json::array();
  for (const auto& subject : object->subjects()) {
    for (const ObserverLink& link : subject->links) {
      subjects.push_back({{"service", subject->service},
                          {"observer", ServiceAt(system, link.observer, link.target)},
                          {"ready", link.ready > 0},
                          {"waiting", link.units.size()},
                          {"sent", link.sent}});
    }
  }
  for (const auto& observer : object->observers()) {
    for (const OSubjectInfo& info : observer->subjects) {
      const ObjectId subject = ObjectIdOf(info.GetSubjectID().GetOID());
      observers.push_back({{"service", ServiceAt(system, observer->id, object->id)},
                           {"subject", ServiceAt(system, info.GetSubjectID(), subject)}});
    }
  }
  for (const Finding& finding : system.findings().all()) {
    if (finding.object == object->name && finding.robot == object->robot)
      findings.push_back(fmt::format("{}: {}{}", SeverityName(finding.severity), finding.text,
                                     MessageInParentheses(finding.message, finding.said)));
  }
  return {{"time_s", TimeOf(context)},
          {"name", object->name},
          {"path", object->path},
          {"state", object->statistics().state()},
          {"messages", object->message_count()},
          {"dropped", object->statistics().dropped_count()},
          {"waiting", object->waiting()},
          {"waits_for", object->wait().why()},
          {"subjects", subjects},
          {"observers", observers},
          {"findings", findings}};
}

// Returns the robot whose number the client's request has in its member "robot"; robot 0 if this
// member is missing.  Returns null if the simulation has no such robot.
const VirtualRobot* RobotOf(const RequestContext& context) {
  const auto& robots = context.simulation()->robots();
  const int robot = context.robot();
  return robot < 0 || robot >= static_cast<int>(robots.size()) ? nullptr
                                                               : robots[static_cast<size_t>(robot)];
}

Json AnswerSensors(const RequestContext& context) {
  const VirtualRobot* const robot = RobotOf(context);
  if (robot == nullptr) return Error(fmt::format("there is no robot {}", context.robot()));
  Json sensors = Json::array();
  const auto& models = robot->model().sensors;
  for (size_t i = 0; i < models.size(); ++i) {
    if (models[i].joint >= 0) continue;
    sensors.push_back({{"name", models[i].short_name},
                       {"value", robot->sensor(static_cast<int>(i)).value},
                       {"long_name", models[i].name},
                       {"locator", models[i].locator}});
  }
  return {{"time_s", TimeOf(context)}, {"sensors", sensors}};
}

Json AnswerJoints(const RequestContext& context) {
  const VirtualRobot* const robot = RobotOf(context);
  if (robot == nullptr) return Error(fmt::format("there is no robot {}", context.robot()));
  Json joints = Json::array();
  const auto& models = robot->model().joints;
  for (size_t i = 0; i < models.size(); ++i) {
    const JointDevice& device = robot->devices().joints[i];
    joints.push_back({{"name", models[i].name},
                      {"deg", Degrees(robot->body().state().joints[i].angle_rad)},
                      {"target_deg", Degrees(device.target_urad * 1e-6)},
                      {"gain", device.gain_enabled}});
  }
  return {{"time_s", TimeOf(context)}, {"joints", joints}};
}

Json AnswerFindings(const RequestContext& context) { return FindingsJson(context.live); }

Json AnswerScene(const RequestContext& context) {
  Json scene = SceneJson(*context.simulation());
  scene["time_s"] = TimeOf(context);
  return scene;
}

// Returns `time_s` in microseconds; times beyond 30 years are shortened to 30 years, so that sums
// of two times do not overflow.
int64_t InUs(double time_s) {
  constexpr double kTimeMax_s = 1e9;
  return static_cast<int64_t>(std::llround(std::clamp(time_s, -kTimeMax_s, kTimeMax_s) * 1e6));
}

// Lets a known run, such as a replay, go on to the later moment `time_us`.  Returns the answer to
// the client: the state of the clock, or an error.
Json GoTo(const RequestContext& context, int64_t time_us) {
  const KnownRun* const known = context.live.known;
  if (known == nullptr) return Error("only a recording can go on to a given moment");
  if (time_us > known->length_us())
    return Error(fmt::format("the recording is over at t={:.3f} s",
                             static_cast<double>(known->length_us()) / 1e6));
  context.live.clock->GoTo(time_us);
  return context.live.events->Clock();
}

// Returns how many steps `request` asks for.
int CountOf(const JsonReader& request) {
  return static_cast<int>(request.WholeOr("count", 1, RunClock::kStepsMax, 1));
}

Json AnswerClock(const RequestContext& context) {
  RunClock* const clock = context.live.clock;
  const JsonReader request = context.reader();
  if (request.Has("to_s")) return GoTo(context, InUs(request.At("to_s").Number()));
  if (clock->is_fixed())
    return Error("a free run cannot be paused, and keeps its rate: its processes do not wait");
  if (request.Has("rate")) {
    const double rate = request.At("rate").Number();
    if (!(rate == 0 || (rate >= Pacer::kRateMin && rate <= Pacer::kRateMax)))
      return Error(fmt::format("the rate {} is neither 0, as fast as possible, nor {} to {}", rate,
                               Pacer::kRateMin, Pacer::kRateMax));
    clock->set_rate(rate);
  }
  if (request.Has("pause")) {
    if (request.At("pause").Bool()) {
      clock->Pause();
    } else {
      clock->GoOn();
    }
  }
  if (request.Has("step")) {
    RunClock::Step step;
    const std::string name = request.At("step").Text();
    if (!RunClock::ParseStep(name, &step))
      return Error(fmt::format("a step is frame, message or vector, not '{}'", name));
    clock->AddSteps(step, CountOf(request));
  }
  return context.live.events->Clock();
}

Json AnswerCamera(const RequestContext& context) {
  const auto& robots = context.simulation()->robots();
  const int robot = context.robot();
  if (robot < 0 || robot >= static_cast<int>(robots.size()))
    return Error(fmt::format("there is no robot {}", robot));
  const std::string layer = context.reader().TextOr("layer", "picture");
  if (layer != "picture" && layer != "colour")
    return Error(fmt::format("a layer is picture or colour, not '{}'", layer));
  VirtualRobot& dog = *robots[static_cast<size_t>(robot)];
  Picture picture;
  const std::string problem =
      layer == "colour" ? dog.CopyColours(&picture) : dog.CopyPicture(&picture);
  if (!problem.empty()) return Error(problem);
  const std::string png = render::EncodePng(picture.width, picture.height, picture.rgb);
  return {{"time_s", TimeOf(context)},
          {"width", picture.width},
          {"height", picture.height},
          {"png", Base64(png)}};
}

// Returns the event of the kind that the request names, such as "values", as one line.  The line
// describes the state of this process: in a view (a copy that repeats the run up to a past moment)
// the state at the past moment.
Json AnswerEvent(const RequestContext& context) {
  const auto name = context.reader().At("name").Text();
  const auto& kinds = LiveEvents::Kinds();
  if (std::none_of(kinds.begin(), kinds.end(), [&](const auto& kind) { return kind.name == name; }))
    return Error(fmt::format("there is no event '{}'", name));
  EventCursor cursor;
  return {{"line", context.live.events->Line(name, &cursor)}};
}

Json AnswerRewind(const RequestContext& context) {
  Rewind* const rewind = context.live.rewind;
  const JsonReader request = context.reader();
  std::string problem;
  if (request.Has("present")) {
    rewind->ShowPresent();
  } else if (request.Has("to_message")) {
    problem =
        rewind->ShowMessage(static_cast<uint64_t>(request.At("to_message").Whole(0, INT64_MAX)));
  } else if (request.Has("back_s")) {
    const int64_t from_us = rewind->shows_past() ? rewind->shown_us() : context.system().now_us();
    problem = rewind->ShowTime(from_us - InUs(request.At("back_s").Number()));
  } else if (request.Has("to_s")) {
    problem = rewind->ShowTime(InUs(request.At("to_s").Number()));
  } else {
    request.Fail("'rewind' needs 'to_s', 'to_message', 'back_s' or 'present'");
  }
  if (!problem.empty()) return Error(problem);
  // Pauses the run, because its state must not change while its user looks at the past.
  context.live.clock->Pause();
  return context.live.events->Clock();
}

Json AnswerBranch(const RequestContext& context) {
  return context.live.rewind->Branch(context.live.clock->rate());
}

Json AnswerHashes(const RequestContext& context) {
  return {{"time_s", TimeOf(context)},
          {"messages", context.system().message_count()},
          {"trace_hash", fmt::format("{:016x}", context.system().trace_hash())},
          {"state_hash", fmt::format("{:016x}", context.system().state_hash())}};
}

// Answers a client's request while the run shows an earlier moment to its user; the answer is about
// that moment.
Json AnswerInPast(const RequestContext& context, const std::string& name) {
  Rewind* const rewind = context.live.rewind;
  if (name == "input")
    return Error(
        "this is the past, where nothing can be changed; go on from here, or go back to "
        "the present");
  if (name != "clock") return rewind->Forward(context.request);
  const JsonReader request = context.reader();
  if (request.Has("to_s")) {
    rewind->ShowPresent();
    return AnswerClock(context);
  }
  if (!request.BoolOr("pause", true))
    return Error("this is the past; go on from here, or go back to the present");
  if (!request.Has("step")) return AnswerClock(context);
  RunClock::Step step;
  if (!RunClock::ParseStep(request.At("step").Text(), &step)) return AnswerClock(context);
  const int count = CountOf(request);
  // Converts `count` to frames: a step of the kind kVector is four frames long, because sensor
  // values come every four frames.
  const int64_t frames = step == RunClock::Step::kVector ? 4 * count : count;
  const std::string problem =
      step == RunClock::Step::kMessage
          ? rewind->ShowMessage(rewind->shown_messages() + static_cast<uint64_t>(count))
          : rewind->ShowTime((rewind->shown_us() / kFrameUs + frames) * kFrameUs);
  return problem.empty() ? context.live.events->Clock() : Error(problem);
}

// Returns the first 64 bytes of `content` as hexadecimal digits; all bytes if there are fewer.
std::string HexOf(const std::string& content) {
  std::string hex;
  for (const char c : content.substr(0, 64)) hex += fmt::format("{:02x}", static_cast<uint8_t>(c));
  return hex;
}

Json AnswerConnection(const RequestContext& context) {
  const auto wanted = context.reader().At("connection").Text();
  for (const Connection& each : context.system().connections()) {
    if (ConnectionName(each.robot, each.subject, each.observer) != wanted) continue;
    Json messages = Json::array();
    for (const MessageHistory::Entry& entry :
         context.live.history->LastOf(each.robot, each.subject, each.observer)) {
      messages.push_back(
          {{"number", entry.number},
           {"time_s", static_cast<double>(entry.time_us) / 1e6},
           {"ready", entry.is_ready},
           {"size", entry.size},
           {"text", DecodeContent(context.simulation()->model(),
                                  entry.is_ready ? "(Ready)" : each.subject, entry.content)},
           {"hex", HexOf(entry.content)}});
    }
    return {{"time_s", TimeOf(context)}, {"messages", messages}};
  }
  return Error(fmt::format("there is no connection '{}'", wanted));
}

const std::map<std::string, Json (*)(const RequestContext&)>& KnownRequests() {
  static const std::map<std::string, Json (*)(const RequestContext&)> requests = {
      {"input", &AnswerInput},     {"inputs", &AnswerInputs},         {"status", &AnswerStatus},
      {"objects", &AnswerObjects}, {"object", &AnswerObject},         {"sensors", &AnswerSensors},
      {"joints", &AnswerJoints},   {"findings", &AnswerFindings},     {"scene", &AnswerScene},
      {"clock", &AnswerClock},     {"connection", &AnswerConnection}, {"rewind", &AnswerRewind},
      {"branch", &AnswerBranch},   {"event", &AnswerEvent},           {"hashes", &AnswerHashes},
      {"camera", &AnswerCamera}};
  return requests;
}

}  // namespace

Json AnswerLive(const LiveContext& live, const nlohmann::json& request) {
  const std::string name = RequestReader(request).At("do").Text();
  const auto found = KnownRequests().find(name);
  const bool is_about_time = name == "rewind" || name == "branch";
  if (live.rewind->shows_past() && !is_about_time && found != KnownRequests().end())
    return AnswerInPast({live, request}, name);
  if (found != KnownRequests().end()) return found->second({live, request});
  std::vector<std::string> known;
  for (const auto& [each, answer] : KnownRequests()) known.push_back(each);
  return Error(fmt::format("'{}' is no request; known are {}", name, fmt::join(known, ", ")));
}

}  // namespace openr_host
