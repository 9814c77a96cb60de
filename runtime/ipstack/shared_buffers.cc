#include "runtime/ipstack/shared_buffers.h"

#include "runtime/base/hasher.h"

namespace openr_host {

antError SharedBuffers::Create(uint32_t bytes, ObjectId owner, antSharedBuffer* buffer) {
  if (bytes == 0) return ANT_FAIL;
  const uint64_t rounded = (uint64_t{bytes} + kPageBytes - 1) / kPageBytes * kPageBytes;
  if (bytes_ + rounded > kBytesMax) return ANT_NOMEMORY;
  const MemoryRegionID region = regions_->New(rounded, owner);
  if (region == RegionTable::kNoRegion) return ANT_NOMEMORY;
  bytes_ += rounded;
  const uint32_t cookie = ++last_cookie_;
  buffers_[cookie] = {region, static_cast<uint32_t>(rounded), owner, false};
  *buffer = antSharedBuffer(region, static_cast<uint32_t>(rounded), cookie);
  return ANT_SUCCESS;
}

void SharedBuffers::Adopt(const antSharedBuffer& buffer, ObjectId owner) {
  buffers_[buffer.GetCookie()] = {buffer.GetRegion(), buffer.GetSize(), owner, false};
}

SharedBuffers::Buffer* SharedBuffers::Find(const antSharedBuffer& buffer) {
  const auto found = buffers_.find(buffer.GetCookie());
  if (found == buffers_.end() || found->second.region != buffer.GetRegion()) return nullptr;
  return &found->second;
}

antError SharedBuffers::Destroy(const antSharedBuffer& buffer) {
  const Buffer* const known = Find(buffer);
  if (known == nullptr) return ANT_INVALIDPTR;
  if (known->mapped) return ANT_FAIL;
  regions_->Delete(known->region);
  bytes_ -= known->bytes;
  buffers_.erase(buffer.GetCookie());
  return ANT_SUCCESS;
}

antError SharedBuffers::Map(const antSharedBuffer& buffer, void** base) {
  Buffer* const known = Find(buffer);
  *base = known == nullptr ? nullptr : regions_->BaseOf(known->region);
  if (*base == nullptr) return ANT_INVALIDPTR;
  known->mapped = true;
  return ANT_SUCCESS;
}

antError SharedBuffers::UnMap(const antSharedBuffer& buffer) {
  Buffer* const known = Find(buffer);
  if (known == nullptr) return ANT_INVALIDPTR;
  known->mapped = false;
  return ANT_SUCCESS;
}

bool SharedBuffers::Contains(const void* begin, int64_t size) const {
  if (begin == nullptr || size <= 0) return false;
  const auto from = reinterpret_cast<uintptr_t>(begin);
  for (const auto& [cookie, buffer] : buffers_) {
    const auto base = reinterpret_cast<uintptr_t>(regions_->BaseOf(buffer.region));
    if (!buffer.mapped || base == 0 || from < base) continue;
    const uintptr_t offset = from - base;
    if (offset < buffer.bytes && static_cast<uint64_t>(size) <= buffer.bytes - offset) return true;
  }
  return false;
}

void SharedBuffers::ForgetObject(ObjectId owner) {
  for (auto it = buffers_.begin(); it != buffers_.end();) {
    if (it->second.owner != owner) {
      ++it;
      continue;
    }
    regions_->Delete(it->second.region);
    bytes_ -= it->second.bytes;
    it = buffers_.erase(it);
  }
}

void SharedBuffers::HashState(Hasher* hasher) const {
  hasher->Add(last_cookie_);
  for (const auto& [cookie, buffer] : buffers_) {
    hasher->Add(cookie);
    hasher->Add(buffer.bytes);
    hasher->Add(buffer.owner);
    hasher->Add(buffer.mapped);
  }
}

}  // namespace openr_host
