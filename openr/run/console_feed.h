// Gives objects the console input that people type: from a file, or line by line as it comes.
#pragma once

#include <string>

namespace openr_host {

class System;

class ConsoleFeed {
 public:
  // The content of `file` is given to the objects at the start of the run.  "-" means lines of
  // standard input, read at every Feed().  "" means standard input if that is a terminal, else no
  // input.  Throws std::runtime_error when the file cannot be read.
  explicit ConsoleFeed(const std::string& file);

  // Gives the text that has been read to every robot of `system`.
  void Feed(System* system);

 private:
  std::string TakeLines();

  std::string text_;          // text that was read and not given to the robots yet
  bool is_terminal_ = false;  // a terminal echoes itself what is typed
  bool is_open_ = false;      // standard input has not ended
};

}  // namespace openr_host
