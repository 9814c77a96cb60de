// The events of a run: lines that the run sends unasked to a client that watches it.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "openr/live/live_context.h"

namespace openr_host {

// What one client has been sent.
struct EventCursor {
  uint64_t console_lines = 0;
  bool has_console = false;  // the client got the lines from before it watched
  uint64_t findings = UINT64_MAX;
  std::map<std::string, uint64_t> versions;  // by event: the version of the run that it showed
};

class LiveEvents {
 public:
  struct Kind {
    const char* name;
    int64_t interval_ns;  // least time between two such events; a client may ask for a longer time
  };
  // The events, in the order in which they are sent.
  static const std::vector<Kind>& Kinds();

  explicit LiveEvents(const LiveContext& context) : context_(context) {}

  // Returns the event `name` of the run as it is at the moment that is shown, as one line without
  // its end.  Returns "" if `cursor` says that the client knows everything already.
  std::string Line(std::string_view name, EventCursor* cursor);

  // Called with whether any client watches the event "graph".  As long as one does, the messages of
  // connections are kept.
  void WatchGraph(bool is_watched);

  // Returns the state of the clock: virtual time, messages, pause, rate and measured speed.
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
  int64_t rates_us_ = 0;                // virtual time at which the rates were computed
  std::map<int, Rate> objects_;         // messages that objects have received, by object
  std::map<size_t, Rate> connections_;  // messages, by index in System::connections()
  // Values at the last update of speed_: the clock of this computer and the virtual time.
  int64_t speed_ns_ = 0;
  int64_t speed_us_ = 0;
  double speed_ = 0;  // virtual seconds per second
};

// Returns the findings of the run, as the request "findings" has them.
nlohmann::ordered_json FindingsJson(const LiveContext& context);

// Returns the identifier of a connection: "0:SUBJECT>OBSERVER".
std::string ConnectionName(int robot, const std::string& subject, const std::string& observer);

}  // namespace openr_host
