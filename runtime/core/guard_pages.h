// Guard pages: read-only copies of received data on pages of their own, which reveal two mistakes
// of observers.
//
// 1. An observer writes to received data.  On a robot with memory protection a region is read-only
//    for its observer (field-notes.md, 3.1), so the write is a fault.
// 2. An observer reads data after the AssertReady() that gave them back.  On the robot this is no
//    fault; the observer reads data of a later message (field-notes.md, 2.11).
//
// Without these copies, both mistakes would go unseen, because objects of one process share
// regions.  A write to the read-only copy is a fault, so the first mistake is found at the
// instruction that writes.  The second mistake is a fault only with GivenBack::kGone, which makes
// the copy unreadable after AssertReady().
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
    kGone,  // a copy that was given back cannot be accessed: every access is a fault
    // A read-only copy of received data that an observer has given back can be read until a later
    // copy replaces it.  On the robot, too, old data can be read until newer data replace them.
    kReused,
  };
  explicit GuardPages(GivenBack given_back) : given_back_(given_back) {}
  ~GuardPages();
  GuardPages(const GuardPages&) = delete;
  GuardPages& operator=(const GuardPages&) = delete;

  // Returns a read-only copy of the `size` bytes at `data`, or null if there is no memory.  The
  // copy lies in the memory area of `place` (address_plan.h), the place of the object that receives
  // the data.  If the object has no place, `place` is null; all objects without a place share one
  // area.
  char* NewCopy(const ObjectAddresses* place, const char* data, size_t size);

  // Ends the use of `copy`, a read-only copy that the observer has given back.  With
  // GivenBack::kReused, the next copy may lie at the same addresses.  With GivenBack::kGone,
  // addresses are used again only after 128 MiB of copies, when the area is used up.  Does nothing
  // if NewCopy() did not make `copy`.
  void Retire(const char* copy);

  // Returns a text about the mistake that made the access to `address` a fault, or "" if `address`
  // is in no memory area for read-only copies of received data.  May be called in a signal handler.
  const char* FaultText(const void* address) const;

 private:
  char* MapPages(char* area, size_t bytes);

  // A read-only copy of data that an observer has received and not given back.  `area` is the
  // memory area in which the copy lies (null if addresses are not planned), and `bytes` is the size
  // of the copy's pages.
  struct Copy {
    char* area;
    size_t bytes;
  };

  char* AllocatePages(char* area, size_t bytes);

  const GivenBack given_back_;
  const ObjectAddresses shared_place_{kNoObject};  // the area of objects that have no place
  // Nothing may depend on the order of the maps copies_, next_in_ and unused_.  Their keys contain
  // addresses of read-only copies or of memory areas, and these addresses may differ from run to
  // run.
  std::map<const char*, Copy> copies_;
  std::map<char*, size_t> next_in_;  // by area: offset of the next copy
  // Pages of read-only copies of received data, kept after the observers have given these data
  // back.  The key is the memory area and the number of bytes.  NewCopy() uses the pages again for
  // a copy with the same key.
  std::map<std::pair<char*, size_t>, std::vector<char*>> unused_;
};

}  // namespace openr_host
