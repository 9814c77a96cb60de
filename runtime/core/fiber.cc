#include "runtime/core/fiber.h"

#include <cxxabi.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <boost/context/detail/fcontext.hpp>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "runtime/core/assert.h"

#if defined(__SANITIZE_ADDRESS__)
#define OPENR_ASAN 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define OPENR_ASAN 1
#endif
#endif
#ifdef OPENR_ASAN
#include <sanitizer/asan_interface.h>
#include <sanitizer/common_interface_defs.h>
#endif
#if __has_include(<valgrind/valgrind.h>)
#include <valgrind/valgrind.h>
#endif

namespace openr_host {

namespace context = boost::context::detail;

namespace {

constexpr size_t kGuardBytes = 4096;

// Who is being left, for the one being entered.
thread_local Fiber* t_left = nullptr;
thread_local Fiber* t_entered = nullptr;

// Those with a stack of their own that this thread made.
thread_local Fiber* t_newest = nullptr;

// Frames that were left and not returned from have marked their surroundings in
// AddressSanitizer's shadow; whoever gets these addresses next must not inherit that.
void ForgetFrames([[maybe_unused]] const void* bottom, [[maybe_unused]] size_t bytes) {
#ifdef OPENR_ASAN
  __asan_unpoison_memory_region(bottom, bytes);
#endif
}

// What no program leaves on a stack by accident.
constexpr uint64_t kPaint = 0x0f1e2d3c4b5a6978;

// Below its own frame a function may have this much without moving the stack pointer.
constexpr size_t kRedZoneBytes = 512;

[[maybe_unused]] uint64_t* AlignUp(char* address) {
  return reinterpret_cast<uint64_t*>((reinterpret_cast<uintptr_t>(address) + 7) & ~uintptr_t{7});
}

}  // namespace

Fiber::Fiber(NoStack) {}

Fiber::Fiber() {
  void* const mapping = mmap(nullptr, kGuardBytes + kStackBytes, PROT_READ | PROT_WRITE,
                             MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_STACK, -1, 0);
  ASSERT(mapping != MAP_FAILED, "no memory for a stack of {} bytes", kStackBytes);
  mapping_ = static_cast<char*>(mapping);
  mprotect(mapping_, kGuardBytes, PROT_NONE);
  stack_bottom_ = mapping_ + kGuardBytes;
  stack_bytes_ = kStackBytes;
#ifdef VALGRIND_STACK_REGISTER
  valgrind_id_ = VALGRIND_STACK_REGISTER(stack_bottom_, mapping_ + kGuardBytes + kStackBytes);
#endif
  older_ = std::exchange(t_newest, this);
}

Fiber::~Fiber() {
  if (mapping_ == nullptr) return;
  Fiber** link = &t_newest;
  while (*link != nullptr && *link != this) link = &(*link)->older_;
  if (*link != nullptr) *link = older_;
#ifdef VALGRIND_STACK_DEREGISTER
  VALGRIND_STACK_DEREGISTER(valgrind_id_);
#endif
  ForgetFrames(stack_bottom_, stack_bytes_);
  munmap(mapping_, kGuardBytes + kStackBytes);
}

bool Fiber::AnyGuardContains(const void* address) {
  const char* const p = static_cast<const char*>(address);
  for (const Fiber* each = t_newest; each != nullptr; each = each->older_) {
    if (p >= each->mapping_ && p < each->mapping_ + kGuardBytes) return true;
  }
  return false;
}

#ifdef OPENR_ASAN
void Fiber::Paint(char*) {}
size_t Fiber::UsedBelow(char*) { return 0; }
#else
// Valgrind holds what lies below the stack pointer for nobody's.  It loads something of its own
// into its client first; asking it needs its headers, which this may have been built without.
const bool g_is_under_valgrind = [] {
  const char* const preloaded = std::getenv("LD_PRELOAD");
  return preloaded != nullptr && std::strstr(preloaded, "vgpreload") != nullptr;
}();

// Calls nothing: what it paints is where a callee would stand.
__attribute__((noinline)) void Fiber::Paint(char* base) {
  if (g_is_under_valgrind) return;
  char* const bottom = std::max(mapping_ + kGuardBytes, base - kPaintBytes);
  const auto* const end = AlignUp(static_cast<char*>(__builtin_frame_address(0)) - kRedZoneBytes);
  volatile uint64_t* word = AlignUp(bottom);
  for (; word < end; ++word) *word = kPaint;
}

size_t Fiber::UsedBelow(char* base) {
  if (g_is_under_valgrind) return 0;
  constexpr ptrdiff_t kStride = 32;  // words compared at a time, without a branch
  const auto differs = [](const uint64_t* words) {
    uint64_t bits = 0;
    for (ptrdiff_t i = 0; i < kStride; ++i) bits |= words[i] ^ kPaint;
    return bits != 0;
  };
  const uint64_t* const end = AlignUp(base);
  const uint64_t* word = AlignUp(std::max(mapping_ + kGuardBytes, base - kPaintBytes));
  while (end - word >= kStride && !differs(word)) word += kStride;
  while (word < end && *word == kPaint) ++word;
  return static_cast<size_t>(base - reinterpret_cast<const char*>(word));
}
#endif

void Fiber::Prepare(Main main, void* argument) {
  ForgetFrames(stack_bottom_, stack_bytes_);
  main_ = main;
  argument_ = argument;
  exceptions_[0] = exceptions_[1] = nullptr;
  fake_stack_ = nullptr;
  const auto entry = [](context::transfer_t transfer) {
    t_left->context_ = transfer.fctx;
    Fiber* const self = t_entered;
    self->FinishSwitch();
    self->main_(self->argument_);
  };
  context_ = context::make_fcontext(mapping_ + kGuardBytes + kStackBytes, kStackBytes, entry);
}

void Fiber::SwitchFrom(Fiber* from) {
  static thread_local Fiber* const nowhere = new MainFiber;  // takes what is never returned to
  const bool forever = from == nullptr;
  if (forever) from = nowhere;
  void* const globals = abi::__cxa_get_globals();
  std::memcpy(from->exceptions_, globals, sizeof from->exceptions_);
  std::memcpy(globals, exceptions_, sizeof exceptions_);
  t_left = from;
  t_entered = this;
#ifdef OPENR_ASAN
  __sanitizer_start_switch_fiber(forever ? nullptr : &from->fake_stack_, stack_bottom_,
                                 stack_bytes_);
#endif
  const context::transfer_t transfer = context::jump_fcontext(context_, nullptr);
  // Here again: somebody switched to `from`.
  t_left->context_ = transfer.fctx;
  from->FinishSwitch();
}

void Fiber::FinishSwitch() {
#ifdef OPENR_ASAN
  const void* bottom = nullptr;
  size_t bytes = 0;
  __sanitizer_finish_switch_fiber(fake_stack_, &bottom, &bytes);
  // Only the thread's own stack has to be learnt.
  if (t_left->mapping_ == nullptr) {
    t_left->stack_bottom_ = bottom;
    t_left->stack_bytes_ = bytes;
  }
#endif
}

}  // namespace openr_host
