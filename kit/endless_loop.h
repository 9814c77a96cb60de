// Finds loops in C sources that cannot end, as far as the text of the source shows that.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace openr_host {

struct EndlessLoop {
  size_t at = 0;       // position of the keyword
  size_t end = 0;      // position after the body
  bool waits = false;  // the condition asks a device of the controller; else it is always true
};

// Returns the loops of `code`, a text without comments, that no break, return, goto or exit()
// leaves and whose condition never changes.  Such a condition is always true, or asks only for a
// value that cannot change while the loop runs.  `is_true` returns whether a word is a number other
// than 0 or a name of such a number.
std::vector<EndlessLoop> FindEndlessLoops(const std::string& code,
                                          const std::function<bool(std::string_view)>& is_true);

}  // namespace openr_host
