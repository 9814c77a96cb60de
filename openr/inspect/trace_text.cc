#include "openr/inspect/trace_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <utility>

#include "cli/counted.h"
#include "cli/csv_field.h"
#include "cli/install_paths.h"
#include "openr/decode/decode_message.h"
#include "openr/timeline/timeline_writer.h"
#include "virtualrobot/model/robot_model.h"

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

// Returns the lines of `text`, each with eight blanks in front.
std::string Indented(const std::string& text) {
  std::string indented;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) indented += "        " + line + "\n";
  return indented;
}

// Returns the model of the recorded robot, which is needed to decode the content of messages;
// nullopt if the content is not shown.
std::optional<RobotModel> ModelForValues(const TraceReader& reader, const TraceFilter& filter) {
  if (!filter.values) return {};
  return LoadRobotModel(ModelFile(reader.header().robot));
}

// Returns the content of the recorded message `entry` in words.  Returns "" if `model` has no value
// or the recording does not have the content.
std::string WordsOf(const std::optional<RobotModel>& model, const TraceReader& reader,
                    const TraceEntry& entry) {
  if (!model || entry.payload.empty()) return "";
  return DecodeContent(*model, reader.EntryName(entry.record.target, entry.record.selector),
                       entry.payload);
}

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
  const std::optional<RobotModel> model = ModelForValues(*reader, filter);
  while (reader->Peek() != nullptr) {
    const TraceEntry entry = reader->Take();
    if (entry.kind == Kind::kMessage) {
      const TraceRecord& record = entry.record;
      if (!Shows(filter, *reader, record)) continue;
      out(DescribeMessage(*reader, record) + "\n");
      out(Indented(WordsOf(model, *reader, entry)));
    } else if (const std::string text = DescribeInput(entry); !text.empty()) {
      out(text + "\n");
    }
  }
}

void WriteTraceCsv(TraceReader* reader, const TraceFilter& filter, const TextSink& out) {
  const std::optional<RobotModel> model = ModelForValues(*reader, filter);
  out("number,cause,time_us,robot,sender,receiver,entry,selector,bytes,payload_hash");
  out(model ? ",said\n" : "\n");
  while (reader->Peek() != nullptr) {
    const TraceEntry entry = reader->Take();
    const TraceRecord& r = entry.record;
    if (entry.kind != Kind::kMessage || !Shows(filter, *reader, r)) continue;
    out(fmt::format("{},{},{},{},{},{},{},{},{},{:016x}", r.number, r.cause, r.time_us,
                    reader->RobotOf(r.target), CsvField(reader->ObjectName(r.sender)),
                    CsvField(reader->ObjectName(r.target)),
                    CsvField(reader->EntryName(r.target, r.selector)), r.selector, r.size,
                    r.payload_hash));
    // Does not cut the content, because programs read the table.
    if (model) out("," + CsvField(OneLineOf(WordsOf(model, *reader, entry), SIZE_MAX)));
    out("\n");
  }
}

void WriteTracePerfetto(TraceReader* reader, const TraceFilter& filter, const TextSink& out) {
  const std::optional<RobotModel> model = ModelForValues(*reader, filter);
  PerfettoWriter writer(out);
  double at_us = -1;  // virtual time at which the newest slice, a handled message, is drawn
  while (reader->Peek() != nullptr) {
    const TraceEntry entry = reader->Take();
    const TraceRecord& record = entry.record;
    if (entry.kind == Kind::kObject) writer.AddObject(entry.robot, entry.id, entry.name);
    if (entry.kind != Kind::kMessage || !Shows(filter, *reader, record)) continue;
    // Messages with the same virtual time would cover each other in the drawing.  So each of them
    // is drawn 1 us later than the message before.
    at_us = std::max(at_us + 1, static_cast<double>(record.time_us));
    HandlerSlice slice;
    slice.record = record;
    slice.robot = reader->RobotOf(record.target);
    slice.object = reader->ObjectName(record.target);
    slice.entry = reader->EntryName(record.target, record.selector);
    slice.sender = reader->ObjectName(record.sender);
    slice.at_us = at_us;
    slice.said = OneLineOf(WordsOf(model, *reader, entry));
    writer.AddSlice(slice);
  }
  writer.Finish();
}

}  // namespace openr_host
