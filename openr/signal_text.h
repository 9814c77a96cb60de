// Text put together where nothing may be allocated: in signal handlers.
#pragma once

#include <cstddef>
#include <cstdint>

namespace openr_host {

class SignalText {
 public:
  SignalText& Add(const char* text);  // what does not fit is left out
  SignalText& AddNumber(uint64_t number, unsigned base = 10);

  // Writes it to `descriptor`.
  void WriteTo(int descriptor) const;

  // The same as the answer of a run with --json: {"error": text}.  Nothing when `descriptor` is
  // negative.
  void WriteAsJsonTo(int descriptor) const;

 private:
  char text_[1024];
  size_t size_ = 0;
};

// "JointMover, NotifyMover (selector 7), message 4711, t=1248000 us" of the handler that runs on
// this thread.  False, and nothing added, when there is none.
bool AddCurrentHandler(SignalText* text);

}  // namespace openr_host
