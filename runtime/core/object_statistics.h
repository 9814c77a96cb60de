// ObjectStatistics: facts about an object for the report of the run.  They change nothing in the
// run itself.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

namespace openr_host {

class ObjectStatistics {
 public:
  // Returns the text after "state: " in the last INFO line that the object has printed with
  // OSYSLOG1.
  const std::string& state() const { return state_; }
  void set_state(std::string state) { state_ = std::move(state); }

  // Returns how many data and messages were lost: data that newer data replaced or that were
  // dropped for another reason, and messages that were refused or could not be delivered.
  uint64_t dropped_count() const { return dropped_count_; }
  void NoteDropped(uint64_t count = 1) { dropped_count_ += count; }

  // Returns the wall time of the longest handler; 0 without SystemOptions::wall_clock_ns.
  int64_t handler_ns_max() const { return handler_ns_max_; }
  void NoteHandler(int64_t ns) { handler_ns_max_ = std::max(handler_ns_max_, ns); }

  // Returns the most stack bytes that a handler has used; see SystemOptions::measure_stacks.
  size_t stack_max() const { return stack_max_; }
  void set_stack_max(size_t bytes) { stack_max_ = bytes; }

  // Copies the facts of `old`, the object that this object replaces, because the report counts both
  // objects as one.  Does not copy the state, which the new object has not printed.
  void Succeed(const ObjectStatistics& old) {
    dropped_count_ = old.dropped_count_;
    handler_ns_max_ = old.handler_ns_max_;
    stack_max_ = old.stack_max_;
  }

 private:
  std::string state_;
  uint64_t dropped_count_ = 0;
  int64_t handler_ns_max_ = 0;
  size_t stack_max_ = 0;
};

}  // namespace openr_host
