// The console: what objects print, kept apart from what the program answers.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

namespace openr_host {

// While it lives, descriptor 1 of the process is the console (standard error, or a file), so that
// whatever objects write there does not mix with the answer.  One at a time.
class Console {
 public:
  // `file` empty: standard error.  Throws std::runtime_error when it cannot be opened.
  explicit Console(const std::string& file);
  ~Console();  // descriptor 1 is what it was
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  // What objects print through the system.
  void Print(std::string_view text);

  // To the standard output the program was started with.
  void Answer(std::string_view text);
  int answer_descriptor() const { return saved_; }

 private:
  int saved_ = -1;  // the former descriptor 1
};

// What objects print goes out at once, a line that is not ended with an end of its own: something
// else is about to be said.
void EndConsoleLine();

// Writes all of `text` to `descriptor`; what cannot be written is lost.
void WriteAll(int descriptor, std::string_view text);

}  // namespace openr_host
