// RCRegionPool: the memory for the RCRegions (references to shared memory) of this thread.
#pragma once

#include <OPENR/RCRegion.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace openr_host {

// RCRegions are small, many and short-lived, so a separate allocation for each of them would take
// long.  The pool is never deleted, because a static object of the program may still delete regions
// when the program ends.
class RCRegionPool {
 public:
  // Returns the memory for one RCRegion.
  static void* Take() {
    if (t_free == nullptr) [[unlikely]]
      AddChunk();
    Block* const block = t_free;
    t_free = block->next;
    return block;
  }
  // Takes back `memory`, which Take() has returned in this thread.
  static void Give(void* memory) {
    Block* const block = static_cast<Block*>(memory);
    block->next = t_free;
    t_free = block;
  }
  // Calls `memory` for each piece of memory that belongs to the pool, and `used` for each RCRegion
  // in the pool that is in use.
  static void Visit(const std::function<void(const void* begin, size_t bytes)>& memory,
                    const std::function<void(const RCRegion* region)>& used);

 private:
  // The memory of one RCRegion in the pool.  The link to the next free block lies behind the
  // RCRegion and not in its place.  So a program that by mistake reads a region that it has given
  // back finds the old content, as on the robot.
  struct Block {
    alignas(RCRegion) std::byte region[sizeof(RCRegion)];
    Block* next;
  };
  static void AddChunk();

  static thread_local constinit Block* t_free;  // the first free block of the pool
  // The addresses of all chunks, the arrays of memory for RCRegions.  By this list a leak checker
  // sees that the chunks are still in use.  Without the list it would report a chunk in which an
  // object has not deleted its regions.
  static thread_local constinit std::vector<Block*>* t_chunks;
};

}  // namespace openr_host
