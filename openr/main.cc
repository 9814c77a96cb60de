// The main function of the program openr, which runs software for Sony's AIBO on a PC.  Start
// reading here.
//
// Each command of the program has a file in openr/commands/, which describes the flags of the
// command and has the function that does the work.  For `openr run`, this function makes a
// Simulation (simulation.h), lets a Runner (runner.h) run it frame by frame, and makes a report of
// the result (report.h).
#include <stdlib.h>

#include "cli/standard_streams.h"
#include "openr/commands/commands.h"

int main(int argc, char** argv) {
  // Makes Mesa draw pictures without threads of its own.  The pictures are the same.  With threads,
  // Mesa would wait without end for a thread that could not be made for lack of memory.  In a copy
  // of this process, made by fork(), Mesa would wait for threads that the copy does not have.
  // Calls setenv() before the program has other threads, because other threads may read the
  // environment meanwhile.
  setenv("LP_NUM_THREADS", "0", 0);
  openr_host::PrepareStandardStreams();
  return openr_host::FinishStandardOutput(openr_host::RunProgram(argc, argv), "openr");
}
