#include "runtime/base/hasher.h"

#include <xxhash.h>
// xxh_x86dispatch.h makes xxHash use the widest vector registers that the processor has.  The
// hashes stay the same.  Without this header, Debian's library uses the narrowest registers and
// takes 15 times as long for 64 kB.
#if defined(__x86_64__) && __has_include(<xxh_x86dispatch.h>)
#include <xxh_x86dispatch.h>
#endif

#include <new>

namespace openr_host {

Hasher::Hasher() : state_(XXH3_createState()) {
  if (state_ == nullptr) throw std::bad_alloc();
  XXH3_64bits_reset(state_);
}

Hasher::~Hasher() { XXH3_freeState(state_); }

void Hasher::AddBytes(const void* data, size_t size) {
  XXH3_64bits_update(state_, data, size);
  if (copy_ != nullptr) copy_->append(static_cast<const char*>(data), size);
}

void Hasher::AddText(std::string_view text) {
  Add(static_cast<uint64_t>(text.size()));
  AddBytes(text.data(), text.size());
}

uint64_t Hasher::Digest() const { return XXH3_64bits_digest(state_); }

uint64_t HashBytes(const void* data, size_t size) { return XXH3_64bits(data, size); }

}  // namespace openr_host
