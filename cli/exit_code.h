// Exit codes of the commands of the program openr.
#pragma once

namespace openr_host {

constexpr int kExitGood = 0;
constexpr int kExitWrong = 1;        // any error except one in the command line
constexpr int kExitCommandLine = 2;  // an error in the command line

// Exit code when the reader of standard output has closed its pipe.  The value is the status that
// a shell shows when SIGPIPE has ended a program: 128 + 13.
constexpr int kExitReaderGone = 141;

}  // namespace openr_host
