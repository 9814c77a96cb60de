// Where a crash is: the calls that were under way, as people can look them up.
#pragma once

#include <cstddef>
#include <cstdint>

#include "openr/ending/signal_text.h"

namespace openr_host {

class Object;

// Made in the signal handler of a crash, after BeginEnding(): a stack may be so damaged that
// walking it crashes as well.  Frames are named by file and offset in it, not by address: the same
// crash reads the same in each run.  What called the object's handler is left out.
class CrashStack {
 public:
  // `context`: the third argument of the signal handler.
  CrashStack(const Object& object, const void* context);

  // "STACK" and a line per frame, the innermost first:
  // "  #0 TROUBLE.BIN+0x1234 Trouble::Go() (Trouble.cc:57)".
  void AddTo(SignalText* text) const;

  // ", at TROUBLE.BIN+0x1234 Trouble::Go() (Trouble.cc:57)": where the object's own code was left;
  // nothing if unknown.
  void AddPlace(SignalText* text) const;

  // The address of that; null if unknown.
  const void* OwnAddress() const;

 private:
  static constexpr size_t kFramesMax = 32;

  struct Frame {
    uintptr_t address = 0;
    const char* file = nullptr;  // null: no code
    uintptr_t offset = 0;
    bool is_own = false;  // of the object's image
  };

  void Add(uintptr_t address, const Object& object);
  static void AddFrame(const Frame& frame, SignalText* text);

  Frame frames_[kFramesMax];
  size_t count_ = 0;
};

}  // namespace openr_host
