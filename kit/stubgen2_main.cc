// The program stubgen2, which Makefiles of existing OPEN-R programs call.  It does the same as the
// command `openr stubgen`.
#include "cli/standard_streams.h"
#include "kit/stubgen.h"

int main(int argc, char** argv) {
  openr_host::PrepareStandardStreams();
  return openr_host::FinishStandardOutput(openr_host::StubgenMain(argc, argv), "stubgen2");
}
