// The buffers that programs and the network stack share.  The stack sends an object's data from a
// shared buffer and writes received data into a shared buffer.
//
// Each buffer is a region of the System's table.  The owner of a buffer is the object that has
// asked for the buffer.
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

  // Size of a page; the sizes of buffers are rounded up to pages.
  static constexpr uint32_t kPageBytes = 4096;
  // The largest size of all shared buffers together.  The robot's limit is not known.  We allow
  // more than all memory of the robot, so that only a faulty program reaches the limit.
  static constexpr uint64_t kBytesMax = uint64_t{64} << 20;

  // Makes a shared buffer of `bytes` bytes.  Returns ANT_FAIL for 0 bytes, and ANT_NOMEMORY if all
  // shared buffers together would be larger than kBytesMax.
  antError Create(uint32_t bytes, ObjectId owner, antSharedBuffer* buffer);

  // Deletes a shared buffer.  Returns ANT_INVALIDPTR for an unknown buffer, and ANT_FAIL while the
  // buffer is mapped.
  antError Destroy(const antSharedBuffer& buffer);

  // Makes a shared buffer usable for the program and sets `*base` to the address of its first byte.
  // A second call for the same buffer changes nothing.
  antError Map(const antSharedBuffer& buffer, void** base);
  // Ends the use of a shared buffer that Map() has begun.  A second call for the same buffer
  // changes nothing.
  antError UnMap(const antSharedBuffer& buffer);

  // Adds a shared buffer to this table in a worker process, which runs objects outside of the
  // master process.  Called after the network stack, which runs in the master, has created the
  // buffer.
  void Adopt(const antSharedBuffer& buffer, ObjectId owner);
  // Removes a shared buffer from this table in a worker process.  Called after the network stack in
  // the master has destroyed the buffer.
  void Forget(const antSharedBuffer& buffer) { buffers_.erase(buffer.GetCookie()); }

  // Returns whether `size` bytes from `begin` on lie inside one mapped shared buffer, and `size` >
  // 0.
  bool Contains(const void* begin, int64_t size) const;

  // Deletes all shared buffers of an object that has ended.
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

  // Returns the entry for `buffer` in this table of shared buffers; null if the table does not have
  // the buffer.
  Buffer* Find(const antSharedBuffer& buffer);

  RegionTable* const regions_;
  std::map<uint32_t, Buffer> buffers_;  // the key is the cookie, the number of a buffer
  uint32_t last_cookie_ = 0;
  uint64_t bytes_ = 0;
};

}  // namespace openr_host
