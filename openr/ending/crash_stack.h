// The stack of calls at a crash, as text for people.
#pragma once

#include <cstddef>
#include <cstdint>

#include "openr/ending/signal_text.h"

namespace openr_host {

class Object;

// The stack of calls of a crashed object.  Made in the signal handler of the crash, after
// BeginEnding(), because the stack may be so damaged that walking it crashes again.  Frames are
// named by file and offset, not by address, so that the same crash gives the same text in each run.
// Callers of the object's handler are left out.
class CrashStack {
 public:
  // Walks the stack of `object`.  `context` is the third argument of the signal handler.
  CrashStack(const Object& object, const void* context);

  // Adds "STACK" and a line per frame, the innermost first: "  #0 TROUBLE.BIN+0x1234 Trouble::Go()
  // (Trouble.cc:57)".
  void AddTo(SignalText* text) const;

  // Adds the innermost frame of the object's own code: ", at TROUBLE.BIN+0x1234 Trouble::Go()
  // (Trouble.cc:57)".  Adds nothing if there is none.
  void AddPlace(SignalText* text) const;

  // Returns the address of the innermost frame of the object's own code; null if there is none.
  const void* OwnAddress() const;

 private:
  static constexpr size_t kFramesMax = 32;

  struct Frame {
    uintptr_t address = 0;
    const char* file = nullptr;  // null: the address is no code of a file
    uintptr_t offset = 0;
    bool is_own = false;  // the code is in the object's image
  };

  void Add(uintptr_t address, const Object& object);
  static void AddFrame(const Frame& frame, SignalText* text);

  Frame frames_[kFramesMax];
  size_t count_ = 0;
};

}  // namespace openr_host
