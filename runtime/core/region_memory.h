// RegionMemory: allocates the memory of regions, the blocks of shared memory that a RegionTable
// lists.
//
// The address of a region follows from its slot (index) in the table and its size.  So the address
// is the same in every process of a run.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace openr_host {

class RegionMemory {
 public:
  RegionMemory();
  ~RegionMemory();  // frees all blocks, except blocks of the host's heap
  RegionMemory(const RegionMemory&) = delete;
  RegionMemory& operator=(const RegionMemory&) = delete;

  static constexpr uint32_t kSlots = 1 << 16;

  // Returns memory of `bytes` zeros for the region in `slot`, or null if there is no memory.
  // REQUIRES: slot < kSlots.
  //
  // The memory has a planned address, except in four cases: more than 16 MiB (half of the robot's
  // memory) are wanted, the memory of an earlier region of this slot and size is still in use, the
  // planned memory cannot be mapped, or addresses are not planned.  In these cases the memory comes
  // from the host's heap.
  char* New(uint32_t slot, size_t bytes);

  // Frees `block`, the memory of a region that New() returned.  Does nothing if `block` is null.
  void Free(char* block);

 private:
  // The size of a region is rounded up to one of kClasses sizes, the size classes.  A cell is the
  // memory for one region.  For each slot of the RegionTable there is one cell of each size class.
  // A cell of class 0 has 64 bytes, and a cell of each further class four times as many as a cell
  // of the class before.
  static constexpr int kClasses = 10;
  static size_t CellBytes(int size_class) { return size_t{64} << (2 * size_class); }
  static size_t OffsetOf(int size_class);

  struct Cell {
    int size_class;
    uint32_t slot;
    bool operator==(const Cell&) const = default;
  };

  char* MappedCell(int size_class, uint32_t slot);
  void Unmap(const Cell& cell);
  void RemoveFromKept(const Cell& cell);

  struct Cells {
    std::vector<bool> in_use;  // whether the cell of each slot is in use
    // Tells for each piece of memory whether the piece is mapped.  A piece has kMapBytes and holds
    // several cells (a cell is the memory for one region).  If a cell of this size class has
    // kMapBytes or more, each cell is a piece.
    std::vector<bool> is_mapped;
  };

  // Beginning of the memory for all regions; null when addresses are not planned (address_plan.h).
  char* area_;
  std::array<Cells, kClasses> cells_;
  // Free cells (a cell is the memory for one region) of kMapBytes or more that are still mapped, in
  // the order in which they were freed.  kept_bytes_ is the sum of their bytes.
  std::vector<Cell> kept_;
  size_t kept_bytes_ = 0;
};

}  // namespace openr_host
