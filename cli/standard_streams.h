// The streams that a program is started with, 0 to 2, which may be closed, full, or read by nobody.
#pragma once

#include <string>
#include <string_view>

namespace openr_host {

// To be called first in main().  Afterwards
//   - each of the descriptors 0 to 2 is open, so that no file of ours gets its number: a closed one
//     leads to /dev/null, where a standard output that was closed still cannot be written to;
//   - a pipe that nobody reads, or a file beyond the limit of the process, is an error of writing
//   and
//     not the end of the process;
//   - standard error takes everything: what cannot be written is lost, and nothing fails by it.
void PrepareStandardStreams();

// The descriptor of the standard output that the program was started with.
int StandardOutput();

// The console has taken descriptor 1; `descriptor` is what it was.
void SetStandardOutput(int descriptor);

// Prints a part of the answer on the standard output.  Throws std::runtime_error "standard output:
// cannot be written: why": an answer without an end ends when nobody reads it.
void PrintAnswer(std::string_view text);

// Writes out at once what has been printed; throws as PrintAnswer().
void FlushAnswer();

// Writing a part of it otherwise has failed; `error` is an errno, 0 for one that is not known.
void NoteLostAnswer(int error);

// To be called last in main(): writes what is still to be written to standard output.  Returns
// `exit_code`, or 1 in place of 0 after saying on standard error, as `program`, that not all could
// be written.
int FinishStandardOutput(int exit_code, const char* program);

// "standard output: cannot be written: why"; `error` is an errno, 0 for one that is not known.
std::string WhyNoStandardOutput(int error);

}  // namespace openr_host
