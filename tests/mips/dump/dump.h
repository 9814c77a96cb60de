// The results of the objects' logic for fixed inputs, as lines of text.  The same text must come
// out on every compiler, word size and CPU; C++98, so that the robot's compiler can build it, too.
#ifndef DUMP_DUMP_H_INCLUDED
#define DUMP_DUMP_H_INCLUDED

#include <stdio.h>

#include <string>
#include <vector>

#include "FixedTypes.h"

// Numbers without a library: the same everywhere.  One call per statement, because the order of
// the arguments of a call is the compiler's.
class Draw {
 public:
  explicit Draw(Uint32 seed) : state_(seed) {}
  Uint32 Next() {
    state_ = state_ * 1664525u + 1013904223u;
    return state_ >> 8;
  }
  // From `low` to `high`.
  Sint32 Between(Sint32 low, Sint32 high) {
    return low + static_cast<Sint32>(Next() % static_cast<Uint32>(high - low + 1));
  }

 private:
  Uint32 state_;
};

// A motion of `joints` joints of the ERS-210 and `keyFrames` key frames, as bytes of a file.
std::vector<Uint8> MakeMotion(int joints, int keyFrames, Draw* draw);

void PrintBytes(const char* what, const Uint8* bytes, int size);

void DumpNumbers();
void DumpTrajectories();
void DumpMotions();
void DumpPackets();
void DumpRequests();
void DumpMover();
void DumpController();
void DumpSensors();
void DumpBallChaser();

#endif  // DUMP_DUMP_H_INCLUDED
