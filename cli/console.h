// The console: what objects print, kept apart from what the program answers.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace openr_host {

// While it lives, descriptor 1 of the process is the console (standard error, or a file), so that
// whatever objects write there does not mix with the answer, which goes to StandardOutput().  A
// console that cannot be written any more takes what objects print all the same: it is lost.  One
// at a time.
class Console {
 public:
  // `file` empty: standard error.  Throws std::runtime_error when it cannot be opened or another
  // run writes it.
  explicit Console(const std::string& file);
  ~Console();  // descriptor 1 is what it was
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  // What objects print through the system.
  void Print(std::string_view text);

  // "FILE: cannot be written: why" when not all of it could be; "", as always for standard error.
  std::string Problem() const;

 private:
  const std::string file_;
  int saved_ = -1;  // the former descriptor 1
};

// What objects print goes out at once, a line that is not ended with an end of its own: something
// else is about to be said.
void EndConsoleLine();

}  // namespace openr_host
