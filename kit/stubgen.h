// The command `openr stubgen FILE [-o DIR]`, also installed on its own as `stubgen2`.
#pragma once

#include <iosfwd>
#include <string>

namespace openr_host {

struct StubgenOptions {
  std::string file;          // path of the stub.cfg; "" or "-": standard input
  std::string folder = ".";  // folder for the new files; created if it does not exist
};

// Reads a stub.cfg and writes def.h, entry.h and the two stub files.  Writes a summary to `out` and
// errors to `err`.  After an error, the folder has the files it had before.  Returns the exit code:
// 0 for success, 1 for an error in the input or on the disk.
int RunStubgen(const StubgenOptions& options, std::istream& in, std::ostream& out,
               std::ostream& err);

// Runs the command stubgen2 with the arguments of a command line; argv[0] is the name of the
// command.  Returns the exit code, which is 2 when the command line is wrong.
int StubgenMain(int argc, char** argv);

}  // namespace openr_host
