// ConsoleFeed, which gives the robots' programs the console input: a file, or what a user types.
#pragma once

#include <string>

namespace openr_host {

class System;

class ConsoleFeed {
 public:
  // `file` "-" means standard input, of which each Feed() gives the lines that have come.  "" means
  // the same if standard input is a terminal, else no input.  The content of any other file is
  // given at the start of the run.  Throws std::runtime_error when the file cannot be read.
  explicit ConsoleFeed(const std::string& file);

  // Gives every robot of `system` the console input that has come since the last call: lines from
  // standard input, or in the first call the content of the file.
  void Feed(System* system);

 private:
  std::string TakeLines();

  std::string text_;          // input that has come and was not given yet
  bool is_terminal_ = false;  // standard input is a terminal, which shows what is typed
  bool is_open_ = false;      // standard input may bring more
};

}  // namespace openr_host
