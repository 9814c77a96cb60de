// The console: the text that objects print, kept apart from the answer of the program.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace openr_host {

// While a Console exists, descriptor 1 of the process leads to the console (standard error, or a
// file), so that text that objects write there does not mix with the answer, which goes to
// StandardOutput().  If the console cannot be written any more, the text of objects is lost, and
// the objects see no error.  Only one Console may exist at a time.
class Console {
 public:
  // Opens `file`, or uses standard error if `file` is empty.  Throws std::runtime_error when the
  // file cannot be opened or another run writes to it.
  explicit Console(const std::string& file);
  ~Console();  // makes descriptor 1 what it was before
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  // Writes text that an object prints through the system.
  void Print(std::string_view text);

  // Returns "FILE: cannot be written: why" if some text was lost; "" otherwise, and always for
  // standard error.
  std::string Problem() const;

 private:
  const std::string file_;
  int saved_ = -1;  // copy of the descriptor 1 of before
};

// Writes out what objects have printed, and ends a line that they have left open, because the
// program is about to print a line of its own.
void EndConsoleLine();

}  // namespace openr_host
