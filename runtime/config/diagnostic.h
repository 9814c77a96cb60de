// Diagnostic: a message of a parser about a line of a text file.  Render() makes the text that a
// user sees.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

enum class Severity {
  kError,    // an error: the line is skipped, or the file cannot be used
  kWarning,  // a warning: the line is used, but is probably not what the author wanted
  kNote,     // a note: nothing is wrong
};

// A position in a text file.  The results of parsers, such as the name of a service, keep the
// position where they were read.  So a later message about the service ("no such service") can name
// the right line and show a caret.
struct FilePosition {
  std::string file;  // the name of the file, as the caller gave it
  int line = 0;      // counted from 1; 0 means the file as a whole
  int column = 0;    // in bytes, counted from 1; 0 means no caret
  std::string text;  // the line, without its end
};

// Returns a position in the same line as `place`, but at column `column`.
FilePosition AtColumn(FilePosition place, int column);

struct Diagnostic {
  Severity severity = Severity::kError;
  std::string file;
  int line = 0;
  int column = 0;
  std::string message;  // the mistake and how to correct it, in a single line without a full stop
  std::string text;
};

Diagnostic ErrorAt(const FilePosition& place, std::string message);
Diagnostic WarningAt(const FilePosition& place, std::string message);

bool HasErrors(const std::vector<Diagnostic>& diagnostics);

// Returns "file:line: message", then the offending line, then a caret under `column`, without a
// newline at the end.  A warning is "file:line: warning: message", a note "file:line: note:
// message".  With line 0 the text is "file: message"; with column 0 there is no caret.  The
// caret is under its column also in a line with tabs or UTF-8 characters.  Control bytes are shown
// as '?'.
std::string Render(const Diagnostic& diagnostic);

// Returns what Render() returns, but without "warning: " or "note: ".  Used for findings of a run,
// because the report shows their severity itself.
std::string RenderWithoutKind(const Diagnostic& diagnostic);

// Returns all diagnostics as text, each followed by a newline.
std::string Render(const std::vector<Diagnostic>& diagnostics);

}  // namespace openr_host
