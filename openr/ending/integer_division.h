// An integer division at which the processor of the host has stopped (SIGFPE).
//
// The processor stops at two divisions: by 0, and of the smallest integer by -1, whose quotient is
// too large for its type.  The robot stops at a division by 0, because the compiler for the robot
// adds a check to it (field-notes.md, 4.3).  We infer that the robot goes on after the other
// division, because no check for it is known, and the division instruction itself never stops: the
// result is the smallest integer again, with the remainder 0.
#pragma once

#include <ucontext.h>

#include <cstddef>
#include <cstdint>
#include <optional>

namespace openr_host {

struct IntegerDivision {
  size_t bytes;     // length of the instruction
  unsigned bits;    // 32 or 64, the width of the operands
  int64_t divisor;  // the operand of the instruction
};

// Returns the division at which `context`, the third argument of the signal handler for SIGFPE, has
// stopped.  Returns nullopt if the instruction is none that compilers make for a division of int or
// long, or if the host has another processor.  May be called in the signal handler.
std::optional<IntegerDivision> FindDivision(const ucontext_t& context);

// Returns whether `context` has stopped at a division of the smallest integer by -1.
bool IsSmallestByMinusOne(const ucontext_t& context);

// If `context` has stopped at a division of the smallest integer by -1, sets the registers to the
// results that the robot's processor gives and to the next instruction, and returns true.
// Otherwise returns false and changes nothing.
bool DivideAsTheRobotDoes(ucontext_t* context);

}  // namespace openr_host
