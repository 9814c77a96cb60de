// CtfWriter: writes a timeline in the Common Trace Format (CTF 1.8, diamon.org/ctf), which
// babeltrace2 and Trace Compass read.
#pragma once

#include <memory>
#include <queue>
#include <string>
#include <vector>

#include "cli/growing_file.h"
#include "openr/timeline/timeline_writer.h"

namespace openr_host {

// Writes a trace in the Common Trace Format, a folder with two files.  `metadata` describes the
// events.  `handlers` has the events, in order of time: when each handler began and when it ended.
class CtfWriter : public TimelineWriter {
 public:
  // Makes `folder`, the folder of a trace in the Common Trace Format.  Throws std::runtime_error
  // when the folder or its files cannot be written.
  explicit CtfWriter(const std::string& folder);
  void AddObject(int, int32_t, const std::string&) override {}
  void AddSlice(const HandlerSlice& slice) override;
  void Finish() override;
  std::string Problem() const { return events_->Problem(); }

 private:
  struct End {
    uint64_t time_ns;
    uint64_t message;
    std::string bytes;
    // Orders the ends of handlers so that the queue ends_ returns the earliest end first.
    bool operator<(const End& other) const {
      return time_ns != other.time_ns ? time_ns > other.time_ns : message > other.message;
    }
  };

  void WriteEndsUntil(uint64_t time_ns);
  void Add(const std::string& event);
  void Flush();

  std::unique_ptr<GrowingFile> events_;
  std::priority_queue<End> ends_;  // ends of handlers whose beginning was already written
  std::string bytes_;              // events that are not in the file yet
};

}  // namespace openr_host
