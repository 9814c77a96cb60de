// Guard pages: copies of received data on pages of their own, to find two mistakes of observers.
//
// 1. An observer writes to received data.  On a robot with memory protection a region is read-only
//    for its observer (field-notes.md, 3.1), so the write is a fault.
// 2. An observer reads data after the AssertReady() that gave them back.  On the robot this is no
//    fault; the observer reads data of a later message (field-notes.md, 2.11).
//
// Objects of one process share regions without a copy, so both mistakes would go unseen.  A copy is
// read-only, so the first mistake is a fault at the instruction that makes it.  The second is one
// only with GivenBack::kGone.
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
    kGone,    // an access to data that were given back is a fault
    kReused,  // data that were given back can be read; later copies replace them, as on the robot
  };
  explicit GuardPages(GivenBack given_back) : given_back_(given_back) {}
  ~GuardPages();
  GuardPages(const GuardPages&) = delete;
  GuardPages& operator=(const GuardPages&) = delete;

  // Returns a read-only copy of `size` bytes in the area for copies of `place`, the place of the
  // object that receives the data; null for an object without one.  Returns null if there is no
  // memory.
  char* NewCopy(const AddressPlace* place, const char* data, size_t size);

  // Called when the observer gives back `copy`.  With kReused, the next copy may use its addresses.
  // With kGone, an address is used again only after 128 MiB of copies, when the area has been used
  // up.  Does nothing if `copy` is not from NewCopy().
  void Retire(const char* copy);

  // Returns why the access to `address` was a fault; "" if `address` is not in an area for copies.
  // For signal handlers.
  const char* WhyFault(const void* address) const;

 private:
  char* MapPages(char* area, size_t bytes);

  // A copy in use: the area in which it lies, null if addresses are not planned, and the bytes of
  // its pages.
  struct Copy {
    char* area;
    size_t bytes;
  };

  char* TakePages(char* area, size_t bytes);

  const GivenBack given_back_;
  const AddressPlace shared_place_{kNoObject};  // for the objects without a place of their own
  // The maps are keyed by addresses, so they are only looked up: their order must not decide
  // anything in a run.
  std::map<const char*, Copy> copies_;
  std::map<char*, size_t> next_in_;  // offset of the next copy, by area
  std::map<std::pair<char*, size_t>, std::vector<char*>> unused_;  // given back, by area and bytes
};

}  // namespace openr_host
