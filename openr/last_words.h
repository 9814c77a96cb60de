// What is still to be done when an object brings the process down.
#pragma once

#include <functional>

namespace openr_host {

// While it lives: CrashLog and Watchdog call `say` before they end the process.  It runs in a
// signal handler, on top of an object's handler: nothing of the program is in the middle of
// anything, the object may be.
class LastWords {
 public:
  explicit LastWords(std::function<void()> say);
  ~LastWords();
  LastWords(const LastWords&) = delete;
  LastWords& operator=(const LastWords&) = delete;

 private:
  const std::function<void()> say_;
  LastWords* const outer_;  // says it afterwards

  friend void SayLastWords();
};

// All of them, the newest first; once.
void SayLastWords();

}  // namespace openr_host
