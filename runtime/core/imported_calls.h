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
// calls (the comparison of qsort) runs on the stack of the library function.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace openr_host {

// Makes thunks for the image at `image`, which is also the address for which it was linked.  The
// thunks take at most `bytes` of memory at `thunks`.  Returns "", or the reason of a failure.  Does
// nothing on processors other than x86-64.  REQUIRES: nothing is mapped at `thunks`.
std::string RedirectImports(char* image, char* thunks, size_t bytes);

// Returns whether `address` lies in the code with which thunks change the stack.  Backtraces leave
// out a frame of this code, because it tells their readers nothing.
bool IsStackChange(uintptr_t address);

// Returns the address in the image to which the calling function will return.  If a thunk has
// called that function, its own return address lies in the code of the thunks, so this function
// finds the address behind the thunk.  `own` is __builtin_return_address(0), which is returned if
// no thunk was used.
const void* ReturnAddressInImage(const void* own);

}  // namespace openr_host
