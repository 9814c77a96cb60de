// stubgen2 under its own name, for the Makefiles of existing OPEN-R programs.
#include "openr/stubgen.h"

int main(int argc, char** argv) { return openr_host::StubgenMain(argc, argv); }
