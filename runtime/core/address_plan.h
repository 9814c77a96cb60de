// The addresses of everything that an object can see of memory.
//
// Programs send addresses: the address of a region inside a message is a usual idiom, and padding
// that nobody set may hold a pointer.  The kernel maps memory at random places, so such a program
// would be another run in every process.  Therefore the memory of objects is mapped at places that
// this plan names.  They follow from the number of the object or region, are the same in every
// process and on every machine, and lie in a part of the address space that Linux on x86-64 leaves
// empty:
//
//     2 TiB   heaps, 128 MiB for each place
//     6 TiB   images, 16 MiB for each place
//     6.5     stacks, 2 MiB for each place
//     7 TiB   regions
//    10 TiB   read-only copies of received regions, 128 MiB for each place (guard_pages.h)
//    14 TiB   the end
//
// Memory is mapped when it is needed and not reserved before, so a limit on address space (ulimit
// -v) counts only what is used.
//
// Addresses are not planned with AddressSanitizer or ThreadSanitizer, whose own tables lie there,
// nor where something else was mapped there first (address_plan.cc).  Objects then share the
// host's heap, and everything lies where the kernel puts it.
#pragma once

#include <cstddef>

#include "runtime/core/message.h"

namespace openr_host {

// The memory areas of one object that was loaded from a file.
class AddressPlace {
 public:
  static constexpr int kPlaces = 1 << 15;
  static constexpr size_t kHeapBytes = size_t{128} << 20;
  static constexpr size_t kThunkBytes = size_t{256} << 10;  // imported_calls.h
  static constexpr size_t kImageBytes = (size_t{16} << 20) - kThunkBytes;
  static constexpr size_t kStackBytes = size_t{1} << 20;  // stack_memory.h
  static constexpr size_t kCopyBytes = size_t{128} << 20;

  // Takes the place of object `id`.  An object that comes in the place of another one takes a
  // second place while the first is in use, and so does an object of another System in this
  // process; from the third one on, they take the last place that is free.
  explicit AddressPlace(ObjectId id);
  ~AddressPlace();  // REQUIRES: nothing is mapped there any more
  AddressPlace(const AddressPlace&) = delete;
  AddressPlace& operator=(const AddressPlace&) = delete;

  // The begin of each area; null when addresses are not planned.
  char* heap() const;
  char* image() const;
  char* thunks() const;
  char* stack(int number) const;  // 0: of handlers; 1: of a controller's endless loop
  char* copies() const;

  // The number of the place whose heap `address` lies in; -1: in none.
  static int OfHeap(const void* address);

 private:
  int index_ = -1;
};

// The area for regions, one for each System; null when all are taken or addresses are not
// planned.
char* TakeRegionArea();
void GiveRegionArea(char* area);
constexpr size_t kRegionAreaBytes = size_t{3} << 39;  // 1.5 TiB

// Maps `bytes` zeros at `address`, readable and writable.  False when there is no memory or
// something else lies there.
bool MapAt(char* address, size_t bytes);

// Whether `address` lies in memory that is planned.
bool IsPlanned(const void* address);

// Gives objects other addresses from now on, as another machine without a plan would: to find
// programs that depend on addresses.  REQUIRES: no System has been made in this process.
void UseOtherAddresses();

}  // namespace openr_host
