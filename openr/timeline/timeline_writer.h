// TimelineWriter: writes the handlers of a run as slices of time, for programs that show timelines.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "runtime/core/trace.h"

namespace openr_host {

// A handler that has run, as a slice of the timeline.
struct HandlerSlice {
  enum class Length {
    kUnknown,  // the length is not known, because a recording does not say how long a handler took
    kCost,     // the length is processor time of the robot, from the cost file
    kWall,     // the length is time by the clock of this computer
  };
  TraceRecord record{};
  int robot = 0;  // number of the robot that has the object
  std::string object, entry, sender;
  std::string said;      // content of the message in words; "": the content is not shown
  double at_us = 0;      // time on the timeline at which the handler began
  double length_us = 0;  // length of the slice; 0 if it is unknown
  Length length = Length::kUnknown;
};

class TimelineWriter {
 public:
  virtual ~TimelineWriter() = default;
  // Gives the object `id` a name in the timeline.  Called before the object's first slice.
  virtual void AddObject(int robot, int32_t id, const std::string& name) = 0;
  // Adds a slice to the timeline.  Must be called in the order in which the slices begin.
  virtual void AddSlice(const HandlerSlice& slice) = 0;
  // Writes the end of the timeline.
  virtual void Finish() = 0;
};

// Writes JSON for ui.perfetto.dev: a process per robot, a track per object, a slice per handler,
// and an arrow from the handler that posted a message to the handler that received it.
class PerfettoWriter : public TimelineWriter {
 public:
  using Sink = std::function<void(std::string_view text)>;
  static constexpr std::string_view kEnd = "\n]}\n";  // text that completes the JSON written so far
  explicit PerfettoWriter(Sink out);
  void AddObject(int robot, int32_t id, const std::string& name) override;
  void AddSlice(const HandlerSlice& slice) override;
  void Finish() override;

 private:
  // The place in the drawing of the timeline at which a slice, the bar of one run of a handler,
  // begins.  The arrows of the messages that this handler has posted begin here.
  struct Place {
    int pid, tid;
    double at;
  };

  void AddArrow(const HandlerSlice& slice, int pid, int tid);
  void Emit(const nlohmann::ordered_json& event);

  const Sink out_;
  bool is_first_ = true;
  std::map<uint64_t, Place> places_;  // key: number of the message whose handler has the slice
};

}  // namespace openr_host
