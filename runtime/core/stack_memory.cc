#include "runtime/core/stack_memory.h"

#include <fmt/format.h>
#include <sys/mman.h>

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>

#include "runtime/core/current.h"
#include "runtime/core/memory_tools.h"
#include "runtime/core/robot_fault.h"

#if __has_include(<valgrind/valgrind.h>)
#include <valgrind/valgrind.h>
#endif

namespace openr_host {
namespace {

thread_local StackMemory* t_newest = nullptr;

// Two words of 8 bytes.  Every x86-64 processor reads a TwoWords in one instruction, and computes
// `|` of two TwoWords in one instruction.  So IsZero(), which tests whether bytes are all zero, is
// fast.
using TwoWords = uint64_t __attribute__((vector_size(16)));

// The number of bytes that IsZero() tests together for zeros.  One test of many words is faster
// than a branch for each word.
constexpr size_t kStepBytes = 256;

bool IsZero(const char* bytes) {
  const auto* const words = reinterpret_cast<const TwoWords*>(bytes);
  TwoWords even = {}, odd = {};
  for (size_t i = 0; i < kStepBytes / sizeof(TwoWords); i += 2) {
    even |= words[i];
    odd |= words[i + 1];
  }
  even |= odd;
  return (even[0] | even[1]) == 0;
}

constexpr size_t kPageBytes = 4096;

// Returns a bit for each page of the stack that begins at `bottom`: whether the page has memory.
// The kernel gives memory to a page when the page is used for the first time; some kernels do so
// even if it is only read.  So reading all pages of a stack would cost memory that no handler has
// asked for.  If the kernel does not answer, all pages count as pages with memory.
uint64_t PagesWithMemory(char* bottom) {
  constexpr size_t kPages = StackMemory::kBytes / kPageBytes;
  static_assert(kPages == 64);
  unsigned char has_memory[kPages];
  if (mincore(bottom, StackMemory::kBytes, has_memory) != 0) return UINT64_MAX;
  uint64_t pages = 0;
  for (size_t i = 0; i < kPages; ++i) pages |= uint64_t{has_memory[i] & 1u} << i;
  return pages;
}

[[noreturn]] void ReportNoMemory() {
  const std::string why =
      fmt::format("this computer has no memory for a stack of {} bytes", StackMemory::kBytes);
  // While a handler runs, ends this handler as a crash of its object.  An exception would have to
  // pass through code of the object, so none is thrown.
  if (t_current.object != nullptr) StopAsTheRobotDoes(why);
  throw std::runtime_error(why);
}

}  // namespace

StackMemory::StackMemory(char* address) : mapping_(address) {
  if (address != nullptr && MapAt(address, ObjectAddresses::kStackBytes)) {
    mapped_bytes_ = ObjectAddresses::kStackBytes;
    bottom_ = mapping_ + kBottomOffset;
    mprotect(bottom_ - kGuardBytes, kGuardBytes, PROT_NONE);
  } else {
    void* const mapping = mmap(nullptr, mapped_bytes_, PROT_READ | PROT_WRITE,
                               MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_STACK, -1, 0);
    if (mapping == MAP_FAILED) ReportNoMemory();
    mapping_ = static_cast<char*>(mapping);
    bottom_ = mapping_ + kGuardBytes;
  }
  mprotect(mapping_, kGuardBytes, PROT_NONE);
#ifdef VALGRIND_STACK_REGISTER
  valgrind_id_ = VALGRIND_STACK_REGISTER(bottom(), top());
#endif
  older_ = std::exchange(t_newest, this);
}

StackMemory::~StackMemory() {
  StackMemory** link = &t_newest;
  while (*link != nullptr && *link != this) link = &(*link)->older_;
  // Removes this stack from the list of the stacks of this thread.  If another thread has made this
  // stack, the list does not contain the stack, and nothing is removed.
  if (*link != nullptr) *link = older_;
#ifdef VALGRIND_STACK_DEREGISTER
  VALGRIND_STACK_DEREGISTER(valgrind_id_);
#endif
  ForgetFrames();
  munmap(mapping_, mapped_bytes_);
}

void StackMemory::ForgetFrames() const {
  if (IsAddressSanitized())
    __asan_unpoison_memory_region(mapping_ + kGuardBytes, mapped_bytes_ - kGuardBytes);
}

size_t StackMemory::UsedBytes(size_t gap_bytes) const {
  if (IsStackWatched()) return 0;
  // If the gap is small, the search reads at most one page that was never used.  That costs less
  // than a call of the kernel.
  const bool skips_pages = gap_bytes > kSmallGapBytes;
  // A page that was seen once counts for ever, because mincore() says of pages in swap space that
  // they have no memory.
  if (skips_pages) known_pages_ |= PagesWithMemory(bottom());
  const char* lowest = top();
  for (const char* step = top(); step - bottom() >= static_cast<ptrdiff_t>(kStepBytes);) {
    step -= kStepBytes;
    const size_t page = static_cast<size_t>(step - bottom()) / kPageBytes;
    if (skips_pages && (known_pages_ >> page & 1) == 0) {
      step = bottom() + page * kPageBytes;
    } else if (!IsZero(step)) {
      lowest = step;
    }
    if (static_cast<size_t>(lowest - step) >= gap_bytes) break;
  }
  // `lowest` is now the beginning of the lowest piece of kStepBytes bytes that are not all zero.
  // Moves `lowest` up to the first byte in this piece that is not zero.
  uint64_t word = 0;
  while (lowest < top() && (std::memcpy(&word, lowest, sizeof word), word == 0))
    lowest += sizeof word;
  while (lowest < top() && *lowest == 0) ++lowest;
  return static_cast<size_t>(top() - lowest);
}

size_t StackMemory::Clear(size_t gap_bytes) {
  const size_t used = UsedBytes(gap_bytes);
  std::memset(top() - used, 0, used);
  return used;
}

std::vector<std::pair<const char*, size_t>> StackMemory::All() {
  std::vector<std::pair<const char*, size_t>> all;
  for (const StackMemory* each = t_newest; each != nullptr; each = each->older_) {
    all.emplace_back(each->bottom_, kBytes);
    const char* const imports = each->mapping_ + kGuardBytes;
    // If this stack is at a planned address, a second stack lies below it, for the functions that
    // the image imports.  Adds the second stack to the result (`all`) too.
    if (imports < each->bottom_)
      all.emplace_back(imports, static_cast<size_t>(each->bottom_ - kGuardBytes - imports));
  }
  return all;
}

bool StackMemory::AnyGuardContains(const void* address) {
  const char* const p = static_cast<const char*>(address);
  for (const StackMemory* each = t_newest; each != nullptr; each = each->older_) {
    if (p >= each->bottom_ - kGuardBytes && p < each->bottom_) return true;
    if (p >= each->mapping_ && p < each->mapping_ + kGuardBytes) return true;
  }
  return false;
}

}  // namespace openr_host
