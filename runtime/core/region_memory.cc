#include "runtime/core/region_memory.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "runtime/base/assert.h"
#include "runtime/core/address_plan.h"

namespace openr_host {
namespace {

// Memory is mapped in pieces of this size.  A piece holds several small cells (a cell is the memory
// for one region), so that there are fewer system calls.  A larger cell is mapped as one piece.
constexpr size_t kMapBytes = 64 << 10;
// The largest size of a cell (the memory for one region) that stays mapped when it is freed, so
// that the next region in this cell needs no system call.
constexpr size_t kKeepBytes = 256 << 10;
// The largest sum of bytes of the free cells that stay mapped (RegionMemory::kept_bytes_).  A cell
// is the memory for one region; each slot (index of a region) of the RegionTable has its own cells.
// After a reboot of the robot the same regions get other slots, and so other cells.  So without a
// limit, each reboot would leave more unused cells mapped.  Cells smaller than kMapBytes are always
// kept, and are not part of the sum.
constexpr size_t kKeptBytesMax = 1 << 20;

// Sets flag `index` (of a slot or a piece of memory) of the list `flags` to `value`.  Flags beyond
// the end of the list are false, so the list is only as long as needed: most runs use few of the
// 65,536 slots.
void Set(std::vector<bool>* flags, size_t index, bool value) {
  if (index >= flags->size()) flags->resize(index + 1);
  (*flags)[index] = value;
}

bool IsSet(const std::vector<bool>& flags, size_t index) {
  return index < flags.size() && flags[index];
}

}  // namespace

size_t RegionMemory::OffsetOf(int size_class) {
  // A cell is the memory for one region.  The cells of this size class begin after the cells of all
  // smaller classes.  Each class has kSlots cells.  With c = CellBytes(size_class), the smaller
  // classes have cells of 64, 256, ... c / 4 bytes.  These sizes are a geometric series with the
  // sum (c - 64) / 3.
  return (CellBytes(size_class) - CellBytes(0)) / 3 * kSlots;
}

RegionMemory::RegionMemory() : area_(ReserveRegionArea()) {
  static_assert((size_t{64} << (2 * kClasses)) / 3 * kSlots <= kRegionAreaBytes);
}

RegionMemory::~RegionMemory() {
  if (area_ == nullptr) return;
  munmap(area_, kRegionAreaBytes);
  GiveRegionArea(area_);
}

// Returns the cell, which is the memory for one region, that belongs to `slot` and `size_class`.
// Maps this memory first if it is not mapped yet.  Returns null if it cannot be mapped.
char* RegionMemory::MappedCell(int size_class, uint32_t slot) {
  const size_t cell = CellBytes(size_class);
  const size_t step = std::max(cell, kMapBytes);
  const size_t at = slot * cell;
  char* const begin = area_ + OffsetOf(size_class);
  std::vector<bool>& is_mapped = cells_[static_cast<size_t>(size_class)].is_mapped;
  if (!IsSet(is_mapped, at / step)) {
    if (!MapAt(begin + at / step * step, step)) return nullptr;
    Set(&is_mapped, at / step, true);
  }
  return begin + at;
}

char* RegionMemory::New(uint32_t slot, size_t bytes) {
  ASSERT(slot < kSlots, "slot {} of {}", slot, kSlots);
  int size_class = 0;
  while (size_class < kClasses && CellBytes(size_class) < bytes) ++size_class;
  if (area_ != nullptr && size_class < kClasses) {
    std::vector<bool>& in_use = cells_[static_cast<size_t>(size_class)].in_use;
    if (!IsSet(in_use, slot)) {
      char* const block = MappedCell(size_class, slot);
      if (block != nullptr) {
        RemoveFromKept({size_class, slot});
        Set(&in_use, slot, true);
        std::memset(block, 0, bytes);
        return block;
      }
    }
  }
  // Allocates at least 1 byte, because the result for a region of 0 bytes must not be null.
  return static_cast<char*>(std::calloc(1, std::max<size_t>(bytes, 1)));
}

void RegionMemory::Free(char* block) {
  if (area_ == nullptr || block < area_ || block >= area_ + kRegionAreaBytes) {
    std::free(block);
    return;
  }
  const auto offset = static_cast<size_t>(block - area_);
  int size_class = 0;
  while (size_class + 1 < kClasses && OffsetOf(size_class + 1) <= offset) ++size_class;
  const size_t cell = CellBytes(size_class);
  const size_t slot = (offset - OffsetOf(size_class)) / cell;
  std::vector<bool>& in_use = cells_[static_cast<size_t>(size_class)].in_use;
  ASSERT(IsSet(in_use, slot), "the block of slot {} is freed twice", slot);
  in_use[slot] = false;
  if (cell < kMapBytes) return;
  if (cell > kKeepBytes) {
    Unmap({size_class, static_cast<uint32_t>(slot)});
    return;
  }
  kept_.push_back({size_class, static_cast<uint32_t>(slot)});
  kept_bytes_ += cell;
  while (kept_bytes_ > kKeptBytesMax) {
    const Cell oldest = kept_.front();
    RemoveFromKept(oldest);
    Unmap(oldest);
  }
}

// Removes `cell` (memory for one region) from kept_, the list of free cells that stay mapped, if
// the list has this cell.
void RegionMemory::RemoveFromKept(const Cell& cell) {
  kept_bytes_ -= std::erase(kept_, cell) * CellBytes(cell.size_class);
}

// Unmaps `cell`, the memory for one region.  REQUIRES: the cell has kMapBytes or more, so that it
// was mapped as one piece and no other cell loses its memory.
void RegionMemory::Unmap(const Cell& cell) {
  const size_t bytes = CellBytes(cell.size_class);
  munmap(area_ + OffsetOf(cell.size_class) + cell.slot * bytes, bytes);
  cells_[static_cast<size_t>(cell.size_class)].is_mapped[cell.slot] = false;
}

}  // namespace openr_host
