// openr check: what can be known of a program and its Memory Stick without running it.
#pragma once

#include <string>
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
};

// Collects remarks about one program.
class Remarks {
 public:
  void Add(Remark::Kind kind, const Place& place, std::string text);
  void Error(const std::string& file, std::string text);
  void Warning(const std::string& file, std::string text);
  void Note(const std::string& file, std::string text);
  void AddAll(const std::vector<Diagnostic>& diagnostics);

  const std::vector<Remark>& all() const { return all_; }
  int CountOf(Remark::Kind kind) const;

 private:
  std::vector<Remark> all_;
};

// Checks a folder with objects and sticks, or a stick alone.  Throws std::runtime_error when
// there is nothing to check.
Remarks CheckFolder(const std::string& folder);

// "file:line: warning: text", the line and a caret, for each.
std::string RenderRemarks(const Remarks& remarks);

// {"path", "errors", "warnings", "notes", "remarks": [{"severity", "file", "line", "column",
// "text"}]}
std::string RemarksToJson(const Remarks& remarks, const std::string& folder);

}  // namespace openr_host
