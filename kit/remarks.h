// Remarks: errors, warnings and notes about one program, which the command openr check prints.
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
    kWarning,  // the program may behave in an unwanted way, on this computer or on the robot
    kNote,     // nothing is wrong, but the remark tells something worth knowing
  };
  Kind kind;
  std::string file;
  int line = 0;    // number of the line; 0: the remark is about the whole file
  int column = 0;  // number of the column; 0: it is not known, so no caret is shown
  std::string text;
  std::string source_line;
  // Text that names the cause of the remark.  Remarks with the same cause become one remark; a
  // remark without a cause ("") stays alone.
  std::string cause;
  uint64_t count = 1;                // number of places that the remark is about
  std::vector<std::string> also_at;  // a few further places, such as "CONNECT.CFG:5"
};

// Collects remarks (errors, warnings and notes) about one program.
class Remarks {
 public:
  Remarks() = default;

  // Collects remarks about files in the folder `real`.  In the names of these files, replaces
  // `real` by `shown`, the name that the user gave for this folder.
  Remarks(std::string real, std::string shown)
      : real_root_(std::move(real)), shown_root_(std::move(shown)) {}

  void Add(Remark::Kind kind, const FilePosition& place, std::string text);

  // Adds a remark (an error, a warning or a note).  `cause` is a text that names the cause of the
  // remark and that users do not see.  If the file already has a remark of this kind with the same
  // cause, only adds the place to that remark, so that one mistake gives one remark.
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

// Returns the remarks as text.  The first line of an error is "file:line: text".  A warning or a
// note has the word "warning:" or "note:" before its text.  The next lines show the line of the
// file with a caret, then the other places with the same cause.  With `has_colours`, "file:line:"
// and the word "warning:" or "note:" have a colour, which differs between errors, warnings and
// notes.
std::string RenderRemarks(const Remarks& remarks, bool has_colours = false);

// Returns the remarks as JSON:
//   {"path", "errors", "warnings", "notes", "remarks": [{"severity", "file", "line", "column",
//   "text", "count", "also_at", "also_at_left_out"}]}
std::string RemarksToJson(const Remarks& remarks, const std::string& folder);

}  // namespace openr_host
