// A recorded run for people and for other programs.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "openr/inspect/trace_file.h"

namespace openr_host {

// Virtual time in seconds, for texts.
inline double Seconds(int64_t time_us) { return static_cast<double>(time_us) / 1e6; }

// Which messages are shown; empty texts match all.
struct TraceFilter {
  std::string object;   // sender or receiver, by name
  std::string service;  // part of the entry's name
  int64_t from_us = 0;
  int64_t until_us = INT64_MAX;  // inclusive
};

using TextSink = std::function<void(std::string_view)>;

// One line a message and one an input.
void WriteTraceText(TraceReader* reader, const TraceFilter& filter, const TextSink& out);

// The same table with a line of headings.
void WriteTraceCsv(TraceReader* reader, const TraceFilter& filter, const TextSink& out);

// Trace events as JSON, as ui.perfetto.dev opens them: a process a robot, a track an object, a
// slice a handler, an arrow from the handler that posted a message to the one it ran.
void WriteTracePerfetto(TraceReader* reader, const TraceFilter& filter, const TextSink& out);

// One line: "4711 t=1.248000 JointMover -> OVirtualRobotComm ... 132 bytes".
std::string DescribeMessage(const TraceReader& reader, const TraceRecord& record);

}  // namespace openr_host
