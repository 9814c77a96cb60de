// The call stack of an object at a crash, as text for a human reader.
#pragma once

#include <cstddef>
#include <cstdint>

#include "openr/ending/signal_text.h"

namespace openr_host {

class Object;

// The call stack of an object at a signal that its code has caused.  Made in the handler of this
// signal.  A stack may be so damaged that walking it crashes again, so the signal handler calls
// BeginEnding() first, which prepares for a second signal.  Stack frames are named by file and
// offset, not by address, so that the same crash gives the same text in each run.  Functions of the
// runtime that called the object's handler are left out, and so are those that announced a fault
// which the runtime has found itself (robot_fault.h).
class CrashStack {
 public:
  // Walks the stack of `object`.  `context` is the third argument of the signal handler, which has
  // the processor's registers at the signal.
  CrashStack(const Object& object, const void* context);

  // Adds to `text` the word "STACK" and one line for each stack frame, the innermost first, such as
  //   "  #0 TROUBLE.BIN+0x1234 Trouble::Go() (Trouble.cc:57)".
  void AddTo(SignalText* text) const;

  // Adds to `text` the place of the innermost stack frame of the object's own code, such as ", at
  // TROUBLE.BIN+0x1234 Trouble::Go() (Trouble.cc:57)".  Adds nothing if no stack frame is of the
  // object's own code.
  void AddPlace(SignalText* text) const;

  // Returns the address of the instruction in the innermost stack frame of the object's own code;
  // null if no stack frame is of the object's own code.
  const void* OwnAddress() const;

  // Returns the offset of the instruction at OwnAddress() in the file of the object's image; 0 if
  // OwnAddress() is null.
  uintptr_t OwnOffset() const;

 private:
  static constexpr size_t kFramesMax = 32;

  struct Frame {
    uintptr_t address = 0;
    // The loaded file that has the code of this stack frame; null: no file has it.
    const char* file = nullptr;
    uintptr_t offset = 0;
    bool is_own = false;  // true if the code of this stack frame is in the object's image
  };

  void Add(uintptr_t address, const Object& object);
  static void AddFrame(const Frame& frame, SignalText* text);

  Frame frames_[kFramesMax];
  size_t count_ = 0;
};

}  // namespace openr_host
