// NumberFaults: what is known about the floating-point faults of an object's handlers, for the
// findings that ImageObject adds after a handler.
#pragma once

#include <bit>

#include "runtime/core/fp_flags.h"

namespace openr_host {

class NumberFaults {
 public:
  // Records the instruction that has raised the flag `kind` (FpFlag).  Called in a signal handler.
  void NoteInstruction(unsigned kind, const void* instruction) {
    instructions_[std::countr_zero(kind)] = instruction;
  }
  // Returns the instruction that has raised the flag `kind` first.  Null if no instruction has
  // raised it, or if the instruction is not known.
  const void* InstructionOf(unsigned kind) const { return instructions_[std::countr_zero(kind)]; }

  // Records that checked_code.cc has reported, in the running handler, a floating-point number that
  // is too large for the integer type to which it is converted.
  void NoteReportedCast() { has_reported_cast_ = true; }
  void BeginHandler() { has_reported_cast_ = false; }
  bool has_reported_cast() const { return has_reported_cast_; }

 private:
  const void* instructions_[kFpKinds] = {};  // the index is the bit number of the flag
  bool has_reported_cast_ = false;
};

}  // namespace openr_host
