// "did you mean": the nearest of the names that would have been right.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace openr_host {

// True iff the two are equal when the case of ASCII letters is ignored.
bool EqualsIgnoringCase(std::string_view a, std::string_view b);

// How many insertions, deletions, replacements and swaps of neighbours turn `a` into `b`
// (optimal string alignment).  The case of ASCII letters does not count.
int EditDistance(std::string_view a, std::string_view b);

// The candidate nearest to `word`, the first of equally near ones.  nullopt when none is within
// a third of the word's length (at least 1, at most 3 edits), or when `word` itself is one.
std::optional<std::string> ClosestMatch(std::string_view word,
                                        const std::vector<std::string>& candidates);

// "; did you mean 'X'?", to be put at the end of a message, or "" when nothing is near.
std::string DidYouMean(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace openr_host
