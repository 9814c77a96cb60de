#include "runtime/core/memory_map.h"

#include <gtest/gtest.h>
#include <sys/mman.h>

namespace openr_host {
namespace {

// Returns the range in which `address` lies; a range from 0 to 0 if there is none.
MappedRange RangeOf(const void* address) {
  const auto wanted = reinterpret_cast<uintptr_t>(address);
  MemoryMap map;
  for (MappedRange range; map.Next(&range);) {
    if (range.begin <= wanted && wanted < range.end) return range;
  }
  return {};
}

TEST(MemoryMapTest, RangesAreInOrderAndNotEmpty) {
  MemoryMap map;
  uintptr_t last = 0;
  int count = 0;
  for (MappedRange range; map.Next(&range); ++count) {
    EXPECT_GE(range.begin, last);
    EXPECT_LT(range.begin, range.end);
    last = range.end;
  }
  EXPECT_GT(count, 3);
}

TEST(MemoryMapTest, DataCodeAndStackAreTold) {
  static int data = 1;
  const void* const frame = __builtin_frame_address(0);
  EXPECT_TRUE(RangeOf(&data).is_private_data);
  EXPECT_FALSE(RangeOf(&data).is_main_stack);
  EXPECT_TRUE(RangeOf(frame).is_private_data);
  EXPECT_TRUE(RangeOf(frame).is_main_stack);
  const MappedRange code = RangeOf(reinterpret_cast<const void*>(&RangeOf));
  EXPECT_NE(code.end, 0u);
  EXPECT_FALSE(code.is_private_data);
}

TEST(MemoryMapTest, MemoryThatIsOnlyReadIsNoData) {
  void* const page = mmap(nullptr, 4096, PROT_READ, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(page, MAP_FAILED);
  EXPECT_NE(RangeOf(page).end, 0u);
  EXPECT_FALSE(RangeOf(page).is_private_data);
  munmap(page, 4096);
}

}  // namespace
}  // namespace openr_host
