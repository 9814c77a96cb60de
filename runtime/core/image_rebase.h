// What is changed in the copy of an image that is loaded: its address, and who runs its
// constructors.
//
// The loader maps a shared object where the kernel likes, unless the file was linked for an
// address: glibc from 2.36 on asks for that one.  An image is linked once and loaded many times, so
// its copy in the run folder is changed as if it had been linked for the address of its place.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace openr_host {

// Moves a shared object that was linked for address 0 to `address`, a multiple of 64 KiB.  False,
// and `bytes` are as they were, when the file is not of this kind or needs more than `size_max`
// bytes of memory.
//
// Sections, the table of all symbols and debug information stay as they were linked: gdb sees by
// the address of the dynamic section how far the image was moved.
bool RebaseImage(std::string* bytes, uint64_t address, uint64_t size_max);

// Keeps the loader from running the constructors of global objects of the shared object `bytes`;
// HeldConstructors() has them.  Does nothing to what is no shared object of this processor.
void HoldConstructors(std::string* bytes);

// The constructors that HoldConstructors() kept from running in the shared object that was loaded
// as `handle` (dlopen), in the order in which they are to be called.
std::vector<void (*)()> HeldConstructors(void* handle);

}  // namespace openr_host
