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
  DumpBallChaser();
  return 0;
}
