// malloc(), free() and similar functions: code of an image allocates from the heap of its object,
// all other code from the heap of the C library.  free() finds out from a block's address to which
// heap the block belongs.
//
// A call from anywhere in the process goes to these functions instead of the functions of the C
// library.  Sanitizers have definitions of their own; with a sanitizer, objects share the host's
// heap.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(OPENR_NO_HEAP_HOOKS)

#include <fmt/format.h>
#include <malloc.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

#include "runtime/base/assert.h"
#include "runtime/core/address_plan.h"
#include "runtime/core/arena.h"
#include "runtime/core/code_place.h"
#include "runtime/core/current.h"
#include "runtime/core/object.h"
#include "runtime/core/system.h"
#include "runtime/hooks/hook.h"

using openr_host::Arena;
using openr_host::t_current;

extern "C" {
void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void* __libc_memalign(size_t, size_t);
void __libc_free(void*);
}

namespace {

Arena* CurrentArena() {
  return openr_host::InObject() ? t_current.object->memory().arena() : nullptr;
}

// Adds a finding that says why malloc() returns null to an object: how much memory the object asked
// for and how much memory it holds already.
void ReportNoMemory(size_t size) {
  // Takes memory for the text of the finding from the host's heap, because the object's heap is
  // full.
  const openr_host::ApiScope scope;
  const openr_host::Current& current = t_current;
  const openr_host::MemoryBudget& memory = current.system->robot(current.object->robot).memory;
  const size_t held = current.object->memory().arena()->bytes_in_use();
  const bool is_limited = memory.limit_bytes != SIZE_MAX;
  current.system->AddFinding(
      openr_host::Severity::kError,
      is_limited
          ? fmt::format(
                "no memory for {} bytes{}: this object holds {}, all objects {} of the {} the "
                "robot has; free what is not needed, or run without --strict",
                size, openr_host::AtCaller(), held, memory.used_bytes, memory.limit_bytes)
          : fmt::format("no memory for {} bytes{}: this object holds {} of the {} MiB that an "
                        "object may have here; the robot has {} MiB for all its objects",
                        size, openr_host::AtCaller(), held,
                        openr_host::ObjectAddresses::kHeapBytes >> 20,
                        openr_host::kRobotMemoryBytes >> 20));
}

// Records the calls in the object's code that led to the allocation of `block`, because the report
// of leaks names the place of these calls.
void NoteCalls(Arena* arena, const void* block) {
  const openr_host::ApiScope scope;
  arena->NoteCalls(block, openr_host::CallsInImage());
}

void* FromArena(Arena* arena, size_t size, size_t alignment = 16) {
  void* const block = arena->Allocate(size, alignment);
  if (block == nullptr) {
    ReportNoMemory(size);
    errno = ENOMEM;
  } else if (arena->keeps_calls()) {
    NoteCalls(arena, block);
  }
  return block;
}

// Returns whether an object frees `block`, an address that belongs to no heap of an object but to
// other memory of objects: an image, a stack or a region.  The C library would end the process.
bool IsOutsideOfHeaps(const void* block) {
  return openr_host::InObject() && openr_host::IsPlanned(block);
}

// Adds a finding about a call of free() for an address at which no block in use begins.
void ReportBadFree(const void* block) {
  const openr_host::ApiScope scope;
  const openr_host::Current& current = t_current;
  ASSERT(current.object != nullptr, "free of an address that no block begins at");
  const bool was_freed = Arena::OwnerOf(block) != nullptr && Arena::WasFreed(block);
  const char* const what = was_freed ? "a block is freed that was freed before"
                                     : "an address is freed that no block begins at";
  current.system->AddFinding(
      openr_host::Severity::kError,
      fmt::format("{}{}{}: on the robot this damages the heap without a word; here it changes "
                  "nothing",
                  openr_host::InHandler(), what, openr_host::AtCaller()));
}

void* Aligned(size_t alignment, size_t size) {
  Arena* const arena = CurrentArena();
  return arena == nullptr ? __libc_memalign(alignment, size) : FromArena(arena, size, alignment);
}

}  // namespace

extern "C" {

void* malloc(size_t size) {
  Arena* const arena = CurrentArena();
  if (arena == nullptr) [[likely]]
    return __libc_malloc(size);
  return FromArena(arena, size);
}

void free(void* block) {
  if (block == nullptr) return;
  if (Arena::OwnerOf(block) == nullptr) {
    if (IsOutsideOfHeaps(block)) [[unlikely]]
      return ReportBadFree(block);
    __libc_free(block);
  } else if (!Arena::Free(block)) {
    ReportBadFree(block);
  }
}

void* calloc(size_t count, size_t size) {
  Arena* const arena = CurrentArena();
  if (arena == nullptr) [[likely]]
    return __libc_calloc(count, size);
  size_t bytes = 0;
  if (__builtin_mul_overflow(count, size, &bytes)) {
    errno = ENOMEM;
    return nullptr;
  }
  // Returns the new block without clearing it, because every new block of an object's heap (Arena)
  // is filled with zeros already.
  return FromArena(arena, bytes);
}

void* realloc(void* block, size_t size) {
  if (block == nullptr) return malloc(size);
  const bool from_arena = Arena::OwnerOf(block) != nullptr;
  if (!from_arena && CurrentArena() == nullptr) [[likely]]
    return __libc_realloc(block, size);
  if (!from_arena && IsOutsideOfHeaps(block)) [[unlikely]] {
    ReportBadFree(block);
    errno = ENOMEM;
    return nullptr;
  }
  if (size == 0) {
    free(block);
    return nullptr;
  }
  // Takes the new block from the heap of the code that calls realloc().  So a block may move from
  // an object's heap to the host's heap, or back.  But a block of an object stays in place if it
  // does not grow and if its new size is more than half of its old size.
  const size_t old_size = from_arena ? Arena::UsableSize(block) : malloc_usable_size(block);
  if (from_arena && size <= old_size && size > old_size / 2) return block;
  void* const moved = malloc(size);
  if (moved == nullptr) return nullptr;
  std::memcpy(moved, block, old_size < size ? old_size : size);
  free(block);
  return moved;
}

void* memalign(size_t alignment, size_t size) { return Aligned(alignment, size); }
void* aligned_alloc(size_t alignment, size_t size) { return Aligned(alignment, size); }

int posix_memalign(void** block, size_t alignment, size_t size) {
  void* const result = Aligned(alignment, size);
  if (result == nullptr) return ENOMEM;
  *block = result;
  return 0;
}

}  // extern "C"

#endif
