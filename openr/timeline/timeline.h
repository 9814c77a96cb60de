// Timeline: writes when the handlers of a run have run, and how long (--timeline).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "cli/growing_file.h"
#include "openr/timeline/timeline_writer.h"

namespace openr_host {

class CtfWriter;
class Object;
class System;
struct Message;

// Returns the reason why `file` cannot be the name of a timeline; "" if it can.  A name is
// FILE.json, for Perfetto, or FOLDER.ctf.
std::string TimelineNameProblem(const std::string& file);

// Writes a timeline with a slice for each handler that runs.  The length of a slice is the
// processor time that the cost file gives the handler.  Without a cost file, it is the time that
// the handler took on this computer.
class Timeline {
 public:
  // Creates `file`, and adds all handlers that run from now on.  Throws std::runtime_error when the
  // file cannot be written.
  Timeline(const std::string& file, System* system);
  ~Timeline();
  Timeline(const Timeline&) = delete;
  Timeline& operator=(const Timeline&) = delete;

  // Ends the slice of the timeline for the last handler.  Called before the run waits, for example
  // for the clock, so that the wait does not count as time of the handler.
  void Rest();

  // Completes the file of the timeline.  Returns "", or the error that happened while the file was
  // written.
  std::string Finish();

 private:
  void Deliver(const TraceRecord& record, const Message& message);
  void EndSlice();
  void NameObject(const Object* object);
  std::optional<double> CostOf(const Object& object, const Message& message) const;
  void Print(std::string_view text);
  void FlushJson();

  System* const system_;
  std::unique_ptr<GrowingFile> json_;  // file of a JSON timeline; null: the timeline is in CTF
  std::string text_;                   // JSON that is not in the file yet
  std::unique_ptr<TimelineWriter> writer_;
  CtfWriter* ctf_ = nullptr;  // the writer, if the timeline is in CTF; null: it is JSON
  int sink_ = 0;
  std::optional<HandlerSlice> running_;  // slice of the handler that runs
  // The time at which the handler that runs (`running_`) began, by the clock of this computer.
  int64_t begin_ns_ = 0;
  // The end of the last slice of the timeline that has wall time as its length.  The next such
  // slice begins at this time or later, so that the two slices do not overlap.
  double free_us_ = 0;
  // Objects whose names are already in the timeline: the id, and how many objects had this id
  // before (Object::predecessors).
  std::set<std::pair<int32_t, int>> known_;
  bool is_finished_ = false;
};

}  // namespace openr_host
