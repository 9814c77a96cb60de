#include "tests/allocation/counted_allocations.h"

#include <cerrno>
#include <cstddef>

namespace {

int64_t g_count = 0;

}  // namespace

namespace openr_host {

int64_t AllocationCount() { return g_count; }

}  // namespace openr_host

#if defined(__SANITIZE_ADDRESS__)

// A function of AddressSanitizer, whose header g++ does not install.
extern "C" int __sanitizer_install_malloc_and_free_hooks(void (*on_malloc)(const volatile void*,
                                                                           size_t),
                                                         void (*on_free)(const volatile void*));

namespace {

[[gnu::constructor]] void CountByHook() {
  __sanitizer_install_malloc_and_free_hooks([](const volatile void*, size_t) { ++g_count; },
                                            [](const volatile void*) {});
}

}  // namespace

#else

// These definitions come before those of the runtime (runtime/hooks/heap_hooks.cc), so images would
// get memory of the host.  The tests of this program load none.
extern "C" {

void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void* __libc_memalign(size_t, size_t);

void* malloc(size_t size) {
  ++g_count;
  return __libc_malloc(size);
}

void* calloc(size_t count, size_t size) {
  ++g_count;
  return __libc_calloc(count, size);
}

void* realloc(void* block, size_t size) {
  ++g_count;
  return __libc_realloc(block, size);
}

void* memalign(size_t alignment, size_t size) {
  ++g_count;
  return __libc_memalign(alignment, size);
}

void* aligned_alloc(size_t alignment, size_t size) { return memalign(alignment, size); }

int posix_memalign(void** block, size_t alignment, size_t size) {
  void* const result = memalign(alignment, size);
  if (result == nullptr) return ENOMEM;
  *block = result;
  return 0;
}

}  // extern "C"

#endif
