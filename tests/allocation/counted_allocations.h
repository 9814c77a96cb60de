// Counts the allocations of this process: of operator new, malloc() and similar functions.
//
// Linked into a program, counted_allocations.cc replaces these functions for the whole process,
// libraries included.  With AddressSanitizer, which replaces them itself, it registers with
// AddressSanitizer instead.
#pragma once

#include <cstdint>

namespace openr_host {

// Returns how many blocks of memory this process has allocated since its start.
int64_t AllocationCount();

}  // namespace openr_host
