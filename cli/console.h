// The console is the stream on which the text of objects is shown.  This text is kept apart from
// the answer, which is the text that the program itself prints on standard output.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace openr_host {

// While a Console exists, descriptor 1 of the process leads to the console (standard error, or a
// file).  So text that objects write to descriptor 1 does not mix with the answer of the program,
// which goes to StandardOutput().  If the console can no longer be written, the text of objects is
// lost, and the objects see no error.  Only one Console may exist at a time.
class Console {
 public:
  // Opens `file` as the console, or uses standard error if `file` is empty.  Throws
  // std::runtime_error when the file cannot be opened or another run writes to it.
  explicit Console(const std::string& file);
  ~Console();  // makes descriptor 1 lead to the same stream as before
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  // Writes text that an object prints through the runtime, as with OSYSPRINT(), or that the
  // runtime prints itself.  Text of printf() goes to descriptor 1 without this function.
  void Print(std::string_view text);

  // Returns "FILE: cannot be written: why" if some text for the console was lost, else "".  Always
  // returns "" if the console is standard error, because a command does not fail when its text on
  // standard error is lost.
  std::string Problem() const;

 private:
  const std::string file_;
  int saved_ = -1;  // copy of descriptor 1, made before this Console took descriptor 1; -1: no copy
};

// Writes out what objects have printed, and ends their last line if it has no end.  Called before
// the program prints a line, so that this line does not begin in the middle of an object's line.
void EndConsoleLine();

}  // namespace openr_host
