#include "runtime/core/guard_pages.h"

#include <sys/mman.h>

#include <algorithm>
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
  for (const auto& [copy, pages] : copies_) munmap(PageOf(copy), pages.bytes);
  for (const auto& [kind, unused] : unused_) {
    for (char* const page : unused) munmap(page, kind.second);
  }
}

// Maps new writable pages in `area`, the memory area for the read-only copies that one object
// receives.  If `area` is null, the kernel chooses the addresses.  Returns null if no pages could
// be mapped.
char* GuardPages::MapPages(char* area, size_t bytes) {
  if (area == nullptr) {
    void* const pages =
        mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    return pages == MAP_FAILED ? nullptr : static_cast<char*>(pages);
  }
  size_t& next = next_in_[area];
  // Tries places in `area`, the memory for read-only copies, one after the other, until MapAt()
  // finds one where nothing is mapped, so that no copy in use is overwritten.  Begins behind the
  // newest copy, and goes on at the beginning of the area when its end is reached.
  for (size_t tried = 0; tried < ObjectAddresses::kCopyBytes; tried += bytes) {
    if (next + bytes > ObjectAddresses::kCopyBytes) next = 0;
    char* const pages = area + next;
    next += bytes;
    if (MapAt(pages, bytes)) return pages;
  }
  return nullptr;
}

// Returns writable pages for a new read-only copy of received data.  With GivenBack::kReused, uses
// the pages of a copy that was given back, if one of the same size exists.  Otherwise maps new
// pages.
char* GuardPages::AllocatePages(char* area, size_t bytes) {
  std::vector<char*>& unused = unused_[{area, bytes}];
  if (unused.empty()) return MapPages(area, bytes);
  char* const pages = unused.back();
  unused.pop_back();
  mprotect(pages, bytes, PROT_READ | PROT_WRITE);
  return pages;
}

char* GuardPages::NewCopy(const ObjectAddresses* place, const char* data, size_t size) {
  // Gives the read-only copy the same address modulo 16 as `data`, so that the observer sees data
  // with the same alignment as the subject.
  const size_t shift = reinterpret_cast<uintptr_t>(data) % 16;
  const size_t bytes = Pages(shift + size + 1);
  if (bytes > ObjectAddresses::kCopyBytes) return nullptr;
  char* const area = (place == nullptr ? shared_place_ : *place).copies();
  char* const page = AllocatePages(area, bytes);
  if (page == nullptr) return nullptr;
  std::memcpy(page + shift, data, size);
  mprotect(page, bytes, PROT_READ);
  copies_[page + shift] = {area, bytes};
  return page + shift;
}

void GuardPages::Retire(const char* copy) {
  const auto found = copies_.find(copy);
  if (found == copies_.end()) return;
  char* const page = PageOf(copy);
  const auto [area, bytes] = found->second;
  copies_.erase(found);
  if (given_back_ == GivenBack::kReused) {
    unused_[{area, bytes}].push_back(page);
  } else if (area != nullptr) {
    munmap(page, bytes);
  } else {
    // Gives the memory of the pages back to the kernel, but keeps the pages mapped without access,
    // so that a later access of the observer is a fault.  If the pages were unmapped, the kernel
    // could map other memory at their addresses, because these addresses are not planned
    // (address_plan.h).
    madvise(page, bytes, MADV_DONTNEED);
    mprotect(page, bytes, PROT_NONE);
  }
}

const char* GuardPages::FaultText(const void* address) const {
  const auto* const at = static_cast<const char*>(address);
  const bool is_ours = std::any_of(next_in_.begin(), next_in_.end(), [at](const auto& area) {
    return at >= area.first && at < area.first + ObjectAddresses::kCopyBytes;
  });
  if (!is_ours) return "";
  // Looks for `address`, to which an access was a fault, in the pages of the read-only copies that
  // are in use.  These pages can be read, so the access was a write.  All other pages of the area
  // may belong to copies that were given back; after this loop the function returns the text about
  // an access to them.
  for (const auto& [copy, pages] : copies_) {
    const char* const page = PageOf(copy);
    if (at >= page && at < page + pages.bytes)
      return "a write to received data, which are read-only";
  }
  return given_back_ == GivenBack::kGone
             ? "an access to data that were given back by AssertReady(), "
               "or beyond the end of received data"
             : "a write to received data, which are read-only";
}

}  // namespace openr_host
