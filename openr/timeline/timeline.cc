#include "openr/timeline/timeline.h"

#include <fmt/format.h>

#include <algorithm>

#include "openr/decode/decode_message.h"
#include "openr/timeline/ctf_writer.h"
#include "runtime/base/wall_clock.h"
#include "runtime/core/dispatcher.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

constexpr size_t kJsonFlushBytes = 64 << 10;

}  // namespace

std::string TimelineNameProblem(const std::string& file) {
  if (file.ends_with(".json") || file.ends_with(".ctf")) return "";
  return fmt::format("{}: the name of a timeline ends in .json (for Perfetto) or .ctf (a folder)",
                     file);
}

Timeline::Timeline(const std::string& file, System* system) : system_(system) {
  if (file.ends_with(".ctf")) {
    auto ctf = std::make_unique<CtfWriter>(file);
    ctf_ = ctf.get();
    writer_ = std::move(ctf);
  } else {
    json_ = std::make_unique<GrowingFile>(file);
    writer_ = std::make_unique<PerfettoWriter>([this](std::string_view text) { Print(text); });
    FlushJson();  // writes the file now, so that a run that is killed soon leaves a valid file
  }
  sink_ = system->trace().AddSink(
      [this](const TraceRecord& record, const Message& message) { Deliver(record, message); });
}

Timeline::~Timeline() { system_->trace().RemoveSink(sink_); }

void Timeline::Print(std::string_view text) {
  text_ += text;
  if (text_.size() >= kJsonFlushBytes || is_finished_) FlushJson();
}

void Timeline::FlushJson() {
  json_->Append(text_, is_finished_ ? "" : PerfettoWriter::kEnd);
  text_.clear();
}

void Timeline::NameObject(const Object* object) {
  if (object == nullptr || !known_.insert({object->id, object->predecessors()}).second) return;
  writer_->AddObject(object->robot, object->id, object->name);
}

// Returns the processor time that the cost file gives the handler of `message`.  Returns nullopt if
// there is no cost file.  Also returns nullopt for a message to a system object (a part of the
// robot) and for a reply, because handling them takes no processor time.
std::optional<double> Timeline::CostOf(const Object& object, const Message& message) const {
  if (system_->dispatcher().cpus().empty() || object.is_system() || message.is_reply) return {};
  if (!object.delivery().is_busy()) return 0;
  const Cpu& cpu = *system_->dispatcher().cpus()[static_cast<size_t>(object.robot)];
  return static_cast<double>(cpu.EndUs() - system_->now_us());
}

// Begins the slice of the timeline for the handler that gets `message` now.  First ends the slice
// of the previous handler.
void Timeline::Deliver(const TraceRecord& record, const Message& message) {
  EndSlice();
  const Object* const object = system_->object(record.target);
  if (object == nullptr || is_finished_) return;
  NameObject(object);
  HandlerSlice slice;
  slice.record = record;
  slice.robot = object->robot;
  slice.object = object->name;
  slice.entry = object->EntryName(record.selector);
  const Object* const sender = system_->object(record.sender);
  slice.sender = sender == nullptr ? "(system)" : sender->name;
  slice.said = OneLineOf(DecodeHandled(*system_, message));
  slice.at_us = static_cast<double>(record.time_us);
  if (const std::optional<double> cost_us = CostOf(*object, message)) {
    slice.length = HandlerSlice::Length::kCost;
    slice.length_us = *cost_us;
  }
  running_ = std::move(slice);
  // Reads the clock last, because the work of this function must not count as time of the handler.
  begin_ns_ = WallClockNs();
}

void Timeline::EndSlice() {
  const int64_t now_ns = WallClockNs();
  if (!running_) return;
  HandlerSlice& slice = *running_;
  if (slice.length == HandlerSlice::Length::kUnknown) {
    slice.length = HandlerSlice::Length::kWall;
    slice.length_us = static_cast<double>(now_ns - begin_ns_) / 1e3;
  }
  // Without a cost file, draws handlers that run at the same virtual time one after the other, in
  // the order in which this computer ran them.  With a cost file this is not needed, because the
  // processor of a robot then runs handlers one after the other in virtual time.
  if (system_->dispatcher().cpus().empty()) {
    slice.at_us = std::max(slice.at_us, free_us_);
    free_us_ = slice.at_us + slice.length_us;
  }
  writer_->AddSlice(slice);
  running_.reset();
}

void Timeline::Rest() { EndSlice(); }

std::string Timeline::Finish() {
  if (!is_finished_) {
    EndSlice();
    is_finished_ = true;
    writer_->Finish();
  }
  return ctf_ != nullptr ? ctf_->Problem() : json_->Problem();
}

}  // namespace openr_host
