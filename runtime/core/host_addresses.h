// Addresses of this process that are no function of the run: of the C library, of the program, of
// its heap.
//
// A payload that holds one is another payload in the next process, and so is every hash that it
// enters. Memory of objects has planned addresses (address_plan.h); what remains is, for example,
// the address of a function of the C library, or of a class of the C++ library in the first bytes
// of an object that has virtual functions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace openr_host {

class HostAddresses {
 public:
  // The offset in `data` of the first 8 aligned bytes that are the address of memory of this
  // process which is not planned; -1: there is none, or this is built
  // with AddressSanitizer or ThreadSanitizer.  REQUIRES: data is aligned to 8.
  //
  // Numbers can look like addresses.  The search is given up for the rest of the run once 64 of
  // them turned out to be none: then the data are of that kind, and one that is mapped is an
  // accident.
  int64_t FindIn(const void* data, size_t size);

 private:
  static constexpr int kMissesMax = 64;

  bool IsMapped(uint64_t address);

  int misses_ = 0;
  std::vector<std::pair<uint64_t, uint64_t>> ranges_;  // begin, end; ascending
};

}  // namespace openr_host
