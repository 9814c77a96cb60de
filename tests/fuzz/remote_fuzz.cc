// The fuzz target of the remote control, for clang's libFuzzer: ./dev fuzz.
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/remote_driver.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  static openr_host::FuzzStick stick;
  try {
    openr_host::RemoteDriver(&stick).Run(data, size);
    stick.Restore();
  } catch (const openr_host::Violation& violation) {
    std::fprintf(stderr, "remote_fuzz: %s\n", violation.what());
    std::abort();
  }
  return 0;
}
