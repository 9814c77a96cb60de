#include "runtime/core/address_plan.h"

#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cstdint>

#include "runtime/base/assert.h"
#include "runtime/core/memory_map.h"

#ifndef MAP_FIXED_NOREPLACE
#define MAP_FIXED_NOREPLACE 0x100000
#endif

namespace openr_host {
namespace {

constexpr uintptr_t kTiB = uintptr_t{1} << 40;
constexpr uintptr_t kAreaBytes = 12 * kTiB;
constexpr uintptr_t kFirstArea = 2 * kTiB;
// The first address of the address plan after a call of UseOtherAddresses(); otherwise the plan
// begins at kFirstArea.  The two areas may overlap, because a process uses only one of them.
constexpr uintptr_t kOtherArea = 5 * kTiB;

// Offsets of the ranges (heaps, images ...) from the first address of the address plan, which is
// kFirstArea or kOtherArea.
constexpr uintptr_t kHeaps = 0;
constexpr uintptr_t kImages = 4 * kTiB;
constexpr uintptr_t kStacks = 4 * kTiB + kTiB / 2;
constexpr uintptr_t kRegions = 5 * kTiB;
constexpr uintptr_t kCopies = 8 * kTiB;
constexpr size_t kRegionAreas = 2;
constexpr size_t kImageStride = ObjectAddresses::kImageBytes + ObjectAddresses::kThunkBytes;

static_assert(kHeaps + ObjectAddresses::kPlaces * ObjectAddresses::kHeapBytes <= kImages);
static_assert(kImages + ObjectAddresses::kPlaces * kImageStride <= kStacks);
static_assert(kStacks + ObjectAddresses::kPlaces * 2 * ObjectAddresses::kStackBytes <= kRegions);
static_assert(kRegions + kRegionAreas * kRegionAreaBytes <= kCopies);
static_assert(kCopies + ObjectAddresses::kPlaces * ObjectAddresses::kCopyBytes <= kAreaBytes);

// The address plan of this process: its first address, and the places of objects and areas for
// regions that are taken.  It has no lock, because only the thread that makes Systems uses it.
struct Plan {
  uintptr_t area = 0;  // first address of the address plan; 0 if addresses are not planned
  std::array<bool, ObjectAddresses::kPlaces> taken = {};
  std::array<bool, kRegionAreas> regions_taken = {};
};

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__x86_64__)
constexpr bool kIsPlanned = false;
#else
constexpr bool kIsPlanned = true;
#endif

// Returns whether no memory is mapped in the area of kAreaBytes bytes that begins at `area`.  Linux
// leaves these addresses empty, but a tool that runs this program, such as an emulator, may use
// them.  Then this process works without the address plan, and the kernel chooses all addresses.
bool IsEmpty(uintptr_t area) {
  MemoryMap map;
  bool is_empty = true;
  for (MappedRange range; is_empty && map.Next(&range);)
    is_empty = range.end <= area || range.begin >= area + kAreaBytes;
  return is_empty;
}

// Returns whether memory can be mapped at both ends of the area of kAreaBytes bytes that begins at
// `area`.  On a machine whose addresses have too few bits, this fails, and this process works
// without the address plan.
bool IsReachable(uintptr_t area) {
  constexpr size_t kPage = 4096;
  for (const uintptr_t address : {area, area + kAreaBytes - kPage}) {
    char* const page = reinterpret_cast<char*>(address);
    if (!MapAt(page, kPage)) return false;
    munmap(page, kPage);
  }
  return true;
}

// A copy of Plan::area, the first address of the address plan; 0 until the first System is made.
// The copy is a plain variable, because free() reads it for every block and must not take long.
constinit uintptr_t g_area = 0;

// Returns the address plan of this process.  The plan is never deleted, because a static object of
// the program may hold a System.  When the program ends, this System still gives its places back to
// the plan.
Plan& SharedPlan() {
  static Plan* const plan = [] {
    auto* const made = new Plan;
    if (kIsPlanned && IsEmpty(kFirstArea) && IsReachable(kFirstArea))
      g_area = made->area = kFirstArea;
    return made;
  }();
  return *plan;
}

char* AreaOf(int index, uintptr_t offset, size_t bytes) {
  if (index < 0) return nullptr;
  return reinterpret_cast<char*>(g_area + offset + static_cast<uintptr_t>(index) * bytes);
}

}  // namespace

