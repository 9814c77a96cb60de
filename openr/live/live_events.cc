#include "openr/live/live_events.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "cli/json_text.h"
#include "openr/decode/decode_message.h"
#include "openr/live/console_log.h"
#include "openr/live/message_history.h"
#include "openr/live/run_clock.h"
#include "openr/live/scene_json.h"
#include "openr/rewind/rewind.h"
#include "openr/simulation/known_run.h"
#include "openr/simulation/simulation.h"
#include "runtime/base/wall_clock.h"
#include "runtime/core/subject_state.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

constexpr int64_t kMs = 1'000'000;  // a millisecond in nanoseconds

// The least virtual time over which messages are counted to compute a rate.
constexpr int64_t kRateUs = 500'000;

// A client that begins to watch the event "log" gets at most this many of the lines that objects
// have printed before that.
constexpr size_t kFirstLines = 200;

double InSeconds(int64_t time_us) { return static_cast<double>(time_us) / 1e6; }

// Returns the ObserverLink of `connection`, by which its subject sends to its observer.  Returns
// null until the objects have made the link.  Returns null also for a subject of a system object,
// because it has no OSubject.
const ObserverLink* LinkOf(System* system, const Connection& connection) {
  const auto& directory = system->robot(connection.robot).directory;
  const auto from = directory.find(connection.subject), to = directory.find(connection.observer);
  if (from == directory.end() || to == directory.end()) return nullptr;
  const Object* const object = system->object(from->second.first);
  if (object == nullptr) return nullptr;
  for (const auto& subject : object->subjects()) {
    if (subject->service != connection.subject) continue;
    for (const ObserverLink& link : subject->links) {
      const Object* const observer = system->object(link.target);
      if (observer != nullptr && observer->id == to->second.first &&
          ServiceOfEntry(*observer, link.observer.GetSelector()) == connection.observer)
        return &link;
    }
  }
  return nullptr;
}

std::string ObjectOf(const std::string& service) { return service.substr(0, service.find('.')); }

}  // namespace

std::string ConnectionName(int robot, const std::string& subject, const std::string& observer) {
  return fmt::format("{}:{}>{}", robot, subject, observer);
}

Json FindingsJson(const LiveContext& context) {
  System& system = context.simulation->system();
  Json findings = Json::array();
  for (const Finding& finding : system.findings().all()) {
    findings.push_back({{"severity", SeverityName(finding.severity)},
                        {"robot", finding.robot},
                        {"object", finding.object},
                        {"time_s", InSeconds(finding.time_us)},
                        {"message", finding.message},
                        {"said", OneLineOf(finding.said)},
                        {"count", finding.count},
                        {"text", finding.text}});
  }
  return {{"time_s", InSeconds(system.now_us())}, {"findings", findings}};
}

const std::vector<LiveEvents::Kind>& LiveEvents::Kinds() {
  static const std::vector<Kind> kinds = {{"clock", 100 * kMs},    {"pose", 0},
                                          {"values", 100 * kMs},   {"graph", 250 * kMs},
                                          {"findings", 100 * kMs}, {"log", 100 * kMs}};
  return kinds;
}

// Returns a number that grows whenever the run goes on.  While the number stays the same, clients
// need no new line about the state of the run.
uint64_t LiveEvents::Version() const {
  System& system = context_.simulation->system();
  return system.message_count() + static_cast<uint64_t>(system.now_us());
}

int LiveEvents::robot_count() const { return context_.simulation->system().robot_count(); }

void LiveEvents::WatchGraph(bool is_watched) {
  if (is_watched) {
    context_.history->Begin();
  } else {
    context_.history->End();
  }
}

std::string LiveEvents::Line(std::string_view name, EventCursor* cursor) {
  const std::string begin = fmt::format("{{\"event\":\"{}\"", name);
  const auto line = [&begin](const Json& body) { return begin + "," + JsonText(body).substr(1); };
  if (name == "clock") return line(Clock());
  if (context_.rewind->shows_past()) return LineOfPast(name, cursor);
  if (name == "log") {
    const Json lines = Log(cursor);
    return lines.empty() ? "" : line({{"lines", lines}});
  }
  if (name == "findings") {
    const uint64_t count = context_.simulation->system().findings().all().size();
    if (std::exchange(cursor->findings, count) == count) return "";
    // Forgets the past moment whose findings were sent last, so that the client gets them again
    // when the same moment is shown again.
    cursor->versions.erase(std::string(name));
    return line(FindingsJson(context_));
  }
  uint64_t& shown = cursor->versions[std::string(name)];
  // `shown` is the version of the run's state that was sent to the client last; 0: none was sent
  // yet.  The present version can be 0 at the beginning.  So adds 1 to it, because otherwise this
  // state would not be sent.
  if (const uint64_t version = Version() + 1; std::exchange(shown, version) == version) return "";
  if (name == "pose") return begin + "," + PoseText(context_.simulation) + "}";
  return line(name == "values" ? ValuesJson(context_.simulation) : Graph());
}

// Returns the event `name` about the earlier moment of the run that the user looks at.  The process
// that shows this moment makes the event.  Returns "" for the event "log", because the client has
// already got the log lines up to this moment.
std::string LiveEvents::LineOfPast(std::string_view name, EventCursor* cursor) {
  if (name == "log") return "";
  // Resets the number of findings that were sent to the client, so that the client gets all
  // findings again when the present is shown again.
  if (name == "findings") cursor->findings = UINT64_MAX;
  const Rewind& rewind = *context_.rewind;
  // The version of the state at the past moment: the sum of its virtual time and its number of
  // messages, as Version() returns it for the present state, but with the highest bit set.  No
  // version of a present state has this bit.  So the version changes when the user goes from the
  // present to the past, or back, and the client then gets a new event.
  const uint64_t moment =
      static_cast<uint64_t>(rewind.shown_us()) + rewind.shown_messages() + (uint64_t{1} << 63);
  uint64_t& shown = cursor->versions[std::string(name)];
  if (std::exchange(shown, moment) == moment) return "";
  const Json answer = context_.rewind->Forward({{"do", "event"}, {"name", name}});
  return answer.value("line", "");
}

