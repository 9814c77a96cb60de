// The address plan: fixed addresses for all memory that an object can see.
//
// Programs send addresses: many put the address of a region into a message, and padding that was
// never set may hold a pointer.  The kernel maps memory at random addresses, so the messages of
// such a program would differ from process to process.  Therefore this plan gives the memory of
// objects fixed addresses, which are the same in every process and on every machine.  Each object
// has a place: a number that selects one part of each range below, except of the regions.  The
// address of a region follows from the number of the region.  All ranges lie in a part of the
// address space that Linux on x86-64 leaves empty:
//
//     2 TiB   heaps, 128 MiB for each place
//     6 TiB   images, 16 MiB for each place
//   6.5 TiB   stacks, 2 MiB for each place
//     7 TiB   regions
//    10 TiB   read-only copies of received regions, 128 MiB for each place (guard_pages.h)
//    14 TiB   the end
//
// Memory is mapped only when it is needed, and not reserved before.  So a limit on address space
// (ulimit -v) counts only used memory.
//
// Addresses are not planned in three cases: on processors other than x86-64; with AddressSanitizer
// or ThreadSanitizer, because tables of these tools lie at these addresses; and if other memory is
// mapped there at the start (address_plan.cc).  Objects then share the host's heap, and the kernel
// chooses the address of every mapping.
#pragma once

#include <cstddef>

#include "runtime/core/message.h"

namespace openr_host {

// The place of one object in the address plan: a part of each range (heaps, images ...) that only
// this object uses.  Only objects that were loaded from files have a place.
class ObjectAddresses {
 public:
  static constexpr int kPlaces = 1 << 15;
  static constexpr size_t kHeapBytes = size_t{128} << 20;
  static constexpr size_t kThunkBytes = size_t{256} << 10;  // area for thunks (imported_calls.h)
  static constexpr size_t kImageBytes = (size_t{16} << 20) - kThunkBytes;
  static constexpr size_t kStackBytes = size_t{1} << 20;  // area for a stack (stack_memory.h)
  static constexpr size_t kCopyBytes = size_t{128} << 20;

  // Takes a place of the plan for object `id`, which has two places of its own.  Takes the first
  // place if it is free.  Two kinds of objects may still use it: the previous object `id`, which
  // this object replaces, or an object of another System in this process.  Then takes the second
  // place.  If both places are in use, takes the free place with the highest number.
  explicit ObjectAddresses(ObjectId id);
  ~ObjectAddresses();  // REQUIRES: nothing is mapped at this place any more
  ObjectAddresses(const ObjectAddresses&) = delete;
  ObjectAddresses& operator=(const ObjectAddresses&) = delete;

  // Returns the first address of the heap of this place, or null if addresses are not planned.
  char* heap() const;
  // Returns the first address of the image of this place, or null if addresses are not planned.
  char* image() const;
  // Returns the first address of the thunks (imported_calls.h) of this place, which lie behind the
  // image, or null if addresses are not planned.
  char* thunks() const;
  // Returns the first address of stack `number` of this place (the part of the address plan for one
  // object), or null if addresses are not planned.  Stack 0 is for handlers, stack 1 for the
  // endless loop of a controller (api/second_stack.h).
  char* stack(int number) const;
  // Returns the first address of the area for read-only copies of received regions (guard_pages.h),
  // or null if addresses are not planned.
  char* copies() const;

  // Returns the number of the place (the part of the plan for one object) whose heap area contains
  // `address`, or -1 if no heap area does.  Arena::OwnerOf() uses this function to find the heap of
  // a block.
  static int OfHeap(const void* address);

 private:
  int index_ = -1;  // the number of the place; -1 if addresses are not planned
};

// Reserves an area of kRegionAreaBytes bytes for the regions (blocks of shared memory) of one
// System, and returns its first address.  There are two areas.  Returns null if both are taken or
// addresses are not planned.
char* ReserveRegionArea();
// Gives back `area`, the addresses for the regions of one System that ReserveRegionArea() has
// returned, so that another System can take them.
void GiveRegionArea(char* area);
// The size of a region area.  RegionMemory keeps a block of every size class for each of its 65,536
// slots (region_memory.h).  The size classes are 64, 256, 1024 ... bytes up to 16 MiB, together
// 21.3 MiB, so all blocks need about 1.33 TiB.
constexpr size_t kRegionAreaBytes = size_t{3} << 39;  // 1.5 TiB in bytes

// Maps `bytes` bytes of zeros at `address`, readable and writable.  Returns false if there is no
// memory or the addresses are in use.
bool MapAt(char* address, size_t bytes);

// Returns whether `address` belongs to the address plan.  The addresses of the plan are the same in
// every process.
bool IsPlanned(const void* address);

// Makes the address plan use other addresses.  The exploration of a program (openr/explore) runs
// the program with the usual and with the other addresses: if the runs differ, the program depends
// on addresses.  REQUIRES: no System has been made in this process.
void UseOtherAddresses();

}  // namespace openr_host
