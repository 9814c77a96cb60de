#include "openr/timeline/timeline_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "cli/json_text.h"

namespace openr_host {
namespace {

// The least length of a slice in the drawing of a timeline.  Shorter slices are drawn with this
// length, because a slice of length 0 could not be seen, and no arrow could end at it.
constexpr double kSliceUs = 0.8;

constexpr size_t kPlacesMax = 100'000;

}  // namespace

PerfettoWriter::PerfettoWriter(Sink out) : out_(std::move(out)) {
  out_("{\"displayTimeUnit\":\"ms\",\"traceEvents\":[\n");
}

void PerfettoWriter::Finish() { out_(kEnd); }

void PerfettoWriter::AddObject(int robot, int32_t id, const std::string& name) {
  Emit({{"ph", "M"},
        {"name", "process_name"},
        {"pid", robot + 1},
        {"tid", 0},
        {"args", {{"name", fmt::format("robot {}", robot)}}}});
  Emit({{"ph", "M"},
        {"name", "thread_name"},
        {"pid", robot + 1},
        {"tid", id + 1},
        {"args", {{"name", name}}}});
}

void PerfettoWriter::AddSlice(const HandlerSlice& slice) {
  const int pid = slice.robot + 1;
  const int tid = slice.record.target + 1;
  nlohmann::ordered_json args = {
      {"message", slice.record.number},
      {"cause", slice.record.cause},
      {"from", slice.sender},
      {"bytes", slice.record.size},
      {"payload_hash", fmt::format("{:016x}", slice.record.payload_hash)},
      {"virtual_time_s", static_cast<double>(slice.record.time_us) / 1e6}};
  if (!slice.said.empty()) args["said"] = slice.said;
  if (slice.length == HandlerSlice::Length::kCost) args["cost_us"] = slice.length_us;
  if (slice.length == HandlerSlice::Length::kWall) args["wall_us"] = slice.length_us;
  Emit({{"ph", "X"},
        {"name", slice.entry},
        {"pid", pid},
        {"tid", tid},
        {"ts", slice.at_us},
        {"dur", std::max(slice.length_us, kSliceUs)},
        {"args", std::move(args)}});
  AddArrow(slice, pid, tid);
  places_[slice.record.number] = {pid, tid, slice.at_us};
  if (places_.size() > kPlacesMax) places_.erase(places_.begin());
}

void PerfettoWriter::AddArrow(const HandlerSlice& slice, int pid, int tid) {
  const auto from = places_.find(slice.record.cause);
  if (from == places_.end()) return;
  const Place& place = from->second;
  Emit({{"ph", "s"},
        {"id", slice.record.number},
        {"name", "message"},
        {"cat", "message"},
        {"pid", place.pid},
        {"tid", place.tid},
        {"ts", place.at + kSliceUs / 2}});
  Emit({{"ph", "f"},
        {"bp", "e"},
        {"id", slice.record.number},
        {"name", "message"},
        {"cat", "message"},
        {"pid", pid},
        {"tid", tid},
        {"ts", slice.at_us + kSliceUs / 4}});
}

void PerfettoWriter::Emit(const nlohmann::ordered_json& event) {
  out_((is_first_ ? "" : ",\n") + JsonText(event));
  is_first_ = false;
}

}  // namespace openr_host
