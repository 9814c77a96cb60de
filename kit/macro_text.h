// The macros of a few C sources, put in where they are used, as far as text can: enough to see
// what FOREVER or STEP() stands for.  No conditions but "#if 0".
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace openr_host {

// Text with macros put in, and where each of its characters comes from.
struct ExpandedText {
  std::string text;
  std::vector<size_t> origins;  // offsets in the source; of a macro, where it is used
};

class MacroTable {
 public:
  // Takes the #defines of a source.
  void Read(const std::string& source);

  // A number, or a name that #define gives one; -1 for anything else.
  int NumberOf(std::string_view word) const;

  // What a #define gives `word`, as it is written; "" if none does.
  std::string WrittenAs(const std::string& word) const;

  // `source` without comments, strings, directives and "#if 0", macros put in.  Those that are
  // numbers stay as they are: people know them by name.
  ExpandedText Expand(const std::string& source) const;

 private:
  struct Macro {
    std::optional<std::vector<std::string>> parameters;  // nullopt: it takes none
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
