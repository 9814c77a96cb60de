// The command `openr stubgen FILE [-o DIR]`, also installed on its own as `stubgen2`.
#pragma once

#include <iosfwd>
#include <string>

namespace openr_host {

struct StubgenOptions {
  std::string file;          // "" or "-": standard input
  std::string folder = ".";  // made if it does not exist
};

// Reads a stub.cfg and writes def.h, entry.h and the two stub files; a summary goes to `out`,
// complaints go to `err`.  Nothing is left half written: on any error the folder keeps the files it
// had.  Returns the exit code: 0 good, 1 the input or the disk is to blame.
int RunStubgen(const StubgenOptions& options, std::istream& in, std::ostream& out,
               std::ostream& err);

// The same from a command line, argv[0] being the command's name; 2 when that line is wrong.
int StubgenMain(int argc, char** argv);

}  // namespace openr_host
