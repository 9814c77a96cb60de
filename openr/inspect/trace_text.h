// Shows a recorded run as text, as CSV and for the Perfetto viewer.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "openr/inspect/trace_file.h"

namespace openr_host {

// Returns virtual time in seconds.
inline double Seconds(int64_t time_us) { return static_cast<double>(time_us) / 1e6; }

// The messages to show; empty texts match all.
struct TraceFilter {
  std::string object;   // sender or receiver, by name
  std::string service;  // part of the entry's name
  int64_t from_us = 0;
  int64_t until_us = INT64_MAX;  // inclusive
};

using TextSink = std::function<void(std::string_view)>;

// Writes one line per message and per input.
void WriteTraceText(TraceReader* reader, const TraceFilter& filter, const TextSink& out);

// Writes the same table as CSV, with a line of headings.
void WriteTraceCsv(TraceReader* reader, const TraceFilter& filter, const TextSink& out);

// Writes trace events in JSON for ui.perfetto.dev: a process per robot, a track per object, a slice
// per handler, and an arrow from the handler that posted a message to the handler that got it.
void WriteTracePerfetto(TraceReader* reader, const TraceFilter& filter, const TextSink& out);

// Returns one line: "4711 t=1.248000 JointMover -> OVirtualRobotComm ...  132 bytes".
std::string DescribeMessage(const TraceReader& reader, const TraceRecord& record);

}  // namespace openr_host
