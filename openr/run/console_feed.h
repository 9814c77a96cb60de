// What people type for the objects of a run: from a file, or line by line as it comes.
#pragma once

#include <string>

namespace openr_host {

class System;

class ConsoleFeed {
 public:
  // `file`: its text is typed at the start of the run.  "-": lines of standard input, looked for
  // at every Feed().  "": the same if it is a terminal, else nothing.  Throws std::runtime_error
  // when the file cannot be read.
  explicit ConsoleFeed(const std::string& file);

  // Gives what there is to every robot of `system`.
  void Feed(System* system);

 private:
  std::string TakeLines();

  std::string text_;          // read, not fed
  bool is_terminal_ = false;  // which shows what is typed
  bool is_open_ = false;      // more may come from standard input
};

}  // namespace openr_host
