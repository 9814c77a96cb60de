// Loops in C sources that cannot end, as far as text shows it.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace openr_host {

struct EndlessLoop {
  size_t at = 0;       // of its keyword
  size_t end = 0;      // behind its body
  bool waits = false;  // it asks a device of the controller again and again; else it asks nothing
};

// The loops in a text without comments whose condition is always true, or asks only what does not
// change while the loop runs, and which no break, return, goto or exit() leaves.  `is_true`:
// whether a word is a number other than 0, or a name for one.
std::vector<EndlessLoop> FindEndlessLoops(const std::string& code,
                                          const std::function<bool(std::string_view)>& is_true);

}  // namespace openr_host
