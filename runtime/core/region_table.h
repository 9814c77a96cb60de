// RegionTable: the regions of one System.  A region is a block of shared memory in which objects
// pass data to each other.
//
// A MemoryRegionID is (generation << 16 | slot + 1).  A later region in the same slot has another
// generation, so the id of a deleted region never names the later region.  Ids and addresses
// (region_memory.h) are the same in every run.  New regions are filled with zeros.  A few known
// bytes follow every region, so that a write beyond the end of the region can be found.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <utility>
#include <vector>

#include "runtime/core/message.h"
#include "runtime/core/region_memory.h"

namespace openr_host {

class Hasher;

class RegionTable {
 public:
  // `generation_max` is the number of regions that a slot has before the table uses another slot;
  // the tests choose a small number.
  explicit RegionTable(uint16_t generation_max = kGenerationMax)
      : generation_max_(generation_max) {}
  ~RegionTable();
  RegionTable(const RegionTable&) = delete;
  RegionTable& operator=(const RegionTable&) = delete;

  static constexpr uint32_t kNoRegion = 0;
  static constexpr uint16_t kGenerationMax = 0xffff;  // the generation has 16 bits of an id

  // Makes region `id` for an object in this process.  Used only in the table of a worker process,
  // for which the table of the master process has chosen the id.  Returns null if there is no
  // memory.
  char* AdoptOwn(uint32_t id, size_t size, ObjectId owner);
  // Returns memory for a copy of region `id` of another process; the caller puts the bytes into it.
  // Used only in the table of a worker process.  At first the memory holds zeros, or the bytes of
  // an earlier copy of the same region.  Returns null if there is no memory.
  //
  // The caller must call KeepCopy() at once.  After the last DropCopy() the memory may be used
  // again.
  char* AdoptCopy(uint32_t id, size_t size);
  void KeepCopy(uint32_t id) { Pin(id); }
  void DropCopy(uint32_t id) { Unpin(id); }
  // Removes region `id`, which AdoptOwn() has made for an object in this worker process, because
  // the master process has deleted the region.  The memory stays while the region is pinned
  // (Pin()).
  void RemoveAdopted(uint32_t id);

  // Finds the region in which `address` lies, and sets `*id` to the region's id and `*offset` to
  // the distance of `address` from the region's first byte.  Returns false if there is no such
  // region.
  bool Locate(const void* address, uint32_t* id, size_t* offset) const;

  // Makes a region of `size` bytes that `owner` owns, and returns the id of the region.  Returns
  // kNoRegion if there is no memory or no free slot.  An id names no second region until all
  // 65,535 x 65,535 ids were given, that is, for a year with a new region in every frame.
  uint32_t New(size_t size, ObjectId owner);

  // Records `address`, the instruction of a program that made region `id`, for MostCommonPlace().
  void NotePlace(uint32_t id, const void* address);
  // Returns the instruction that NotePlace() has recorded for region `id`; null if no instruction
  // was recorded.
  const void* PlaceOf(uint32_t id) const;
  // Returns whether `id` named a region that was deleted.
  bool WasDeleted(uint32_t id) const;
  // Returns the memory of the table itself.  The search for leaks leaves this memory out: it has
  // the address of every region, so every region would seem to be in use.
  std::pair<const void*, size_t> own_memory() const {
    return {slots_.data(), slots_.capacity() * sizeof(Slot)};
  }
  // Returns the instruction that made the most live regions, and the number of these regions.  The
  // instruction is null if none was recorded.
  std::pair<const void*, int> MostCommonPlace() const;

  // Deletes region `id`.  Returns false if `id` names no live region.  The memory stays while the
  // region is pinned (Pin()).
  bool Delete(uint32_t id);

  // Deletes all regions of the object `owner`, which has ended or is being replaced.
  void DeleteAllOf(ObjectId owner);

  // Returns the address of region `id`, or null if there is no such region.
  char* BaseOf(uint32_t id) const;
  // Returns the size of region `id`, or 0 if there is no such region.
  size_t SizeOf(uint32_t id) const;
  // Returns the owner of region `id`, or kNoObject if there is no such region.
  ObjectId OwnerOf(uint32_t id) const;
  // Returns the object that made the region, even if another object owns it now.  In a run with
  // several processes, the bytes of the region are in the process of this object.  Returns
  // kNoObject if the region was deleted, or if its maker has ended.  Also returns kNoObject for a
  // region that the constructors of a new image have made before the old object with the same id
  // has ended (EarlyWork), because this end is taken for the end of the maker.
  ObjectId MakerOf(uint32_t id) const;
  void SetOwner(uint32_t id, ObjectId owner);

  // Changes the size of a region.  A region keeps its address, so it cannot grow beyond its memory:
  // if `size` is more than the size with which the region was made, or 0, returns false and changes
  // nothing.
  bool Resize(uint32_t id, size_t size);

