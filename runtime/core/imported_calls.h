// Runs the functions that an image imports (functions of the SDK and of the C and C++ libraries) on
// a stack of their own (stack_memory.h).  The stack of the image then holds only what the image's
// own functions wrote.
//
// The loader has written the addresses of imported functions into tables of the image.
// RedirectImports() replaces each of these addresses by the address of a thunk: a few instructions
// that change the stack, call the function and change the stack back.  Thunks lie at planned
// addresses of the object (address_plan.h), so a program that sends the address of a function sends
// the same bytes in every process.
//
// Two kinds of functions have no thunk: virtual functions of library classes, and functions that
// need their caller's frame, such as setjmp().  A function of the image that a library function
// calls, such as the comparison function that qsort() calls, runs on the stack of the library
// function.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace openr_host {

// Makes thunks (code that changes the stack for a call) for the functions that the image at `image`
// imports.  The thunks take at most `bytes` of memory at `thunks`.  Returns "", or the reason of a
// failure.  Does nothing on processors other than x86-64.  REQUIRES: the image lies at the address
// for which it was linked or to which RebaseImage() has moved it; nothing is mapped at `thunks`.
std::string RedirectImports(char* image, char* thunks, size_t bytes);

// Returns whether `address` lies in the code with which thunks change the stack.  A list of the
// functions on the stack, which is printed after a crash, leaves this code out, because it is no
// part of the program.
bool IsStackChange(uintptr_t address);

// A function F of the SDK calls this function to learn where in the image it was called.  `own` is
// the return address of F, __builtin_return_address(0).  If the image has called F directly, `own`
// lies in the image and is the result.  If the image has called F through a thunk, `own` lies in
// the code that changes the stack.  Then the result is the return address in the image, which that
// code has saved.
const void* ReturnAddressInImage(const void* own);

}  // namespace openr_host
