#include "runtime/core/stack_memory.h"

#include <sys/mman.h>

#include <cstdint>
#include <cstring>
#include <utility>

#include "runtime/core/address_plan.h"
#include "runtime/core/assert.h"
#include "runtime/core/memory_tools.h"

#if __has_include(<valgrind/valgrind.h>)
#include <valgrind/valgrind.h>
#endif

namespace openr_host {
namespace {

thread_local StackMemory* t_newest = nullptr;

constexpr size_t kWordsAtATime = 32;  // looked at without a branch
constexpr size_t kStepBytes = kWordsAtATime * sizeof(uint64_t);

bool IsZero(const char* bytes) {
  const auto* const words = reinterpret_cast<const uint64_t*>(bytes);
  uint64_t bits = 0;
  for (size_t i = 0; i < kWordsAtATime; ++i) bits |= words[i];
  return bits == 0;
}

}  // namespace

StackMemory::StackMemory(char* address) : mapping_(address) {
  constexpr size_t kAllBytes = kGuardBytes + kBytes;
  static_assert(kAllBytes <= AddressPlace::kStackBytes);
  if (address == nullptr || !MapAt(address, kAllBytes)) {
    void* const mapping = mmap(nullptr, kAllBytes, PROT_READ | PROT_WRITE,
                               MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_STACK, -1, 0);
    ASSERT(mapping != MAP_FAILED, "no memory for a stack of {} bytes", kBytes);
    mapping_ = static_cast<char*>(mapping);
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
  if (*link != nullptr) *link = older_;
#ifdef VALGRIND_STACK_DEREGISTER
  VALGRIND_STACK_DEREGISTER(valgrind_id_);
#endif
  munmap(mapping_, kGuardBytes + kBytes);
}

void StackMemory::Clear(size_t gap_bytes) {
  if (IsStackWatched()) return;
  char* lowest = top();
  for (char* step = top(); step - bottom() >= static_cast<ptrdiff_t>(kStepBytes);) {
    step -= kStepBytes;
    if (!IsZero(step)) lowest = step;
    if (static_cast<size_t>(lowest - step) >= gap_bytes) break;
  }
  std::memset(lowest, 0, static_cast<size_t>(top() - lowest));
}

bool StackMemory::AnyGuardContains(const void* address) {
  const char* const p = static_cast<const char*>(address);
  for (const StackMemory* each = t_newest; each != nullptr; each = each->older_) {
    if (p >= each->mapping_ && p < each->bottom()) return true;
  }
  return false;
}

}  // namespace openr_host
