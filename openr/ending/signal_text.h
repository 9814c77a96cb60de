// Builds text in signal handlers, where nothing may be allocated.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace openr_host {

struct Current;

class SignalText {
 public:
  SignalText& Add(std::string_view text);  // text that does not fit is cut off
  SignalText& AddNumber(uint64_t number, unsigned base = 10);

  // Writes the text to `descriptor`.
  void WriteTo(int descriptor) const;

  // Adds `text` as a JSON string.  Text that does not fit is cut off inside of the string.
  SignalText& AddQuoted(const SignalText& text);

  std::string_view text() const { return {text_, size_}; }

 private:
  char text_[4096];
  size_t size_ = 0;
};

// Adds a description of the handler that runs on this thread: "JointMover, NotifyMover (selector
// 7), message 4711, t=1248000 us".  Returns false, and adds nothing, if no handler runs.
bool AddCurrentHandler(SignalText* text);

// Adds only the entry of the handler that runs: "NotifyMover (selector 7)".  REQUIRES: a handler
// runs.
void AddCurrentEntry(SignalText* text);

// Writes the shortest report, because the state of the run may not be readable any more: {"error":
// record, "ended_by": ended_by, "findings": [...]} with one error about the handler that ran.  Does
// nothing if `descriptor` is negative.
void WriteEndingAsJson(const SignalText& record, const SignalText& finding, const char* ended_by,
                       const Current& current, int descriptor);

}  // namespace openr_host
