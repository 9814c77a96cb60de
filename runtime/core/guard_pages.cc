#include "runtime/core/guard_pages.h"

#include <sys/mman.h>

#include <cstdint>
#include <cstring>

namespace openr_host {
namespace {

constexpr size_t kPage = 4096;

size_t Pages(size_t bytes) { return (bytes + kPage - 1) / kPage * kPage; }

}  // namespace

GuardPages::~GuardPages() {
  for (char* block : blocks_) munmap(block, kBlockBytes);
}

char* GuardPages::NewCopy(const char* data, size_t size) {
  // The low bits of the address stay: what was aligned at the sender is aligned here.
  const size_t shift = reinterpret_cast<uintptr_t>(data) % 16;
  const size_t bytes = Pages(shift + size + 1);
  if (bytes > kBlockBytes) return nullptr;
  if (used_ + bytes > kBlockBytes) {
    void* const block =
        mmap(nullptr, kBlockBytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (block == MAP_FAILED) return nullptr;
    blocks_.push_back(static_cast<char*>(block));
    used_ = 0;
  }
  char* const page = blocks_.back() + used_;
  used_ += bytes;
  mprotect(page, bytes, PROT_READ | PROT_WRITE);
  std::memcpy(page + shift, data, size);
  mprotect(page, bytes, PROT_READ);
  copies_[page + shift] = size;
  return page + shift;
}

void GuardPages::Retire(const char* copy) {
  const auto found = copies_.find(copy);
  if (found == copies_.end()) return;
  const size_t shift = reinterpret_cast<uintptr_t>(copy) % 16;
  char* const page = const_cast<char*>(copy) - shift;
  const size_t bytes = Pages(shift + found->second + 1);
  copies_.erase(found);
  madvise(page, bytes, MADV_DONTNEED);
  mprotect(page, bytes, PROT_NONE);
}

}  // namespace openr_host
