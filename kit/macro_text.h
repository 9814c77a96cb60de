// Expands the macros of a few C sources, as far as needed to find what a word such as FOREVER or
// STEP() stands for.  The only condition of the preprocessor that is understood is "#if 0".
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace openr_host {

// Source text with its macros expanded, and the place in the source that each character comes from.
struct ExpandedText {
  std::string text;
  // For each character of `text`, its offset in the source; for text of a macro, the offset of the
  // macro's use.
  std::vector<size_t> origins;
};

class MacroTable {
 public:
  // Adds the macros that the text `source` defines.
  void Read(const std::string& source);

  // Returns the value of `word` if it is a number, or a macro that stands for a number; -1 for
  // other words.
  int NumberOf(std::string_view word) const;

  // Returns the text that a #define gives `word`, as it is written; "" if there is no such #define.
  std::string WrittenAs(const std::string& word) const;

  // Returns `source` with macros expanded, without comments, strings, directives and the parts in
  // "#if 0".  Does not expand macros that stand for numbers, because messages show the names of
  // such macros.
  ExpandedText Expand(const std::string& source) const;

 private:
  struct Macro {
    // Names of the parameters; nullopt if the macro has no list of parameters.
    std::optional<std::vector<std::string>> parameters;
    std::string body;  // text of the macro, without comments and strings
    std::string written;
  };
  using Names = std::set<std::string>;

  void Put(std::string_view text, size_t fixed, const Names& hidden, ExpandedText* result) const;
  size_t PutMacro(std::string_view text, size_t at, size_t origin, const Names& hidden,
                  ExpandedText* result) const;

  std::map<std::string, Macro, std::less<>> macros_;
};

}  // namespace openr_host
