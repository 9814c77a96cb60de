#include "runtime/core/guard_pages.h"

#include <sys/mman.h>

#include <cstdint>
#include <cstring>

namespace openr_host {
namespace {

constexpr size_t kPage = 4096;

size_t Pages(size_t bytes) { return (bytes + kPage - 1) / kPage * kPage; }

char* PageOf(const char* copy) {
  return const_cast<char*>(copy) - reinterpret_cast<uintptr_t>(copy) % kPage;
}

}  // namespace

GuardPages::~GuardPages() {
  for (const auto& [copy, bytes] : copies_) munmap(PageOf(copy), bytes);
}

// Fresh pages; null when there are none.
char* GuardPages::MapPages(char* area, size_t bytes) {
  if (area == nullptr) {
    void* const pages =
        mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    return pages == MAP_FAILED ? nullptr : static_cast<char*>(pages);
  }
  size_t& next = next_in_[area];
  // A copy that is alive still may lie where the area is used again: the next pages are tried then.
  for (size_t tried = 0; tried < AddressPlace::kCopyBytes; tried += bytes) {
    if (next + bytes > AddressPlace::kCopyBytes) next = 0;
    char* const pages = area + next;
    next += bytes;
    if (MapAt(pages, bytes)) return pages;
  }
  return nullptr;
}

char* GuardPages::NewCopy(const AddressPlace* place, const char* data, size_t size) {
  // The low bits of the address stay: what was aligned at the sender is aligned here.
  const size_t shift = reinterpret_cast<uintptr_t>(data) % 16;
  const size_t bytes = Pages(shift + size + 1);
  if (bytes > AddressPlace::kCopyBytes) return nullptr;
  char* const page = MapPages((place == nullptr ? shared_place_ : *place).copies(), bytes);
  if (page == nullptr) return nullptr;
  std::memcpy(page + shift, data, size);
  mprotect(page, bytes, PROT_READ);
  copies_[page + shift] = bytes;
  return page + shift;
}

void GuardPages::Retire(const char* copy) {
  const auto found = copies_.find(copy);
  if (found == copies_.end()) return;
  char* const page = PageOf(copy);
  if (IsPlanned(page)) {
    munmap(page, found->second);
  } else {
    // The kernel would give these addresses to the next mapping, and the access would be missed.
    madvise(page, found->second, MADV_DONTNEED);
    mprotect(page, found->second, PROT_NONE);
  }
  copies_.erase(found);
}

}  // namespace openr_host
