// Memory for the blocks of a RegionTable: where a block lies follows from its slot in the
// table and its size, so that it is the same in every process that runs a part of a run.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace openr_host {

class RegionMemory {
 public:
  RegionMemory();
  ~RegionMemory();  // with all blocks but those that came from the host's heap
  RegionMemory(const RegionMemory&) = delete;
  RegionMemory& operator=(const RegionMemory&) = delete;

  static constexpr uint32_t kSlots = 1 << 16;

  // `bytes` zeros; null when there is no memory.  They come from the host's heap when they are more
  // than 16 MiB, half of the robot's memory, when the slot's memory of this size is in use
  // still or cannot be had, or when addresses are not planned.  REQUIRES: slot < kSlots.
  char* New(uint32_t slot, size_t bytes);

  // A null `block` is no block.
  void Free(char* block);

 private:
  // Each class has one cell for each slot, of 64 bytes in the first one and four times the last
  // one's in the next.
  static constexpr int kClasses = 10;
  static size_t CellBytes(int size_class) { return size_t{64} << (2 * size_class); }
  static size_t OffsetOf(int size_class);

  char* MappedCell(int size_class, uint32_t slot);

  struct Cells {
    std::vector<bool> in_use;     // by slot
    std::vector<bool> is_mapped;  // by step of what is taken from the kernel at a time
  };

  char* area_;  // null when addresses are not planned
  std::array<Cells, kClasses> cells_;
};

}  // namespace openr_host
