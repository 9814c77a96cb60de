// Finds the valid name nearest to a misspelt name, for "did you mean" in messages.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace openr_host {

// Returns true if `a` and `b` are equal when the case of ASCII letters is ignored.
bool EqualsIgnoringCase(std::string_view a, std::string_view b);

// Returns `word` if it is one of the candidates.  Otherwise returns the candidate that equals
// `word` when the case of ASCII letters is ignored; nullopt if no candidate does, or if several
// different candidates do.
std::optional<std::string> MatchIgnoringCase(std::string_view word,
                                             const std::vector<std::string>& candidates);

// Returns the smallest number of insertions, deletions, replacements and swaps of neighbouring
// characters that turn `a` into `b` (optimal string alignment).  Ignores the case of ASCII letters.
int EditDistance(std::string_view a, std::string_view b);

// Returns the candidate nearest to `word`, the first of several equally near candidates.  Returns
// nullopt if no candidate is near enough, or if `word` is itself a candidate.  A candidate is near
// enough if the number of edits is at most a third of the length of `word`.  This limit is at least
// 1 and at most 3.
std::optional<std::string> ClosestMatch(std::string_view word,
                                        const std::vector<std::string>& candidates);

// Returns "; did you mean 'X'?" for the end of a message, or "" if ClosestMatch() finds nothing.
std::string DidYouMean(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace openr_host