void LiveEvents::UpdateSpeed() {
  const int64_t now_ns = WallClockNs(), now_us = context_.simulation->system().now_us();
  if (now_ns - speed_ns_ < 500 * kMs) return;
  if (speed_ns_ > 0) {
    speed_ =
        1000 * static_cast<double>(now_us - speed_us_) / static_cast<double>(now_ns - speed_ns_);
  }
  speed_ns_ = now_ns;
  speed_us_ = now_us;
}

Json LiveEvents::Clock() {
  UpdateSpeed();
  System& system = context_.simulation->system();
  const Rewind& rewind = *context_.rewind;
  const bool is_past = rewind.shows_past();
  Json clock = {{"time_s", InSeconds(is_past ? rewind.shown_us() : system.now_us())},
                {"messages", is_past ? rewind.shown_messages() : system.message_count()},
                {"paused", context_.clock->paused()},
                {"rate", context_.clock->rate()},
                {"speed", speed_},
                {"rewind", context_.rewind->Status()}};
  if (context_.known != nullptr) {
    clock["length_s"] = InSeconds(context_.known->length_us());
    clock["over"] = context_.known->EndReason();
  }
  return clock;
}

// Computes the messages per second of virtual time since the last update, for every object and
// connection.  Does nothing if less than kRateUs has passed since the last update, because the
// rates would be inexact.
void LiveEvents::UpdateRates() {
  System& system = context_.simulation->system();
  const int64_t passed_us = system.now_us() - rates_us_;
  if (passed_us >= 0 && passed_us < kRateUs) return;
  rates_us_ = system.now_us();
  const auto update = [passed_us](Rate* rate, uint64_t count) {
    // The count of messages begins at 0 again when an object is loaded again, or when nobody has
    // watched the event "graph" for a time.  So if `count` is smaller than at the last update, the
    // increase is `count` itself.
    const uint64_t more = count >= rate->count ? count - rate->count : count;
    rate->per_s = passed_us > 0 ? static_cast<double>(more) / InSeconds(passed_us) : 0;
    rate->count = count;
  };
  for (const auto& object : system.objects())
    update(&objects_[object->id], object->message_count());
  for (size_t i = 0; i < system.connections().size(); ++i) {
    const Connection& each = system.connections()[i];
    update(&connections_[i], context_.history->CountOf(each.robot, each.subject, each.observer));
  }
}

Json LiveEvents::ConnectionsJson() {
  System& system = context_.simulation->system();
  Json connections = Json::array();
  for (size_t i = 0; i < system.connections().size(); ++i) {
    const Connection& each = system.connections()[i];
    const ObserverLink* const link = LinkOf(&system, each);
    Json ready, waiting = 0, sent = connections_[i].count;
    if (link != nullptr) {
      ready = link->ready > 0;
      waiting = link->units.size();
      sent = link->sent;
    }
    connections.push_back({{"id", ConnectionName(each.robot, each.subject, each.observer)},
                           {"robot", each.robot},
                           {"from", ObjectOf(each.subject)},
                           {"to", ObjectOf(each.observer)},
                           {"subject", each.subject},
                           {"observer", each.observer},
                           {"ready", ready},
                           {"waiting", waiting},
                           {"sent", sent},
                           {"per_s", connections_[i].per_s}});
  }
  return connections;
}

Json LiveEvents::Graph() {
  System& system = context_.simulation->system();
  UpdateRates();
  std::map<std::pair<int, std::string>, int> findings;
  for (const Finding& finding : system.findings().all())
    ++findings[{finding.robot, finding.object}];
  Json objects = Json::array();
  for (const auto& object : system.objects()) {
    objects.push_back(
        {{"robot", object->robot},
         {"name", object->name},
         {"state", object->delivery().is_off() ? "off" : object->statistics().state()},
         {"messages", object->message_count()},
         {"per_s", objects_[object->id].per_s},
         {"waiting", object->waiting()},
         {"dropped", object->statistics().dropped_count()},
         {"waits_for", object->wait().why()},
         {"cost_us", static_cast<double>(object->statistics().handler_ns_max()) / 1000},
         {"findings", findings[{object->robot, object->name}]}});
  }
  return {{"time_s", InSeconds(system.now_us())},
          {"objects", objects},
          {"connections", ConnectionsJson()}};
}

// Returns the lines that objects have printed since the last call with this `cursor`, which says
// what a client has got already.
Json LiveEvents::Log(EventCursor* cursor) {
  const ConsoleLog& console = *context_.console;
  const size_t kept = console.lines().size();
  const uint64_t first = console.count() - kept;  // number of the oldest line in the log
  if (!std::exchange(cursor->has_console, true))
    cursor->console_lines = console.count() - std::min(kept, kFirstLines);
  Json lines = Json::array();
  for (uint64_t i = std::max(cursor->console_lines, first); i < console.count(); ++i) {
    const ConsoleLog::Line& line = console.lines()[i - first];
    lines.push_back({{"time_s", InSeconds(line.time_us)}, {"text", line.text}});
  }
  cursor->console_lines = console.count();
  return lines;
}

}  // namespace openr_host