  // Returns whether a program has written beyond the end of region `id`: whether the guard bytes
  // behind the region have changed.  Always false with AddressSanitizer, which reports the write
  // itself.
  bool WrittenBeyond(uint32_t id) const;

  // Pin() keeps the memory of a region that is still being read; Unpin() ends this.  Both functions
  // return false for an unknown id.  An unknown id is no error, because an RCRegion may refer to
  // memory that is not in this table.
  bool Pin(uint32_t id) {
    Slot* const slot = Find(id);
    if (slot == nullptr) return false;
    ++slot->pins;
    return true;
  }
  bool Unpin(uint32_t id) {
    Slot* const slot = Find(id);
    if (slot == nullptr || slot->pins == 0) return false;
    if (--slot->pins == 0 && !slot->live) FreeIfUnused(slot);
    return true;
  }

  // Returns the number of live regions that `owner` owns.
  int CountOf(ObjectId owner) const;
  int live_count() const { return live_count_; }
  // Returns the number of slots with memory: those of live regions, of pinned regions, and of
  // copies of data from another process that nobody reads now (Slot::is_idle).
  int used_count() const;

  // Calls `visit` for every live region of `owner`.
  void ForEachOf(ObjectId owner,
                 const std::function<void(uint32_t id, char* base, size_t size)>& visit) const;

  // Adds the ids, owners, sizes and bytes of all live regions to the hash of the run's state.
  void HashState(Hasher* hasher) const;

 private:
  // A slot, the table's record of one region, fills one cache line, so that finding a region reads
  // memory once.
  struct alignas(64) Slot {
    // The id of the region in this slot; kNoRegion if the slot has no memory.  Also kNoRegion if
    // the slot has only a copy of a region of another process that no observer reads now
    // (`is_idle`).  Then RegionTable::Find() must not find the copy, because its bytes may be out
    // of date.
    uint32_t id = kNoRegion;
    int pins = 0;
    char* base = nullptr;
    size_t size = 0;
    ObjectId owner = kNoObject;
    ObjectId maker = kNoObject;
    const void* made_at = nullptr;  // the instruction that NotePlace() has recorded
    uint16_t generation = 0;
    bool live = false;         // true until the region is deleted; false for copies
    size_t capacity = 0;       // the size with which the region was made
    bool is_reusable = false;  // whether New() may choose this slot again
    bool is_copy = false;      // whether AdoptCopy() has made the region
    bool is_idle = false;      // true for a copy that nobody reads; its memory is kept for reuse
  };

  // Returns the slot that has memory for region `id`; null if there is none.  Unlike Find(), finds
  // also an idle copy (is_idle), that is, a copy of a region of another process that no observer
  // reads now, because AdoptCopy() uses its memory again.
  Slot* FindMemory(uint32_t id) {
    const uint32_t index = (id & 0xffff) - 1;
    if (index >= slots_.size()) return nullptr;
    Slot& slot = slots_[index];
    return slot.generation == id >> 16 && slot.base != nullptr ? &slot : nullptr;
  }
  // Returns the slot of region `id`; null if there is no such region.  Does not find a copy of a
  // region of another process that no observer reads now (is_idle): its bytes may be out of date,
  // and only its memory is kept for the next copy.
  Slot* Find(uint32_t id) {
    const uint32_t index = (id & 0xffff) - 1;
    if (index >= slots_.size() || slots_[index].id != id) return nullptr;
    return &slots_[index];
  }
  const Slot* Find(uint32_t id) const { return const_cast<RegionTable*>(this)->Find(id); }
  void FreeIfUnused(Slot* slot);
  char* Fill(Slot* slot, uint32_t index, size_t size);
  uint32_t IndexOf(const Slot* slot) const { return static_cast<uint32_t>(slot - slots_.data()); }
  // Returns the id of the region in slot number `index`.  `generation` counts the regions that this
  // slot has had, so that the id differs from those of earlier regions.
  static uint32_t IdOf(uint32_t index, uint16_t generation) {
    return static_cast<uint32_t>(generation) << 16 | (index + 1);
  }
  Slot* SlotFor(uint32_t id);

  RegionMemory memory_;
  std::vector<Slot> slots_;
  // Memory of copies of regions of another process that an observer still read when another region
  // got the slot of the copy.  This happens only if a subject is replaced while an observer in this
  // process still reads its data.  The memory is freed when the table is destroyed.
  std::vector<char*> pinned_deleted_;
  const uint16_t generation_max_;
  std::vector<uint32_t> free_;  // indices of the slots that New() may use again
  // Indices of the slots that have used up all their ids, in the order in which this happened.
  // New() uses such a slot again only if no other slot is left: its ids then name other regions
  // than before, but a program, or RegionShares, may still have an id of a deleted region.
  std::deque<uint32_t> used_up_;
  int live_count_ = 0;  // number of live regions
};

}  // namespace openr_host
