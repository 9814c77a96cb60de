#include "runtime/core/handler_watch.h"

#include <dlfcn.h>
#include <link.h>

#include <algorithm>
#include <cstring>

#include "runtime/core/fp_flags.h"
#include "runtime/core/memory_tools.h"
#include "runtime/core/stack_memory.h"

namespace openr_host {
namespace {

// Zero, which is what the stack of handlers is full of when they begin (handler_stack.h).  So a
// program that reads what it never set reads the same, measured or not; zeros that a function has
// written are not seen, if nothing else was written below them.
constexpr uint64_t kPaint = 0;

// Room for the frame of the function that paints, and for what it keeps below its stack pointer.
constexpr size_t kOwnFrameBytes = 256;

constexpr size_t kDepthMin = size_t{32} << 10;
constexpr size_t kDepthMax = size_t{160} << 10;
static_assert(kDepthMax + (size_t{32} << 10) <= StackMemory::kBytes);

// Frame pointer and return address lie between a frame address and the caller's frame.
constexpr size_t kLinkBytes = 2 * sizeof(void*);

bool g_catches_numbers = false;

uint64_t* AlignUp(char* address) {
  return reinterpret_cast<uint64_t*>((reinterpret_cast<uintptr_t>(address) + 7) & ~uintptr_t{7});
}

// The first word that is not painted; `end` if there is none.
uint64_t* FindUsed(uint64_t* word, uint64_t* end) {
  constexpr ptrdiff_t kStride = 32;  // words compared at a time, without a branch
  const auto differs = [](const uint64_t* words) {
    uint64_t bits = 0;
    for (ptrdiff_t i = 0; i < kStride; ++i) bits |= words[i] ^ kPaint;
    return bits != 0;
  };
  while (end - word >= kStride && !differs(word)) word += kStride;
  while (word < end && *word == kPaint) ++word;
  return std::min(word, end);
}

// Whether `word` is an address in one of the C and C++ libraries.
bool IsOfLibrary(uint64_t word) {
  constexpr uint64_t kFirst = 0x10000, kLast = (uint64_t{1} << 47) - 1;  // of a program
  dl_find_object found{};
  if (word < kFirst || word > kLast || _dl_find_object(reinterpret_cast<void*>(word), &found) != 0)
    return false;
  for (const char* name : {"/libstdc++.so", "/libc.so", "/libm.so", "/libgcc_s.so", "/ld-linux"}) {
    if (std::strstr(found.dlfo_link_map->l_name, name) != nullptr) return true;
  }
  return false;
}

// Whether what was written from `begin` on are frames of such a library, of a function that is not
// announced: streams, sorting, and the loader, which binds a function at its first call.  They have
// left addresses of their own there.
bool IsLeftByLibrary(const uint64_t* begin, const char* end) {
  constexpr ptrdiff_t kWords = 512;  // 4 KiB: longer than their longest frame
  const auto* const last = std::min(begin + kWords, reinterpret_cast<const uint64_t*>(end));
  return std::any_of(begin, std::max(begin, last), &IsOfLibrary);
}

// Calls nothing, in no build: it writes where a callee's frame would be.
[[gnu::always_inline]] inline void Paint(uint64_t* begin, uint64_t* end) {
  for (volatile uint64_t* word = begin; word < end; ++word) *word = kPaint;
}

}  // namespace

size_t HandlerWatch::DepthFor(size_t stack_bytes) {
  constexpr size_t kBeyond = 1024;  // more than twice the size must be seen
  return std::clamp(2 * stack_bytes + kBeyond, kDepthMin, kDepthMax);
}

void HandlerWatch::SetCatchesNumbers(bool on) { g_catches_numbers = on; }

// Valgrind's processor raises no SIGFPE and complains.
bool HandlerWatch::CatchesNumbers() { return g_catches_numbers && CanMeasure(); }

bool HandlerWatch::CanMeasure() { return !IsStackWatched(); }

__attribute__((noinline)) void HandlerWatch::Begin(void* base, unsigned kinds) {
  base_ = low_ = static_cast<char*>(base);
  bottom_ = base_ - depth_;
  if (depth_ > 0) {
    clean_end_ = AlignUp(static_cast<char*>(__builtin_frame_address(0)) - kOwnFrameBytes);
    Paint(AlignUp(bottom_), clean_end_);
  }
  kinds_ = kinds;
  CatchFp(kinds_);
}

// The function called has written to its own frame already, and this one has: only what lies below
// both can have been written by the image, in a call that went deeper.
__attribute__((noinline)) void HandlerWatch::Enter(void* frame) {
  if (++calls_ > 1) return;
  if (depth_ > 0) {
    char* const used = static_cast<char*>(frame) + kLinkBytes;
    uint64_t* const end = AlignUp(static_cast<char*>(__builtin_frame_address(0)) - kOwnFrameBytes);
    if (used <= base_ && static_cast<size_t>(base_ - used) < StackMemory::kBytes) {
      uint64_t* const scan_end = std::min(clean_end_, end);
      uint64_t* const found = FindUsed(AlignUp(bottom_), scan_end);
      if (found < scan_end && !IsLeftByLibrary(found, low_))
        low_ = std::min(low_, reinterpret_cast<char*>(found));
      low_ = std::max(std::min(low_, used), bottom_);
    }
  }
  if (kinds_ != 0) {
    saved_fp_ = FpState();
    CatchFp(0);
  }
}

__attribute__((noinline)) void HandlerWatch::Leave() {
  if (--calls_ > 0) return;
  if (depth_ > 0) {
    char* const here = static_cast<char*>(__builtin_frame_address(0));
    if (here <= base_ && here > bottom_) {
      uint64_t* const end = std::max(AlignUp(here - kOwnFrameBytes), AlignUp(bottom_));
      Paint(FindUsed(AlignUp(bottom_), end), end);
      clean_end_ = end;
    }
  }
  if (kinds_ != 0) SetFpState(saved_fp_);
}

void HandlerWatch::End() { CatchFp(0); }

size_t HandlerWatch::Used() {
  if (depth_ == 0 || base_ == nullptr) return 0;
  uint64_t* const found = FindUsed(AlignUp(bottom_), clean_end_);
  if (found < clean_end_ && !IsLeftByLibrary(found, low_))
    low_ = std::min(low_, reinterpret_cast<char*>(found));
  return static_cast<size_t>(base_ - low_);
}

}  // namespace openr_host
