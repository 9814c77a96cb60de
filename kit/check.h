// openr check: what can be known of a program and its Memory Stick without running it.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "runtime/config/diagnostic.h"

namespace openr_host {

struct Remark {
  enum class Kind {
    kError,    // it will not work
    kWarning,  // it may not do what is wanted, or not on the robot
    kNote,     // good to know
  };
  Kind kind;
  std::string file;
  int line = 0;    // 0: the file as a whole
  int column = 0;  // 0: no caret
  std::string text;
  std::string source_line;
  std::string cause;   // consequences of one cause are one remark; empty: stands alone
  uint64_t count = 1;  // places where the same was seen
  std::vector<std::string> also_at;  // "CONNECT.CFG:5", the first ones of the later places
};

// Collects remarks about one program.
class Remarks {
 public:
  Remarks() = default;

  // Files below the folder `real` are shown as files below `shown`, as the person named it.
  Remarks(std::string real, std::string shown)
      : real_root_(std::move(real)), shown_root_(std::move(shown)) {}

  void Add(Remark::Kind kind, const FilePosition& place, std::string text);

  // The first consequence of a cause in a file is kept, later ones are counted with their places.
  // Any name will do for `cause`.
  void AddConsequence(Remark::Kind kind, const FilePosition& place, std::string cause,
                      std::string text);

  void Error(const std::string& file, std::string text);
  void Warning(const std::string& file, std::string text);
  void Note(const std::string& file, std::string text);
  void AddAll(const std::vector<Diagnostic>& diagnostics);

  const std::vector<Remark>& all() const { return all_; }
  int CountOf(Remark::Kind kind) const;

 private:
  std::string Shown(const std::string& file) const;

  std::string real_root_, shown_root_;
  std::vector<Remark> all_;
};

// Checks a folder with objects and sticks, or a stick alone.  `locators`: of all devices of all
// robots, for what controllers ask for.  Throws std::runtime_error when there is nothing to check.
Remarks CheckFolder(const std::string& folder, const std::vector<std::string>& locators);

// "file:line: warning: text", the line and a caret, for each, and how often it was seen.
std::string RenderRemarks(const Remarks& remarks);

// {"path", "errors", "warnings", "notes", "remarks": [{"severity", "file", "line", "column",
// "text", "count", "also_at", "also_at_left_out"}]}
std::string RemarksToJson(const Remarks& remarks, const std::string& folder);

}  // namespace openr_host
