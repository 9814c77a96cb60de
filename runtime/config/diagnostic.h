// What a parser says about one line of a text file, and how a person sees it.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

enum class Severity {
  kError,    // the line is skipped, or the file cannot be used
  kWarning,  // the line holds, but somebody should look at it
  kNote,     // nothing is wrong; good to know
};

// A position in a text file.  A record keeps the position it was read from, so that a later
// finding about it ("no such service") names the right line and has a caret.
struct FilePosition {
  std::string file;  // as the caller named it
  int line = 0;      // from 1; 0 means the file as a whole
  int column = 0;    // from 1, in bytes; 0 means no caret
  std::string text;  // the line, without its end
};

// The same line, another column.
FilePosition AtColumn(FilePosition place, int column);

struct Diagnostic {
  Severity severity = Severity::kError;
  std::string file;
  int line = 0;
  int column = 0;
  std::string message;  // what is wrong and what to do; one line, no full stop
  std::string text;
};

Diagnostic ErrorAt(const FilePosition& place, std::string message);
Diagnostic WarningAt(const FilePosition& place, std::string message);

bool HasErrors(const std::vector<Diagnostic>& diagnostics);

// "file:line: message", then the offending line, then a caret under `column`; warnings say
// "file:line: warning: message", notes "note: " in its place.  No newline at the end.  Without a
// line: "file: message"; without a column: no caret.  Tabs keep the caret in place, UTF-8 sequences
// count as one character, control bytes are shown as '?'.
std::string Render(const Diagnostic& diagnostic);

// The same without "warning: ", for findings, which have a severity of their own.
std::string RenderWithoutKind(const Diagnostic& diagnostic);

// One after the other, each followed by a newline.
std::string Render(const std::vector<Diagnostic>& diagnostics);

}  // namespace openr_host
