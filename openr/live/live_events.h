// The events of a run: lines that the run sends by itself to a client that watches the run.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "openr/live/live_context.h"

namespace openr_host {

// The events (lines about the state of the run) that a client has got already.
struct EventCursor {
  uint64_t console_lines = 0;
  // True: the client has got the lines that objects had printed before it began to watch the run.
  bool has_console = false;
  uint64_t findings = UINT64_MAX;
  // The version of the run's state (LiveEvents::Version()) that the client got last, for each kind
  // of event; the key is the name of the kind.
  std::map<std::string, uint64_t> versions;
};

class LiveEvents {
 public:
  struct Kind {
    const char* name;
    // Least time between two events of this kind for a client; the client may ask for a longer
    // time.
    int64_t interval_ns;
  };
  // Returns all kinds of events, such as "clock", in the order in which the events are sent.
  static const std::vector<Kind>& Kinds();

  explicit LiveEvents(const LiveContext& context) : context_(context) {}

  // Returns the event of the kind `name`, such as "clock", as one line without its line end.  The
  // event describes the present state of the run or, while clients look at an earlier moment of the
  // run, the state at that moment.  Returns "" if `cursor` says that the client has got this event
  // already.
  std::string Line(std::string_view name, EventCursor* cursor);

  // Begins or stops keeping the messages of connections.  `is_watched` says that a client watches
  // the event "graph", which shows these messages.
  void WatchGraph(bool is_watched);

  // Returns the number of robots of the run.
  int robot_count() const;

  // Returns the state of the clock: virtual time, messages, pause, wanted rate and measured speed.
  nlohmann::ordered_json Clock();

 private:
  struct Rate {
    uint64_t count = 0;
    double per_s = 0;
  };

  std::string LineOfPast(std::string_view name, EventCursor* cursor);
  uint64_t Version() const;
  void UpdateRates();
  void UpdateSpeed();
  nlohmann::ordered_json Graph();
  nlohmann::ordered_json ConnectionsJson();
  nlohmann::ordered_json Log(EventCursor* cursor);

  const LiveContext context_;
  int64_t rates_us_ = 0;  // virtual time at which the rates were computed
  // Number and rate of the messages that each object has received; key: id of the object.
  std::map<int, Rate> objects_;
  // Number and rate of the messages of each connection; key: index in System::connections().
  std::map<size_t, Rate> connections_;
  // The time of this computer's clock when the speed of the run, speed_, was measured last.
  int64_t speed_ns_ = 0;
  // The virtual time when the speed of the run, speed_, was measured last.
  int64_t speed_us_ = 0;
  double speed_ = 0;  // virtual seconds per second
};

// Returns the findings of the run, as the answer to the request "findings".
nlohmann::ordered_json FindingsJson(const LiveContext& context);

// Returns the identifier of a connection: "0:SUBJECT>OBSERVER", where 0 is the number of the robot.
std::string ConnectionName(int robot, const std::string& subject, const std::string& observer);

}  // namespace openr_host
