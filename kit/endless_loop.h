// Finds loops in C sources that cannot end, as far as the text of the source shows that.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace openr_host {

struct EndlessLoop {
  size_t at = 0;   // where the loop begins in the checked text: at `for`, `while` or `do`
  size_t end = 0;  // where the loop ends in the checked text: the position after its last character
  bool waits = false;  // true: the loop waits for a device; false: its condition is always true
};

// Returns the loops of `code`, a text without comments, that never end.  The condition of such a
// loop is always true, or waits for a value of a device, which does not change while the loop runs.
// No break, return, goto or exit() leaves it.  `is_true` returns whether a word is a number other
// than 0, or a macro for such a number.
std::vector<EndlessLoop> FindEndlessLoops(const std::string& code,
                                          const std::function<bool(std::string_view)>& is_true);

}  // namespace openr_host
