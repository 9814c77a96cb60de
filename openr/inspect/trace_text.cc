#include "openr/inspect/trace_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "cli/counted.h"
#include "cli/json_text.h"

namespace openr_host {
namespace {

using Kind = TraceEntry::Kind;

bool Shows(const TraceFilter& filter, const TraceReader& reader, const TraceRecord& record) {
  if (record.time_us < filter.from_us || record.time_us > filter.until_us) return false;
  if (!filter.object.empty() && reader.ObjectName(record.sender) != filter.object &&
      reader.ObjectName(record.target) != filter.object) {
    return false;
  }
  return reader.EntryName(record.target, record.selector).find(filter.service) != std::string::npos;
}

const char* EventName(NetworkEvent::Kind kind) {
  static const char* const kNames[] = {"accepted", "connected", "sent",     "received", "end",
                                       "closed",   "datagram",  "resolved", "failed",   "note"};
  return kNames[static_cast<int>(kind)];
}

// Returns `text` on one line, because typed text may have several lines.
std::string OnOneLine(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

std::string DescribeInput(const TraceEntry& entry) {
  switch (entry.kind) {
    case Kind::kNetwork: {
      std::string text = fmt::format("    input: network of robot {}:", entry.robot);
      for (const NetworkEvent& event : entry.events) {
        text += fmt::format(" {} {}", EventName(event.kind), event.handle);
        if (!event.bytes.empty()) text += fmt::format(" ({})", Counted(event.bytes.size(), "byte"));
      }
      return text;
    }
    case Kind::kInput:
      return fmt::format("    input: {} at t={:.6f}: {}",
                         entry.robot < 0 ? "every robot" : fmt::format("robot {}", entry.robot),
                         Seconds(entry.time_us), OnOneLine(entry.name));
    case Kind::kLoss:
      return fmt::format("    loss: process '{}' at t={:.6f}", entry.name, Seconds(entry.time_us));
    case Kind::kEnded:
      return fmt::format("ended by {}: {}", entry.name, entry.payload);
    case Kind::kEnd:
      return fmt::format("end at t={:.6f}: trace {:016x}, state {:016x}", Seconds(entry.time_us),
                         entry.trace_hash, entry.state_hash);
    default:
      return "";
  }
}

// Returns `text` as a field of a CSV table: in quotes if it has a comma, a quote or a newline.
std::string Field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

// Length of a slice, the bar that the Perfetto viewer draws for a handler.  The recording does not
// say how long handlers took, but a slice of length 0 could not be seen, and no arrow could end at
// it.  AddMessage() draws messages with the same time 1 us apart, so these slices do not overlap.
constexpr double kSliceUs = 0.8;

class PerfettoWriter {
 public:
  PerfettoWriter(const TraceReader& reader, const TextSink& out) : reader_(reader), out_(out) {
    out_("{\"displayTimeUnit\":\"ms\",\"traceEvents\":[\n");
  }
  ~PerfettoWriter() { out_("\n]}\n"); }

  void NameObject(const TraceEntry& entry) {
    Emit({{"ph", "M"},
          {"name", "process_name"},
          {"pid", entry.robot + 1},
          {"tid", 0},
          {"args", {{"name", fmt::format("robot {}", entry.robot)}}}});
    Emit({{"ph", "M"},
          {"name", "thread_name"},
          {"pid", entry.robot + 1},
          {"tid", entry.id + 1},
          {"args", {{"name", entry.name}}}});
  }

  void AddMessage(const TraceRecord& record) {
    // Messages with the same virtual time would cover each other in the drawing.  So each of them
    // is drawn 1 us later than the one before, and no message is drawn before an earlier one.
    at_ = record.time_us == instant_us_ ? at_ + 1 : static_cast<double>(record.time_us);
    instant_us_ = record.time_us;
    if (at_ < last_) at_ = last_;
    last_ = at_;
    const int pid = reader_.RobotOf(record.target) + 1;
    const int tid = record.target + 1;
    Emit({{"ph", "X"},
          {"name", reader_.EntryName(record.target, record.selector)},
          {"pid", pid},
          {"tid", tid},
          {"ts", at_},
          {"dur", kSliceUs},
          {"args",
           {{"message", record.number},
            {"cause", record.cause},
            {"from", reader_.ObjectName(record.sender)},
            {"bytes", record.size},
            {"payload_hash", fmt::format("{:016x}", record.payload_hash)}}}});
    AddArrow(record, pid, tid);
    places_[record.number] = {pid, tid, at_};
    if (places_.size() > kPlacesMax) places_.erase(places_.begin());
  }

 private:
  struct Place {
    int pid, tid;
    double at;
  };
  static constexpr size_t kPlacesMax = 100'000;

  void AddArrow(const TraceRecord& record, int pid, int tid) {
    const auto from = places_.find(record.cause);
    if (from == places_.end()) return;
    const Place& place = from->second;
    Emit({{"ph", "s"},
          {"id", record.number},
          {"name", "message"},
          {"cat", "message"},
          {"pid", place.pid},
          {"tid", place.tid},
          {"ts", place.at + kSliceUs / 2}});
    Emit({{"ph", "f"},
          {"bp", "e"},
          {"id", record.number},
          {"name", "message"},
          {"cat", "message"},
          {"pid", pid},
          {"tid", tid},
          {"ts", at_ + kSliceUs / 4}});
  }

  void Emit(const nlohmann::ordered_json& event) {
    out_((is_first_ ? "" : ",\n") + JsonText(event));
    is_first_ = false;
  }

  const TraceReader& reader_;
  const TextSink& out_;
  bool is_first_ = true;
  int64_t instant_us_ = -1;
  double at_ = 0, last_ = 0;
  std::map<uint64_t, Place> places_;
};

}  // namespace

std::string DescribeMessage(const TraceReader& reader, const TraceRecord& record) {
  const std::string robot =
      reader.header().robots == 1 ? "" : fmt::format("robot {} ", reader.RobotOf(record.target));
  return fmt::format("{:>7} t={:.6f} {}{} -> {} \"{}\" {}, cause {}, hash {:016x}", record.number,
                     Seconds(record.time_us), robot, reader.ObjectName(record.sender),
                     reader.ObjectName(record.target),
                     reader.EntryName(record.target, record.selector), Counted(record.size, "byte"),
                     record.cause, record.payload_hash);
}

void WriteTraceText(TraceReader* reader, const TraceFilter& filter, const TextSink& out) {
  while (reader->Peek() != nullptr) {
    const TraceEntry entry = reader->Take();
    if (entry.kind == Kind::kMessage) {
      if (Shows(filter, *reader, entry.record)) out(DescribeMessage(*reader, entry.record) + "\n");
    } else if (const std::string text = DescribeInput(entry); !text.empty()) {
      out(text + "\n");
    }
  }
}

void WriteTraceCsv(TraceReader* reader, const TraceFilter& filter, const TextSink& out) {
  out("number,cause,time_us,robot,sender,receiver,entry,selector,bytes,payload_hash\n");
  while (reader->Peek() != nullptr) {
    const TraceEntry entry = reader->Take();
    const TraceRecord& r = entry.record;
    if (entry.kind != Kind::kMessage || !Shows(filter, *reader, r)) continue;
    out(fmt::format("{},{},{},{},{},{},{},{},{},{:016x}\n", r.number, r.cause, r.time_us,
                    reader->RobotOf(r.target), Field(reader->ObjectName(r.sender)),
                    Field(reader->ObjectName(r.target)),
                    Field(reader->EntryName(r.target, r.selector)), r.selector, r.size,
                    r.payload_hash));
  }
}

void WriteTracePerfetto(TraceReader* reader, const TraceFilter& filter, const TextSink& out) {
  PerfettoWriter writer(*reader, out);
  while (reader->Peek() != nullptr) {
    const TraceEntry entry = reader->Take();
    if (entry.kind == Kind::kObject) writer.NameObject(entry);
    if (entry.kind == Kind::kMessage && Shows(filter, *reader, entry.record))
      writer.AddMessage(entry.record);
  }
}

}  // namespace openr_host
