// Received data on pages of their own: read-only, and no longer there once they are given back.
//
// On the robot with memory protection a region is read-only for its observer, and its data
// are those of somebody else after AssertReady() (field-notes.md, 2.11 and 3.1).  Zero-copy
// regions hide both mistakes; here they are a fault at the instruction that makes them.  The second
// one is no fault on the robot, so it need not be one here.
#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "runtime/core/address_plan.h"

namespace openr_host {

class GuardPages {
 public:
  enum class GivenBack {
    kGone,    // touching them is a fault; addresses are never used twice
    kReused,  // they can be read, and are those of a later message some time
  };
  explicit GuardPages(GivenBack given_back) : given_back_(given_back) {}
  ~GuardPages();
  GuardPages(const GuardPages&) = delete;
  GuardPages& operator=(const GuardPages&) = delete;

  // A read-only copy of `size` bytes for the object at `place`, in its area for copies; null: for
  // an object without a place.  Null when there is no memory.
  char* NewCopy(const AddressPlace* place, const char* data, size_t size);

  // The copy is given back.  Addresses are used again at once with kReused, else only when the area
  // has been gone through, after 128 MiB of copies.  Other addresses are left alone.
  void Retire(const char* copy);

  // Why touching `address` was a fault, or "" when it is none of these; for signal handlers.
  const char* WhyFault(const void* address) const;

 private:
  char* MapPages(char* area, size_t bytes);

  // A copy that is alive: the area it lies in, null if that is none, and the bytes of its pages.
  struct Copy {
    char* area;
    size_t bytes;
  };

  char* TakePages(char* area, size_t bytes);

  const GivenBack given_back_;
  const AddressPlace shared_place_{kNoObject};  // of the objects that have none
  std::map<const char*, Copy> copies_;          // looked up only
  std::map<char*, size_t> next_in_;             // offset of the next copy, by area; looked up only
  std::map<std::pair<char*, size_t>, std::vector<char*>> unused_;  // given back, by area and bytes
};

}  // namespace openr_host
