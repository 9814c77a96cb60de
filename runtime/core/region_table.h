// Shared memory of one System: every block that objects pass to each other.
//
// A MemoryRegionID is (generation << 16 | slot + 1), so an id outlives its block
// without ever naming another one by accident, and ids repeat exactly from run
// to run, and so do addresses (region_memory.h).  Fresh blocks are filled with zeros.  A few known
// bytes follow every block, so that a write behind its end shows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "runtime/core/message.h"
#include "runtime/core/region_memory.h"

namespace openr_host {

class Hasher;

class RegionTable {
 public:
  RegionTable() = default;
  ~RegionTable();
  RegionTable(const RegionTable&) = delete;
  RegionTable& operator=(const RegionTable&) = delete;

  static constexpr uint32_t kNoRegion = 0;

  // The block of an id given there; null when there is no memory.  One that belongs to an object
  // elsewhere is a copy and lasts while it is pinned, with KeepCopy() first of all; a later copy of
  // the same block may find the bytes of this one.
  char* AdoptOwn(uint32_t id, size_t size, ObjectId owner);
  char* AdoptCopy(uint32_t id, size_t size);
  void KeepCopy(uint32_t id);
  void DropCopy(uint32_t id);
  // An own block that was deleted there.
  void Lose(uint32_t id);

  // The block that `address` lies in; false when it lies in none.
  bool Locate(const void* address, uint32_t* id, size_t* offset) const;

  // A block of `size` bytes owned by `owner`; kNoRegion when there is no memory.
  uint32_t New(size_t size, ObjectId owner);

  // `address`: the instruction that made the block, for MostCommonPlace().
  void NotePlace(uint32_t id, const void* address);
  // The instruction that made most of the blocks there are, and how many; null when none was noted.
  std::pair<const void*, int> MostCommonPlace() const;

  // False when `id` names nothing.  The memory stays while somebody has it pinned.
  bool Delete(uint32_t id);

  // All blocks of an object that is being unloaded.
  void DeleteAllOf(ObjectId owner);

  // Null when `id` names nothing.
  char* BaseOf(uint32_t id) const;
  size_t SizeOf(uint32_t id) const;
  ObjectId OwnerOf(uint32_t id) const;
  // The object that had it made, whoever owns it now: the bytes are where that is.  kNoObject when
  // the block was deleted or its maker was unloaded.
  ObjectId MakerOf(uint32_t id) const;
  void SetOwner(uint32_t id, ObjectId owner);

  // Blocks stay where they are, so one grows no further than it was made.  False, and no
  // change, when it cannot have that size.
  bool Resize(uint32_t id, size_t size);

  // Whether somebody wrote behind the end of a block.  Never with AddressSanitizer, which
  // stops at such a write itself.
  bool WrittenBeyond(uint32_t id) const;

  // Keeps the memory of a block that somebody still reads.  Unknown ids are
  // ignored: a region may wrap memory that is not ours.
  bool Pin(uint32_t id);
  bool Unpin(uint32_t id);

  // Live blocks of one owner.
  int CountOf(ObjectId owner) const;
  int live_count() const { return live_count_; }

  // Calls `visit` for every live block of `owner`.
  void ForEachOf(ObjectId owner,
                 const std::function<void(uint32_t id, char* base, size_t size)>& visit) const;

  // Ids, owners, sizes and bytes of all live blocks.
  void HashState(Hasher* hasher) const;

 private:
  struct Slot {
    char* base = nullptr;
    size_t size = 0;
    ObjectId owner = kNoObject;
    ObjectId maker = kNoObject;
    const void* made_at = nullptr;  // see NotePlace()
    int pins = 0;
    uint16_t generation = 0;
    bool live = false;
    size_t capacity = 0;       // what it was made with
    bool is_reusable = false;  // New() chose the slot, so it may choose it again
    bool is_copy = false;
    bool is_idle = false;  // a copy without users: its memory is for the next one
  };

  Slot* FindMemory(uint32_t id);  // also of an idle copy
  Slot* Find(uint32_t id);
  const Slot* Find(uint32_t id) const { return const_cast<RegionTable*>(this)->Find(id); }
  void FreeIfUnused(Slot* slot);
  char* Fill(Slot* slot, uint32_t index, size_t size);
  uint32_t IndexOf(const Slot* slot) const { return static_cast<uint32_t>(slot - slots_.data()); }
  Slot* SlotFor(uint32_t id);

  RegionMemory memory_;
  std::vector<Slot> slots_;
  // Copies of blocks that are gone where they lived while somebody here still reads them: rare,
  // as when a subject is replaced whose observer has yet to answer.
  std::vector<char*> outlived_;
  std::vector<uint32_t> free_;  // indices
  int live_count_ = 0;
};

}  // namespace openr_host
