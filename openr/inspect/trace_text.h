// Writes a recorded run as text, as CSV and for the Perfetto viewer.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "openr/inspect/trace_file.h"

namespace openr_host {

// Converts a virtual time to seconds.
inline double Seconds(int64_t time_us) { return static_cast<double>(time_us) / 1e6; }

// The filter that chooses the messages to show.  A message must match all fields; an empty text
// matches all messages.
struct TraceFilter {
  std::string object;   // sender or receiver, by name
  std::string service;  // part of the name of the receiver's entry (handler of a message)
  int64_t from_us = 0;
  int64_t until_us = INT64_MAX;  // largest time of a message that is shown
  bool values = false;           // true: the content of messages is shown in words, too
};

using TextSink = std::function<void(std::string_view)>;

// Writes one line for each message that matches `filter`, and for each input from outside.
void WriteTraceText(TraceReader* reader, const TraceFilter& filter, const TextSink& out);

// Writes the messages that match `filter` as a CSV table, with a line of headings.  With
// `filter.values` the table has one column more, which has the whole content of each message on one
// line.
void WriteTraceCsv(TraceReader* reader, const TraceFilter& filter, const TextSink& out);

// Writes the messages that match `filter` as JSON events for ui.perfetto.dev: a process per robot,
// a track per object, a slice per handler, and an arrow from the handler that posted a message to
// the handler that received it.
void WriteTracePerfetto(TraceReader* reader, const TraceFilter& filter, const TextSink& out);

// Returns a line about a message: "4711 t=1.248000 JointMover -> OVirtualRobotComm ... 132 bytes".
std::string DescribeMessage(const TraceReader& reader, const TraceRecord& record);

}  // namespace openr_host
