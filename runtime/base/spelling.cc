#include "runtime/base/spelling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace openr_host {
namespace {

// The largest number of edits (added, lost, changed or swapped characters) between a misspelt name
// and a suggested name.  A name that is more than 3 edits away was probably not meant; the build
// tool Ninja has the same limit.
constexpr int kEditsMax = 3;

char Lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

bool EqualsIgnoringCase(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return Lower(x) == Lower(y); });
}

std::optional<std::string> MatchIgnoringCase(std::string_view word,
                                             const std::vector<std::string>& candidates) {
  std::optional<std::string> match;
  bool is_ambiguous = false;
  for (const std::string& candidate : candidates) {
    if (candidate == word) return candidate;
    if (!EqualsIgnoringCase(candidate, word)) continue;
    is_ambiguous = is_ambiguous || (match && *match != candidate);
    match = candidate;
  }
  return is_ambiguous ? std::nullopt : match;
}

int EditDistance(std::string_view a, std::string_view b) {
  const size_t width = b.size() + 1;
  // The table of edit distances is computed row by row.  Only three rows are kept: `row` is
  // computed now, `above` is the row before it, and `before` is the row before `above`, which is
  // needed for swapped letters.
  std::vector<int> before(width), above(width), row(width);
  for (size_t j = 0; j < width; ++j) above[j] = static_cast<int>(j);
  for (size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (size_t j = 1; j <= b.size(); ++j) {
      const bool same = Lower(a[i - 1]) == Lower(b[j - 1]);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (same ? 0 : 1)});
      const bool swapped = i > 1 && j > 1 && Lower(a[i - 1]) == Lower(b[j - 2]) &&
                           Lower(a[i - 2]) == Lower(b[j - 1]);
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before.swap(above);
    above.swap(row);
  }
  return above[b.size()];
}

std::optional<std::string> ClosestMatch(std::string_view word,
                                        const std::vector<std::string>& candidates) {
  int limit = std::clamp(static_cast<int>(word.size()) / 3, 1, kEditsMax);
  std::optional<std::string> closest;
  for (const std::string& candidate : candidates) {
    if (candidate == word) return std::nullopt;
    const int distance = EditDistance(word, candidate);
    if (distance > limit) continue;
    closest = candidate;
    // Lowers the limit of edits, so that only a valid name with fewer edits can replace this one.
    limit = distance - 1;
  }
  return closest;
}

std::string DidYouMean(std::string_view word, const std::vector<std::string>& candidates) {
  const std::optional<std::string> closest = ClosestMatch(word, candidates);
  return closest ? fmt::format("; did you mean '{}'?", *closest) : std::string();
}

}  // namespace openr_host
