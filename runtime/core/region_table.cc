#include "runtime/core/region_table.h"

#include <cstdlib>

#include "runtime/core/hasher.h"

namespace openr_host {

RegionTable::~RegionTable() {
  for (Slot& slot : slots_) std::free(slot.base);
}

uint32_t RegionTable::New(size_t size, ObjectId owner) {
  char* const base = static_cast<char*>(std::calloc(1, size == 0 ? 1 : size));
  if (base == nullptr) return kNoRegion;
  if (free_.empty()) {
    if (slots_.size() >= 0xffff) {
      std::free(base);
      return kNoRegion;
    }
    free_.push_back(static_cast<uint32_t>(slots_.size()));
    slots_.emplace_back();
  }
  const uint32_t index = free_.back();
  free_.pop_back();
  Slot& slot = slots_[index];
  slot = {base, size, owner, 0, static_cast<uint16_t>(slot.generation + 1), true};
  ++live_count_;
  return static_cast<uint32_t>(slot.generation) << 16 | (index + 1);
}

RegionTable::Slot* RegionTable::Find(uint32_t id) {
  const uint32_t index = (id & 0xffff) - 1;
  if (index >= slots_.size()) return nullptr;
  Slot& slot = slots_[index];
  return slot.generation == id >> 16 && slot.base != nullptr ? &slot : nullptr;
}

void RegionTable::FreeIfUnused(Slot* slot) {
  if (slot->live || slot->pins > 0) return;
  std::free(slot->base);
  slot->base = nullptr;
  free_.push_back(static_cast<uint32_t>(slot - slots_.data()));
}

bool RegionTable::Delete(uint32_t id) {
  Slot* const slot = Find(id);
  if (slot == nullptr || !slot->live) return false;
  slot->live = false;
  --live_count_;
  FreeIfUnused(slot);
  return true;
}

void RegionTable::DeleteAllOf(ObjectId owner) {
  for (Slot& slot : slots_) {
    if (slot.base == nullptr || !slot.live || slot.owner != owner) continue;
    slot.live = false;
    --live_count_;
    FreeIfUnused(&slot);
  }
}

char* RegionTable::BaseOf(uint32_t id) const {
  const Slot* const slot = Find(id);
  return slot == nullptr ? nullptr : slot->base;
}

size_t RegionTable::SizeOf(uint32_t id) const {
  const Slot* const slot = Find(id);
  return slot == nullptr ? 0 : slot->size;
}

void RegionTable::Pin(uint32_t id) {
  if (Slot* const slot = Find(id)) ++slot->pins;
}

void RegionTable::Unpin(uint32_t id) {
  Slot* const slot = Find(id);
  if (slot == nullptr || slot->pins == 0) return;
  --slot->pins;
  FreeIfUnused(slot);
}

int RegionTable::CountOf(ObjectId owner) const {
  int count = 0;
  for (const Slot& slot : slots_) count += slot.live && slot.owner == owner;
  return count;
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
