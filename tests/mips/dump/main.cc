#include "dump.h"

int main() {
  DumpNumbers();
  DumpTrajectories();
  DumpMotions();
  DumpPackets();
  DumpRequests();
  DumpMover();
  DumpController();
  DumpSensors();
  return 0;
}
