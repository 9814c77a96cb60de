// NumberFaults: the arithmetic faults of an object's handlers, recorded for the findings that
// ImageObject adds after a handler.
#pragma once

#include <bit>

#include "runtime/core/fp_flags.h"

namespace openr_host {

class NumberFaults {
 public:
  // Records the first instruction that has raised the flag `kind` (FpFlag).  Called in a signal
  // handler.
  void NoteInstruction(unsigned kind, const void* instruction) {
    instructions_[std::countr_zero(kind)] = instruction;
  }
  // Returns the instruction that has raised the flag `kind` first; null if there is none, or if the
  // instruction is not known.
  const void* InstructionOf(unsigned kind) const { return instructions_[std::countr_zero(kind)]; }

  // Records an instruction that has divided the smallest integer by -1.  Called in a signal
  // handler.
  void NoteTooLargeQuotient(const void* instruction) {
    if (has_too_large_quotient_) return;
    has_too_large_quotient_ = is_too_large_quotient_new_ = true;
    too_large_quotient_ = instruction;
  }
  // Returns whether a division of the smallest integer by -1 was recorded and not reported yet.
  bool HasNewTooLargeQuotient() const { return is_too_large_quotient_new_; }
  // Returns the first instruction that has divided the smallest integer by -1; null if it is not
  // known.  From then on the division counts as reported (HasNewTooLargeQuotient()).
  const void* TakeTooLargeQuotient() {
    is_too_large_quotient_new_ = false;
    return too_large_quotient_;
  }

  // Records that checked_code.cc has reported, in the running handler, a floating-point number that
  // is too large for the integer type to which it is converted.
  void NoteReportedCast() { has_reported_cast_ = true; }
  void BeginHandler() { has_reported_cast_ = false; }
  bool has_reported_cast() const { return has_reported_cast_; }

 private:
  const void* instructions_[kFpKinds] = {};  // the index is the bit number of the flag
  bool has_reported_cast_ = false;
  bool has_too_large_quotient_ = false;
  bool is_too_large_quotient_new_ = false;
  const void* too_large_quotient_ = nullptr;
};

}  // namespace openr_host
