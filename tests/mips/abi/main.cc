// The layout of every struct for which the references state one.  Section numbers are those of
// the core reference (core), the robot reference (robot) and the network reference (net).
#include <stdio.h>

#include "abi.h"

namespace {

int passed = 0;
int failed = 0;

}  // namespace

void CheckNumber(const char* file, int line, const char* what, size_t here, size_t robot) {
  if (here == robot) {
    ++passed;
    return;
  }
  ++failed;
  printf("%s:%d: %s is %u, on the robot %u\n", file, line, what, static_cast<unsigned>(here),
         static_cast<unsigned>(robot));
}

int main() {
  CheckBasicTypes();
  CheckCoreMessages();
  CheckVectors();
  CheckValues();
  CheckPower();
  CheckEnvironment();
  CheckTcp();
  CheckUdp();
  CheckDns();
  CheckEther();
  CheckOriginalNames();
  printf("%d passed, %d failed\n", passed, failed);
  return failed == 0 ? 0 : 1;
}
