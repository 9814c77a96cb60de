// The command openr check: finds faults of a program and its Memory Stick without running it.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "runtime/config/diagnostic.h"

namespace openr_host {

struct Remark {
  enum class Kind {
    kError,    // the program will not work
    kWarning,  // the program may do something else than wanted, here or on the robot
    kNote,     // worth knowing; no fault
  };
  Kind kind;
  std::string file;
  int line = 0;    // 0: the remark is about the whole file
  int column = 0;  // 0: no caret
  std::string text;
  std::string source_line;
  std::string cause;   // remarks with the same cause are joined; empty: joined with none
  uint64_t count = 1;  // number of places
  std::vector<std::string> also_at;  // "CONNECT.CFG:5", the first of the places after this one
};

// Collects remarks about one program.
class Remarks {
 public:
  Remarks() = default;

  // Collects remarks that show files below the folder `real` as files below `shown`, which is the
  // name the user gave.
  Remarks(std::string real, std::string shown)
      : real_root_(std::move(real)), shown_root_(std::move(shown)) {}

  void Add(Remark::Kind kind, const FilePosition& place, std::string text);

  // Adds a remark.  If the file has a remark with the same `cause`, which may be any text, only
  // adds the place to that remark.
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

// Checks a folder with objects and sticks, or a stick alone.  `locators` are the names of all
// devices of all robots; controllers are checked against them.  Throws std::runtime_error when the
// folder holds nothing to check.
Remarks CheckFolder(const std::string& folder, const std::vector<std::string>& locators);

// Returns for each remark "file:line: warning: text", the line, a caret, and the number of places.
std::string RenderRemarks(const Remarks& remarks);

// Returns the remarks as JSON:
//   {"path", "errors", "warnings", "notes", "remarks": [{"severity", "file", "line", "column",
//   "text", "count", "also_at", "also_at_left_out"}]}
std::string RemarksToJson(const Remarks& remarks, const std::string& folder);

}  // namespace openr_host
