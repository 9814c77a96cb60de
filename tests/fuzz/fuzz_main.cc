// The program of all fuzz targets, for clang's libFuzzer: openr_fuzz TARGET [--planted] [ARGS].
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "tests/fuzz/fuzz_targets.h"

namespace {

const openr_host::FuzzTarget* target = nullptr;
bool stops_at_planted_bug = false;

// Removes the first argument behind the name of the program, because libFuzzer does not know it.
void TakeArgument(int* argc, char** argv) {
  std::memmove(argv + 1, argv + 2, sizeof *argv * static_cast<size_t>(*argc - 1));
  *argc -= 1;
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int* argc, char*** argv) {
  if (*argc > 1) target = openr_host::FindFuzzTarget((*argv)[1]);
  if (target == nullptr) {
    std::fprintf(stderr, "usage: openr_fuzz TARGET [--planted] [ARGS of libFuzzer]\n");
    for (const openr_host::FuzzTarget& known : openr_host::FuzzTargets()) {
      std::fprintf(stderr, "  %s\n", known.name);
    }
    std::exit(2);
  }
  TakeArgument(argc, *argv);
  if (*argc > 1 && std::strcmp((*argv)[1], "--planted") == 0) {
    stops_at_planted_bug = true;
    TakeArgument(argc, *argv);
  }
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const bool has_reached = target->run({reinterpret_cast<const char*>(data), size});
  if (has_reached && stops_at_planted_bug) openr_host::FuzzViolation("the planted bug");
  return 0;
}
