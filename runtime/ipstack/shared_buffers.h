// The memory that objects share with the IPStack.
//
// Buffers are regions of the System's table, owned by the object that asked for them.
#pragma once

#include <antSharedBuffer.h>

#include <cstdint>
#include <map>

#include "runtime/core/region_table.h"

namespace openr_host {

class Hasher;

class SharedBuffers {
 public:
  explicit SharedBuffers(RegionTable* regions) : regions_(regions) {}

  static constexpr uint32_t kPageBytes = 4096;  // sizes are rounded up to it
  // One buffer, and all together.  The robot's limits are not known; this is more
  // than it has memory.
  static constexpr uint64_t kBytesMax = uint64_t{64} << 20;

  // ANT_FAIL for 0 bytes, ANT_NOMEMORY.
  antError Create(uint32_t bytes, ObjectId owner, antSharedBuffer* buffer);

  // ANT_INVALIDPTR for what is no buffer, ANT_FAIL while it is mapped.
  antError Destroy(const antSharedBuffer& buffer);

  // Mapping twice, and taking back what is not mapped, changes nothing.  `base`
  // becomes the address of the first byte.
  antError Map(const antSharedBuffer& buffer, void** base);
  antError UnMap(const antSharedBuffer& buffer);

  // Of a stack that stands for one in another process: what that one made and destroyed.
  void Adopt(const antSharedBuffer& buffer, ObjectId owner);
  void Forget(const antSharedBuffer& buffer) { buffers_.erase(buffer.GetCookie()); }

  // Whether `size` > 0 bytes from `begin` on lie wholly in one mapped buffer.
  bool Contains(const void* begin, int64_t size) const;

  // Frees all buffers of an object that is gone.
  void ForgetObject(ObjectId owner);

  size_t count() const { return buffers_.size(); }
  void HashState(Hasher* hasher) const;

 private:
  struct Buffer {
    MemoryRegionID region = 0;
    uint32_t bytes = 0;
    ObjectId owner = kNoObject;
    bool mapped = false;
  };

  // Null when `buffer` names none that lives.
  Buffer* Find(const antSharedBuffer& buffer);

  RegionTable* const regions_;
  std::map<uint32_t, Buffer> buffers_;  // by cookie
  uint32_t last_cookie_ = 0;
  uint64_t bytes_ = 0;
};

}  // namespace openr_host
