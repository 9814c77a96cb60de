// openr: runs software for Sony's AIBO on a PC.  Start reading here.
//
// Each command is a file of commands/, which describes its flags and has a function that does the
// work.  `openr run` makes a Simulation (simulation.h), a Runner runs it frame by frame (runner.h),
// and the result becomes a report (report.h).
#include "cli/standard_streams.h"
#include "openr/commands/commands.h"

int main(int argc, char** argv) {
  openr_host::PrepareStandardStreams();
  return openr_host::FinishStandardOutput(openr_host::RunProgram(argc, argv), "openr");
}
