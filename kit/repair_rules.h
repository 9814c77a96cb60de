// Changes sources that the SDK's g++ 3.3 accepted and today's g++ does not, so that both compilers
// accept them.
//
// Each rule handles one kind of error message and looks at the source text at the place that the
// message names.  No line changes its number, so that later messages name the lines of the user's
// own file.
#pragma once

#include <string>
#include <vector>

namespace openr_host {

// An error message of the compiler or of the assembler.
struct CompilerError {
  std::string message;  // text of the message, in English and with ASCII quotes
  std::string file;
  int line = 0;
  int column = 0;  // number of the column in bytes, from 1
};

// A change of one part of a source: `text` replaces the characters from `begin` to `end`.
struct Edit {
  size_t begin = 0;  // begin of the replaced text: offset in the file of the error
  size_t end = 0;    // end of the replaced text; equal to `begin` for an insertion
  std::string text;
  std::string what;  // tells the user what the repair changes; "" if an earlier edit tells it
};

// Returns the edits of `text`, the whole file, that repair `error`; none if no
// rule fits.  If the error is about a missing header, `headers` are the paths of all headers
// that could be meant.
std::vector<Edit> RepairOf(const CompilerError& error, const std::string& text,
                           const std::vector<std::string>& headers);

}  // namespace openr_host
