// Expands the macros of a few C sources, as far as needed to find what a word such as FOREVER or
// STEP() stands for.  Understands no conditions but "#if 0".
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace openr_host {

// Text after macros were expanded, with the origin of each character.
struct ExpandedText {
  std::string text;
  std::vector<size_t> origins;  // offset in the source; for the text of a macro, offset of its use
};

class MacroTable {
 public:
  // Adds the macros that a source defines.
  void Read(const std::string& source);

  // Returns the value of a number, or of a macro that stands for a number; -1 for other words.
  int NumberOf(std::string_view word) const;

  // Returns the text that a #define gives `word`, as it is written; "" if there is no such #define.
  std::string WrittenAs(const std::string& word) const;

  // Returns `source` with macros expanded, without comments, strings, directives and "#if 0".
  // Macros that stand for numbers are not expanded, because messages name them.
  ExpandedText Expand(const std::string& source) const;

 private:
  struct Macro {
    std::optional<std::vector<std::string>> parameters;  // nullopt: a macro without brackets
    std::string body;                                    // without comments and strings
    std::string written;
  };
  using Names = std::set<std::string>;

  void Put(std::string_view text, size_t fixed, const Names& hidden, ExpandedText* result) const;
  size_t PutMacro(std::string_view text, size_t at, size_t origin, const Names& hidden,
                  ExpandedText* result) const;

  std::map<std::string, Macro, std::less<>> macros_;
};

}  // namespace openr_host
