// Changes the copy of an image before it is loaded: moves the image to a planned address, and keeps
// the loader from running the constructors of its global objects and functions that run at the end.
//
// Normally the kernel chooses the address of a shared object.  But if the file was linked for a
// certain address, glibc from 2.36 on asks the kernel for that address.  An image is linked once
// and loaded for several objects.  So each copy is changed as if it had been linked for the planned
// address of its object (address_plan.h).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace openr_host {

// Moves the shared object `bytes`, which was linked for address 0, to `address`.  Returns false and
// changes nothing if `bytes` are not a shared object that was linked for address 0, or need more
// than `size_max` bytes of memory.  REQUIRES: `address` is a multiple of 64 KiB.
//
// Section headers, the table of all symbols and debug information keep the old addresses. gdb can
// still use them: it finds the distance by which the image was moved from the address of the
// dynamic section, and adds this distance.
bool RebaseImage(std::string* bytes, uint64_t address, uint64_t size_max);

// Changes the shared object `bytes` so that the loader does not run the constructors of its global
// objects.  They are run later, as code of the object that is loaded (HeldConstructors()).  Does
// nothing if `bytes` are no shared object of this processor.
void HoldConstructors(std::string* bytes);

// Changes the shared object `bytes` so that the loader does not call its functions with the
// attribute `destructor` when it unloads the shared object, because the robot never calls them.
// Keeps an image of openr build --coverage as it is, because such a function writes its counts.
// Does nothing if `bytes` are no shared object of this processor.
void DropDestructors(std::string* bytes);

// Returns the constructors of an image's global objects, which HoldConstructors() has kept the
// loader from calling, in the order in which they must be called.  `handle` is the handle of the
// loaded image (dlopen).
std::vector<void (*)()> HeldConstructors(void* handle);

}  // namespace openr_host
