// Received data on pages of their own: read-only, and no longer there once they are given back.
//
// On the robot with memory protection a region is read-only for its observer, and its data
// are those of somebody else after AssertReady() (field-notes.md, 2.11 and 3.1).  Zero-copy
// regions hide both mistakes; here they are a fault at the instruction that makes them.
#pragma once

#include <cstddef>
#include <map>

#include "runtime/core/address_plan.h"

namespace openr_host {

class GuardPages {
 public:
  GuardPages() = default;
  ~GuardPages();
  GuardPages(const GuardPages&) = delete;
  GuardPages& operator=(const GuardPages&) = delete;

  // A read-only copy of `size` bytes for the object at `place`, in its area for copies; null: for
  // an object without a place.  Null when there is no memory.
  char* NewCopy(const AddressPlace* place, const char* data, size_t size);

  // Every access to the copy faults from now on.  Its addresses are used again only when the area
  // has been gone through, after 128 MiB of copies.  Other addresses are left alone.
  void Retire(const char* copy);

 private:
  char* MapPages(char* area, size_t bytes);

  const AddressPlace shared_place_{kNoObject};  // of the objects that have none
  std::map<const char*, size_t> copies_;        // alive, with their sizes; looked up only
  std::map<const char*, size_t> next_in_;       // offset of the next copy, by area; looked up only
};

}  // namespace openr_host