ObjectAddresses::ObjectAddresses(ObjectId id) {
  Plan& plan = SharedPlan();
  if (plan.area == 0) return;
  // Object `id` has two places of its own, with the numbers 2 * id and 2 * id + 1.  The second
  // place is needed when the object is loaded while the object that it replaces still uses the
  // first place.
  const int64_t own = int64_t{2} * id;
  for (const int64_t index : {own, own + 1}) {
    if (index_ < 0 && index >= 0 && index < kPlaces && !plan.taken[static_cast<size_t>(index)])
      index_ = static_cast<int>(index);
  }
  // If both places of the object are in use, takes the free place with the highest number, because
  // the places with low numbers belong to other objects.
  for (int last = kPlaces - 1; index_ < 0 && last >= 0; --last) {
    if (!plan.taken[static_cast<size_t>(last)]) index_ = last;
  }
  if (index_ >= 0) plan.taken[static_cast<size_t>(index_)] = true;
}

ObjectAddresses::~ObjectAddresses() {
  if (index_ >= 0) SharedPlan().taken[static_cast<size_t>(index_)] = false;
}

char* ObjectAddresses::heap() const { return AreaOf(index_, kHeaps, kHeapBytes); }
char* ObjectAddresses::image() const { return AreaOf(index_, kImages, kImageStride); }
char* ObjectAddresses::thunks() const { return index_ < 0 ? nullptr : image() + kImageBytes; }
char* ObjectAddresses::copies() const { return AreaOf(index_, kCopies, kCopyBytes); }
char* ObjectAddresses::stack(int number) const {
  ASSERT(number == 0 || number == 1);
  char* const both = AreaOf(index_, kStacks, 2 * kStackBytes);
  return both == nullptr ? nullptr : both + static_cast<size_t>(number) * kStackBytes;
}

int ObjectAddresses::OfHeap(const void* address) {
  // If `address` is below g_area, the first address of the plan and of the heaps, `offset` becomes
  // a very large number.  So one comparison finds addresses below the heaps and addresses above
  // them.
  const uintptr_t offset = reinterpret_cast<uintptr_t>(address) - g_area;
  if (g_area == 0 || offset >= kPlaces * kHeapBytes) return -1;
  return static_cast<int>(offset / kHeapBytes);
}

char* ReserveRegionArea() {
  Plan& plan = SharedPlan();
  if (plan.area == 0) return nullptr;
  const auto free = std::find(plan.regions_taken.begin(), plan.regions_taken.end(), false);
  if (free == plan.regions_taken.end()) return nullptr;
  *free = true;
  const auto index = static_cast<uintptr_t>(free - plan.regions_taken.begin());
  return reinterpret_cast<char*>(plan.area + kRegions + index * kRegionAreaBytes);
}

void GiveRegionArea(char* area) {
  Plan& plan = SharedPlan();
  const uintptr_t offset = reinterpret_cast<uintptr_t>(area) - plan.area - kRegions;
  const size_t index = offset / kRegionAreaBytes;
  ASSERT(index < kRegionAreas && plan.regions_taken[index]);
  plan.regions_taken[index] = false;
}

bool MapAt(char* address, size_t bytes) {
  void* const mapped =
      mmap(address, bytes, PROT_READ | PROT_WRITE,
           MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE | MAP_FIXED_NOREPLACE, -1, 0);
  if (mapped == address) return true;
  // A kernel before Linux 4.17 takes `address` only for a hint and may map the memory elsewhere.
  // Then unmaps this memory again and fails.
  if (mapped != MAP_FAILED) munmap(mapped, bytes);
  return false;
}

bool IsPlanned(const void* address) {
  return g_area != 0 && reinterpret_cast<uintptr_t>(address) - g_area < kAreaBytes;
}

void UseOtherAddresses() {
  Plan& plan = SharedPlan();
  if (plan.area == 0) return;
  ASSERT(std::count(plan.taken.begin(), plan.taken.end(), true) == 0,
         "objects have their addresses already");
  if (IsEmpty(kOtherArea)) g_area = plan.area = kOtherArea;
}

}  // namespace openr_host
