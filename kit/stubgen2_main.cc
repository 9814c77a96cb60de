// stubgen2 under its own name, for the Makefiles of existing OPEN-R programs.
#include "cli/standard_streams.h"
#include "kit/stubgen.h"

int main(int argc, char** argv) {
  openr_host::PrepareStandardStreams();
  return openr_host::FinishStandardOutput(openr_host::StubgenMain(argc, argv), "stubgen2");
}
