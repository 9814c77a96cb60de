// Builds text in signal handlers, which may not allocate memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace openr_host {

struct Current;

class SignalText {
 public:
  SignalText& Add(std::string_view text);  // appends `text`; cuts off the part that does not fit
  SignalText& AddNumber(uint64_t number, unsigned base = 10);

  // Writes the collected text to the file descriptor `descriptor`.
  void WriteTo(int descriptor) const;

  // Adds `text` as a JSON string.  If `text` is too long, leaves out its end, but still closes the
  // JSON string.
  SignalText& AddQuoted(const SignalText& text);

  std::string_view text() const { return {text_, size_}; }

 private:
  char text_[4096];
  size_t size_ = 0;
};

// Adds a description of the object, and of the object's handler, that run on this thread, such as
// "JointMover, NotifyMover (selector 7), message 4711, t=1248000 us".  Returns false, and adds
// nothing, if no object runs.
bool AddCurrentHandler(SignalText* text);

// Adds a line about the message that is being handled on this thread: its kind, its sender and its
// number of bytes, such as "MESSAGE notification from RCServer, 84 bytes".  A message of kind
// PayloadKind::kBytes is printed without a kind.  The sender is left out if the runtime may be
// changing its table of objects.  Adds nothing if no message is handled.  Does not add the values
// in the message, because making text of them allocates memory.  The finding about the crash has
// them (Finding::said).
void AddCurrentMessage(SignalText* text);

// Adds less than AddCurrentHandler(): only the name and the number (selector) of the object's
// handler that runs, "NotifyMover (selector 7)".  REQUIRES: an object runs.
void AddCurrentEntry(SignalText* text);

// Writes a short report of a run that has ended early: {"error": record, "ended_by": ended_by,
// "findings": [...]}, with one error about the handler that ran.  Longer reports need the state of
// the run, which may be damaged after a crash.  Writes nothing if `descriptor` is negative.
void WriteEndingAsJson(const SignalText& record, const SignalText& finding, const char* ended_by,
                       const Current& current, int descriptor);

}  // namespace openr_host
