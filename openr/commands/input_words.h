// Splits the descriptions of inputs (docs/inputs.md) into words.  Shells and prompts offer these
// words when a user types an input.
#pragma once

#include <set>
#include <string>

namespace openr_host {

// Returns the words that follow the first word of an input in its `usage`, such as "SENSOR" and
// "for" in "press SENSOR [for DURATION]".  Words in capital letters stand for names and values.
// Leaves out numbers, brackets and the like.
std::set<std::string> WordsInUsage(const std::string& usage);

}  // namespace openr_host
