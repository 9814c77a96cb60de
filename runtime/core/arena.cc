#include "runtime/core/arena.h"

#include <sys/mman.h>

#include <algorithm>
#include <bit>

#include "runtime/core/assert.h"

namespace openr_host {
namespace {

constexpr size_t kSpanBytes = size_t{1} << 20;
constexpr size_t kSpans = size_t{1} << 15;  // 32 GiB of addresses, none of them touched until used
constexpr size_t kLargest = 32 << 10;       // larger blocks get whole spans

// What a span holds.  For a large block the first span knows the length, the
// others are marked kInside.
struct Span {
  Arena* owner;
  int32_t size_class;  // kLarge, kInside, or a class
  uint32_t span_count;
};
constexpr int32_t kLarge = -1;
constexpr int32_t kInside = -2;

// The table of all spans of the process.  Touched from one thread at a time: only
// the thread that runs handlers allocates from arenas.
struct Range {
  char* base = nullptr;
  Span* spans = nullptr;
  size_t first_free = 0;  // no free span lies before it
  size_t spans_used = 0;  // no span at or after it was ever taken
};
constinit Range g_range;

void ReserveRange() {
  void* base = mmap(nullptr, kSpanBytes * (kSpans + 1), PROT_NONE,
                    MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  void* spans = mmap(nullptr, sizeof(Span) * kSpans, PROT_READ | PROT_WRITE,
                     MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  ASSERT(base != MAP_FAILED && spans != MAP_FAILED, "cannot reserve addresses for object heaps");
  const uintptr_t aligned =
      (reinterpret_cast<uintptr_t>(base) + kSpanBytes - 1) & ~(kSpanBytes - 1);
  g_range.base = reinterpret_cast<char*>(aligned);
  g_range.spans = static_cast<Span*>(spans);
}

// The first run of `count` free spans, made readable and writable; null when there is none.
char* TakeSpans(Arena* owner, size_t count, int32_t size_class) {
  if (g_range.base == nullptr) ReserveRange();
  size_t run = 0;
  for (size_t i = g_range.first_free; i < kSpans; ++i) {
    run = g_range.spans[i].owner == nullptr ? run + 1 : 0;
    if (run < count) continue;
    const size_t first = i + 1 - count;
    char* const base = g_range.base + first * kSpanBytes;
    if (mprotect(base, count * kSpanBytes, PROT_READ | PROT_WRITE) != 0) return nullptr;
    for (size_t k = first; k <= i; ++k) g_range.spans[k] = {owner, kInside, 0};
    g_range.spans[first] = {owner, size_class, static_cast<uint32_t>(count)};
    if (first == g_range.first_free) g_range.first_free = i + 1;
    g_range.spans_used = std::max(g_range.spans_used, i + 1);
    return base;
  }
  return nullptr;
}

void GiveSpans(size_t first, size_t count) {
  char* const base = g_range.base + first * kSpanBytes;
  madvise(base, count * kSpanBytes, MADV_DONTNEED);
  mprotect(base, count * kSpanBytes, PROT_NONE);
  for (size_t k = first; k < first + count; ++k) g_range.spans[k] = {};
  g_range.first_free = std::min(g_range.first_free, first);
}

// Classes 0..15: multiples of 16 up to 256; then four steps per doubling up to 32 KiB.
size_t SizeOfClass(int size_class) {
  if (size_class < 16) return static_cast<size_t>(size_class + 1) * 16;
  const int step = size_class - 16;
  const size_t base = size_t{256} << (step / 4);
  return base + base / 4 * static_cast<size_t>(step % 4 + 1);
}

int ClassOfSize(size_t size) {
  if (size <= 256) return size == 0 ? 0 : static_cast<int>((size - 1) / 16);
  const int doubling = std::bit_width(size - 1) - 9;  // 257..512 -> 0
  const size_t base = size_t{256} << doubling;
  return 16 + doubling * 4 + static_cast<int>((size - 1 - base) / (base / 4));
}

size_t IndexOf(const void* block) {
  return static_cast<size_t>(static_cast<const char*>(block) - g_range.base) / kSpanBytes;
}

}  // namespace

Arena::Arena(MemoryBudget* budget) : budget_(budget == nullptr ? &own_budget_ : budget) {}

Arena::~Arena() {
  budget_->used_bytes -= in_use_;
  for (size_t i = 0; i < g_range.spans_used; ++i) {
    const Span span = g_range.spans[i];
    if (span.owner == this && span.size_class != kInside) GiveSpans(i, span.span_count);
  }
}

bool Arena::MayTake(size_t size) {
  if (budget_->allocations_until_failure > 0 && --budget_->allocations_until_failure == 0)
    return false;
  return size <= budget_->limit_bytes && budget_->used_bytes <= budget_->limit_bytes - size;
}

void Arena::Account(size_t size) {
  in_use_ += size;
  budget_->used_bytes += size;
  in_use_max_ = std::max(in_use_max_, in_use_);
}

void* Arena::Allocate(size_t size, size_t alignment) {
  // Blocks of a power-of-two size class are aligned to their size within a span.
  if (alignment > 16) size = std::bit_ceil(std::max(size, alignment));
  if (!MayTake(size)) return nullptr;
  if (alignment > kSpanBytes) return nullptr;
  return size <= kLargest ? AllocateSmall(ClassOfSize(size)) : AllocateLarge(size);
}

void* Arena::AllocateSmall(int size_class) {
  const size_t size = SizeOfClass(size_class);
  void* block = free_[size_class];
  if (block != nullptr) {
    free_[size_class] = free_[size_class]->next;
  } else {
    if (bump_[size_class] == nullptr || bump_[size_class] + size > bump_end_[size_class]) {
      char* const span = TakeSpans(this, 1, size_class);
      if (span == nullptr) return nullptr;
      bump_[size_class] = span;
      bump_end_[size_class] = span + kSpanBytes;
    }
    block = bump_[size_class];
    bump_[size_class] += size;
  }
  Account(size);
  return block;
}

void* Arena::AllocateLarge(size_t size) {
  const size_t count = (size + kSpanBytes - 1) / kSpanBytes;
  if (count > kSpans) return nullptr;
  void* block = TakeSpans(this, count, kLarge);
  if (block != nullptr) Account(count * kSpanBytes);
  return block;
}

Arena* Arena::OwnerOf(const void* block) {
  const uintptr_t offset =
      reinterpret_cast<uintptr_t>(block) - reinterpret_cast<uintptr_t>(g_range.base);
  if (g_range.base == nullptr || offset >= kSpanBytes * kSpans) return nullptr;
  return g_range.spans[offset / kSpanBytes].owner;
}

size_t Arena::UsableSize(const void* block) {
  const Span& span = g_range.spans[IndexOf(block)];
  return span.size_class >= 0 ? SizeOfClass(span.size_class) : span.span_count * kSpanBytes;
}

void Arena::Free(void* block) { OwnerOf(block)->FreeFrom(block); }

void Arena::FreeFrom(void* block) {
  const size_t index = IndexOf(block);
  const Span span = g_range.spans[index];
  ASSERT(span.size_class != kInside, "free of an address inside a large block");
  const size_t size = UsableSize(block);
  in_use_ -= size;
  budget_->used_bytes -= size;
  if (span.size_class == kLarge) {
    GiveSpans(index, span.span_count);
    return;
  }
  FreeBlock* const free_block = static_cast<FreeBlock*>(block);
  free_block->next = free_[span.size_class];
  free_[span.size_class] = free_block;
}

}  // namespace openr_host
