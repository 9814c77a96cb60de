// Calls of functions that an image imports: of the SDK and of the C and C++ libraries.  They run on
// a stack of their own (stack_memory.h), so that the stack of the image holds what its own
// functions wrote and nothing else.
//
// The loader has written the addresses of these functions into tables of the image.  Each is
// replaced by that of a thunk, a few instructions which change the stack, call the function and
// come back.  Thunks lie in the place of the object (address_plan.h), so the address of a function
// that a program sends is the same in each process.
//
// Without a thunk remain virtual functions of library classes and functions that must find their
// caller's frame, as setjmp() does.  What a library function calls back (the comparison of qsort)
// runs on the stack of the library function.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace openr_host {

// Gives the image that was loaded at `image`, where it was linked for, thunks in the `bytes` of
// memory at `thunks`, where nothing is mapped.  Returns what is wrong, or "".  On processors other
// than x86-64 it does nothing.
std::string RedirectImports(char* image, char* thunks, size_t bytes);

// Whether `address` lies in the code between a thunk and the function: a frame that tells the
// reader of a stack nothing.
bool IsStackChange(uintptr_t address);

// For a function that an image has called by a thunk: the address that the call returns to.
// `own`: __builtin_return_address(0), which is returned where no thunk was used.
const void* ReturnAddressInImage(const void* own);

}  // namespace openr_host
