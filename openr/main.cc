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
  // Makes Mesa draw pictures without threads of its own: if a thread could not be made for lack of
  // memory, Mesa would wait without end, and a copy of this process, made by fork(), would not have
  // the threads.  The pictures are the same.  Set here, because later other threads may read the
  // environment.
  setenv("LP_NUM_THREADS", "0", 0);
  openr_host::PrepareStandardStreams();
  return openr_host::FinishStandardOutput(openr_host::RunProgram(argc, argv), "openr");
}
