#include "runtime/core/region_table.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "runtime/core/hasher.h"

namespace openr_host {
namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr size_t kGuardBytes = 0;
#else
constexpr size_t kGuardBytes = 16;
#endif
constexpr char kGuard = 0x5a;

}  // namespace

RegionTable::~RegionTable() {
  for (Slot& slot : slots_) std::free(slot.base);
}

uint32_t RegionTable::New(size_t size, ObjectId owner) {
  const size_t bytes = size + kGuardBytes;
  char* const base =
      bytes < size ? nullptr : static_cast<char*>(std::calloc(1, std::max<size_t>(bytes, 1)));
  if (base == nullptr) return kNoRegion;
  std::memset(base + size, kGuard, kGuardBytes);
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
  slot = {base, size, owner, 0, static_cast<uint16_t>(slot.generation + 1), true, size};
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

ObjectId RegionTable::OwnerOf(uint32_t id) const {
  const Slot* const slot = Find(id);
  return slot == nullptr ? kNoObject : slot->owner;
}

void RegionTable::SetOwner(uint32_t id, ObjectId owner) {
  if (Slot* const slot = Find(id)) slot->owner = owner;
}

bool RegionTable::Resize(uint32_t id, size_t size) {
  Slot* const slot = Find(id);
  if (slot == nullptr || size == 0 || size > slot->capacity) return false;
  slot->size = size;
  std::memset(slot->base + size, kGuard, kGuardBytes);
  return true;
}

bool RegionTable::WrittenBeyond(uint32_t id) const {
  const Slot* const slot = Find(id);
  if (slot == nullptr) return false;
  const char* const guard = slot->base + slot->size;
  return !std::all_of(guard, guard + kGuardBytes, [](char byte) { return byte == kGuard; });
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
