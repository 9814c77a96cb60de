// Handles the standard streams 0 to 2, which may be closed, or lead to a full disk or to a pipe
// without a reader.  "The answer" is the text that a command prints on standard output.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace openr_host {

// Thrown when the reader of standard output has closed its pipe, as in `openr trace FILE | head`.
// The command ends without a message, like a command that SIGPIPE ends.
struct ReaderGone : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Prepares the standard streams.  Must be called first in main().  Afterwards
//   - each of the descriptors 0 to 2 is open, so that no file opened later gets one of these
//     numbers.  A descriptor that was closed leads to /dev/null.  If standard output was closed,
//     writing to it fails, because a lost answer must be noticed;
//   - writing to a pipe or a socket without a reader, or beyond the file size limit, gives an error
//     and does not end the process;
//   - writing to standard error never fails: text that cannot be written is lost.
void PrepareStandardStreams();

// Returns the descriptor of the standard output that the program was started with.  The descriptor
// is not 1 while a Console exists (console.h).
int StandardOutput();

// Sets the descriptor to which answers are written from now on; `descriptor` leads to the standard
// output that the program was started with.  The Console calls this function when it takes
// descriptor 1 for itself, and when it gives descriptor 1 back.
void SetStandardOutput(int descriptor);

// Prints a part of the command's answer on standard output.  Throws std::runtime_error "standard
// output: cannot be written: why", or ReaderGone.  So a command with an endless answer stops when
// its reader is gone.  A file or a pipe gets `text` byte for byte, because the answer may be data
// for a program.  A terminal gets '?' in place of control bytes, which it would obey
// (runtime/base/terminal_text.h).
void PrintAnswer(std::string_view text);

// Prints `text` as PrintAnswer() does, but does not replace control bytes for a terminal.  To be
// called for text in which the caller has put codes for colours or for moving the cursor.  The text
// must have no other control bytes, such as those of a file.
void PrintAnswerWithCodes(std::string_view text);

// Writes out at once the parts of the command's answer that PrintAnswer() has left in a buffer.
// Throws as PrintAnswer() does.
void FlushAnswer();

// Notes that a part of the command's answer was lost outside of PrintAnswer(), so that the program
// ends with an error.  `error` is an errno, or 0 if the reason is not known.
void NoteLostAnswer(int error);

// Writes out the text that is still in the buffer of standard output.  Must be called last in
// main().  Returns `exit_code`.  If some text was lost, prints an error in the name of `program` on
// standard error, and returns 1 instead of 0.  If it was lost because the reader has closed its
// pipe, prints nothing and returns kExitReaderGone.
int FinishStandardOutput(int exit_code, const char* program);

// Returns the error message "standard output: cannot be written: why".  `error` is an errno, or 0
// if the reason is not known.
std::string OutputErrorText(int error);

}  // namespace openr_host
