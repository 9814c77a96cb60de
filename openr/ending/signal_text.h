// Text put together where nothing may be allocated: in signal handlers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace openr_host {

struct Current;

class SignalText {
 public:
  SignalText& Add(std::string_view text);  // what does not fit is left out
  SignalText& AddNumber(uint64_t number, unsigned base = 10);

  // Writes it to `descriptor`.
  void WriteTo(int descriptor) const;

  // Adds `text` as a string of JSON; what does not fit is left out of the string.
  SignalText& AddQuoted(const SignalText& text);

  std::string_view text() const { return {text_, size_}; }

 private:
  char text_[4096];
  size_t size_ = 0;
};

// "JointMover, NotifyMover (selector 7), message 4711, t=1248000 us" of the handler that runs on
// this thread.  False, and nothing added, when there is none.
bool AddCurrentHandler(SignalText* text);

// "NotifyMover (selector 7)" of it; REQUIRES: there is one.
void AddCurrentEntry(SignalText* text);

// Writes the shortest report, for a run whose state cannot be read any more: {"error": record,
// "ended_by": ended_by, "findings": [...]} with one error, about the handler that ran.  Does
// nothing when `descriptor` is negative.
void WriteEndingAsJson(const SignalText& record, const SignalText& finding, const char* ended_by,
                       const Current& current, int descriptor);

}  // namespace openr_host
