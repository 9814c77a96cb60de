// Finds host addresses in messages: addresses of the C library, of the program or of the host's
// heap.
//
// Host addresses differ from process to process, so a payload that holds a host address changes the
// hashes of the run.  The memory of objects has planned addresses (address_plan.h), which do not
// differ.  Examples of host addresses are the address of a function of the C library, and the first
// bytes of every C++ object of a library class with virtual functions.
#pragma once

#include <cstddef>
#include <cstdint>

#include "runtime/core/current.h"
#include "runtime/core/message.h"
#include "runtime/core/object.h"

namespace openr_host {

class HostAddresses {
 public:
  // Reports `message` if it holds a host address and the current object (t_current), which posts
  // the message, is an image.
  void Check(const Message& message) {
    const Object* const sender = t_current.object;
    if (sender != nullptr && sender->is_image()) [[unlikely]]
      Report(message);
  }

  // Returns the offset in `data` of the first 8 aligned bytes that are a host address.  Returns -1
  // if there is no such address, and always with AddressSanitizer or ThreadSanitizer.  REQUIRES:
  // `data` is aligned to 8.
  //
  // A number is taken for a host address if it is in the range of host addresses and memory is
  // mapped there.  Other numbers can be in this range by chance.  After 64 numbers (our choice) in
  // the range where no memory is mapped, the function assumes that the program sends numbers of
  // this size, and returns -1 for the rest of the run.
  int64_t FindIn(const void* data, size_t size);

 private:
  static constexpr int kMissesMax = 64;

  void Report(const Message& message);
  bool IsMapped(uint64_t address);

  int misses_ = 0;
};

}  // namespace openr_host
