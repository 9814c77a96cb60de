#include "runtime/core/region_table.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "runtime/core/memory_tools.h"

namespace openr_host {
namespace {

// The number of guard bytes behind each region.  They have the known value kGuard, so a write
// beyond the end of the region is found.  With AddressSanitizer there are none, because
// AddressSanitizer itself reports the write.
const size_t kGuardBytes = IsAddressSanitized() ? 0 : 16;
// Copies of other processes' regions: their memory is kept for the next copy.  With
// AddressSanitizer a copy is freed as soon as no observer reads it, so that AddressSanitizer
// reports later reads of the copy.
const bool kReusesCopies = !IsAddressSanitized();
constexpr char kGuard = 0x5a;

}  // namespace

RegionTable::~RegionTable() {
  for (const Slot& slot : slots_) memory_.Free(slot.base);
  for (char* const block : pinned_deleted_) memory_.Free(block);
}

// Gives `slot`, the slot with the number `index`, new memory: `size` bytes for a region, and behind
// them a few guard bytes (kGuard), by which a write beyond the end of the region is found.  If
// there is no memory, returns null and leaves `slot` unchanged.
char* RegionTable::Fill(Slot* slot, uint32_t index, size_t size) {
  const size_t bytes = size + kGuardBytes;
  char* const base = bytes < size ? nullptr : memory_.New(index, bytes);
  if (base == nullptr) return nullptr;
  std::memset(base + size, kGuard, kGuardBytes);
  slot->base = base;
  slot->size = slot->capacity = size;
  return base;
}

uint32_t RegionTable::New(size_t size, ObjectId owner) {
  Slot fresh;
  // Makes no more slots than an id can name, because the id of a region has 16 bits for the slot.
  if (free_.empty() && slots_.size() >= 0xffff) {
    if (used_up_.empty()) return kNoRegion;
    free_.push_back(used_up_.front());
    used_up_.pop_front();
  }
  // Allocates the memory of the new region before the table gets a new slot, so that the table does
  // not change if there is no memory.
  const auto next = static_cast<uint32_t>(slots_.size());
  if (Fill(&fresh, free_.empty() ? next : free_.back(), size) == nullptr) return kNoRegion;
  if (free_.empty()) {
    free_.push_back(next);
    slots_.emplace_back();
  }
  const uint32_t index = free_.back();
  free_.pop_back();
  Slot& slot = slots_[index];
  fresh.owner = fresh.maker = owner;
  fresh.generation = static_cast<uint16_t>(slot.generation % generation_max_ + 1);
  fresh.live = fresh.is_reusable = true;
  fresh.id = IdOf(index, fresh.generation);
  slot = fresh;
  ++live_count_;
  return slot.id;
}

// Empties the slot that `id` names, for a new region with this id, which the master process has
// chosen.  Frees the old memory of the slot; but if the memory is pinned, because an observer still
// reads it, moves it to pinned_deleted_.  Returns null if the slot has a live region, or if `id`
// names no slot.
RegionTable::Slot* RegionTable::SlotFor(uint32_t id) {
  // The lower 16 bits of an id are the number of its slot, counted from 1; 0 names no slot.
  if ((id & 0xffff) == 0) return nullptr;
  const uint32_t index = (id & 0xffff) - 1;
  if (index >= slots_.size()) slots_.resize(index + 1);
  Slot& slot = slots_[index];
  if (slot.live) return nullptr;
  if (slot.pins > 0) {
    pinned_deleted_.push_back(slot.base);
  } else {
    memory_.Free(slot.base);
  }
  slot = Slot();
  slot.generation = static_cast<uint16_t>(id >> 16);
  return &slot;
}

char* RegionTable::AdoptOwn(uint32_t id, size_t size, ObjectId owner) {
  Slot* const slot = SlotFor(id);
  if (slot == nullptr || Fill(slot, IndexOf(slot), size) == nullptr) return nullptr;
  slot->id = id;
  slot->owner = owner;
  slot->live = true;
  ++live_count_;
  return slot->base;
}

// Returns memory of `size` bytes for a copy of region `id` of another process, or null if there is
// no memory.  The memory of the last copy is used again if it has the same size.  This saves time,
// because a subject sends the same few regions again and again.
char* RegionTable::AdoptCopy(uint32_t id, size_t size) {
  Slot* slot = FindMemory(id);
  if (slot != nullptr && slot->is_idle && slot->capacity == size) {
    slot->is_idle = false;
    slot->id = id;
    slot->size = size;
    // Writes the guard bytes (with the known value kGuard) behind the region again.  A program that
    // wrote beyond the end of the last copy in this memory may have changed them.
    std::memset(slot->base + size, kGuard, kGuardBytes);
    return slot->base;
  }
  slot = SlotFor(id);
  if (slot == nullptr || Fill(slot, IndexOf(slot), size) == nullptr) return nullptr;
  slot->is_copy = true;
  slot->id = id;
  return slot->base;
}

void RegionTable::RemoveAdopted(uint32_t id) {
  Slot* const slot = Find(id);
  if (slot == nullptr || !slot->live) return;
  slot->live = false;
  --live_count_;
  FreeIfUnused(slot);
}

bool RegionTable::Locate(const void* address, uint32_t* id, size_t* offset) const {
  const auto at = reinterpret_cast<uintptr_t>(address);
  for (const Slot& slot : slots_) {
    const auto base = reinterpret_cast<uintptr_t>(slot.base);
    if (base == 0 || slot.is_idle || at < base || at - base >= slot.size) continue;
    *id = slot.id;
    *offset = at - base;
    return true;
  }
  return false;
}

void RegionTable::FreeIfUnused(Slot* slot) {
  ASSERT(live_count_ >= 0 && slot->pins >= 0, "{} live blocks, {} pins", live_count_, slot->pins);
  if (slot->live || slot->pins > 0) return;
  slot->id = kNoRegion;
  if (kReusesCopies && slot->is_copy) {
    slot->is_idle = true;
    return;
  }
  memory_.Free(slot->base);
  slot->base = nullptr;
  if (!slot->is_reusable) return;
  if (slot->generation < generation_max_) {
    free_.push_back(IndexOf(slot));
  } else {
    used_up_.push_back(IndexOf(slot));
  }
}

void RegionTable::NotePlace(uint32_t id, const void* address) {
  if (Slot* const slot = Find(id)) slot->made_at = address;
}

const void* RegionTable::PlaceOf(uint32_t id) const {
  const Slot* const slot = Find(id);
  return slot == nullptr ? nullptr : slot->made_at;
}

bool RegionTable::WasDeleted(uint32_t id) const {
  const uint32_t index = (id & 0xffff) - 1;
  if (index >= slots_.size()) return false;
  const Slot& slot = slots_[index];
  const uint32_t generation = id >> 16;
  // The generation of a slot counts the regions that the slot has had.  An id with a smaller
  // generation than that of its slot names an earlier region of the slot, which was deleted.
  return slot.is_reusable && generation > 0 &&
         (generation < slot.generation || (generation == slot.generation && !slot.live));
}

std::pair<const void*, int> RegionTable::MostCommonPlace() const {
  // Counts how many regions each instruction has made.  The order of the counts is that in which
  // the slots name the instructions.  The order of the instructions' addresses would differ from
  // run to run, and so would the choice between two equal counts.
  std::vector<std::pair<const void*, int>> counts;
  for (const Slot& slot : slots_) {
    if (!slot.live || slot.made_at == nullptr) continue;
    const auto known = std::find_if(counts.begin(), counts.end(), [&slot](const auto& count) {
      return count.first == slot.made_at;
    });
    if (known == counts.end()) {
      counts.emplace_back(slot.made_at, 1);
    } else {
      ++known->second;
    }
  }
  const auto most =
      std::max_element(counts.begin(), counts.end(),
                       [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == counts.end() ? std::pair<const void*, int>() : *most;
}

bool RegionTable::Delete(uint32_t id) {
  Slot* const slot = Find(id);
  if (slot == nullptr || !slot->live) return false;
  slot->live = false;
  slot->maker = kNoObject;
  --live_count_;
  FreeIfUnused(slot);
  return true;
}

void RegionTable::DeleteAllOf(ObjectId owner) {
  for (Slot& slot : slots_) {
    if (slot.maker == owner) slot.maker = kNoObject;
    if (slot.base == nullptr || !slot.live || slot.owner != owner) continue;
    slot.live = false;
    --live_count_;
    FreeIfUnused(&slot);
  }
}

int RegionTable::used_count() const {
  return static_cast<int>(std::count_if(slots_.begin(), slots_.end(),
                                        [](const Slot& slot) { return slot.base != nullptr; }));
}

char* RegionTable::BaseOf(uint32_t id) const {
  const Slot* const slot = Find(id);
  return slot == nullptr ? nullptr : slot->base;
}

size_t RegionTable::SizeOf(uint32_t id) const {
  const Slot* const slot = Find(id);
  return slot == nullptr ? 0 : slot->size;
}

ObjectId RegionTable::OwnerOf(uint32_t id) const {
  const Slot* const slot = Find(id);
  return slot == nullptr ? kNoObject : slot->owner;
}

ObjectId RegionTable::MakerOf(uint32_t id) const {
  const Slot* const slot = Find(id);
  return slot == nullptr ? kNoObject : slot->maker;
}

void RegionTable::SetOwner(uint32_t id, ObjectId owner) {
  Slot* const slot = Find(id);
  if (slot == nullptr) return;
  slot->owner = owner;
}

bool RegionTable::Resize(uint32_t id, size_t size) {
  Slot* const slot = Find(id);
  if (slot == nullptr || size == 0 || size > slot->capacity) return false;
  slot->size = size;
  // Writes the guard bytes, which reveal a write beyond the end of the region, at the new end of
  // the region.
  std::memset(slot->base + size, kGuard, kGuardBytes);
  return true;
}

bool RegionTable::WrittenBeyond(uint32_t id) const {
  const Slot* const slot = Find(id);
  if (slot == nullptr) return false;
  const char* const guard = slot->base + slot->size;
  return !std::all_of(guard, guard + kGuardBytes, [](char byte) { return byte == kGuard; });
}

int RegionTable::CountOf(ObjectId owner) const {
  int count = 0;
  for (const Slot& slot : slots_) count += slot.live && slot.owner == owner;
  return count;
}

void RegionTable::ForEachOf(ObjectId owner,
                            const std::function<void(uint32_t, char*, size_t)>& visit) const {
  for (const Slot& slot : slots_) {
    if (!slot.live || slot.owner != owner) continue;
    visit(slot.id, slot.base, slot.size);
  }
}

void RegionTable::HashState(Hasher* hasher) const {
  for (size_t i = 0; i < slots_.size(); ++i) {
    const Slot& slot = slots_[i];
    if (!slot.live) continue;
    hasher->Add(static_cast<uint32_t>(i));
    hasher->Add(slot.generation);
    hasher->Add(slot.owner);
    hasher->Add(static_cast<uint64_t>(slot.size));
    hasher->AddBytes(slot.base, slot.size);
  }
}

}  // namespace openr_host
