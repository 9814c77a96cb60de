#include "runtime/core/region_memory.h"

#include <gtest/gtest.h>
#include <sys/mman.h>

#include <algorithm>
#include <cstring>
#include <vector>

namespace openr_host {
namespace {

constexpr size_t kPictureBytes = 200'000;

bool IsMapped(const char* block) {
  const auto page = reinterpret_cast<uintptr_t>(block) & ~uintptr_t{4095};
  unsigned char is_resident = 0;
  return mincore(reinterpret_cast<void*>(page), 4096, &is_resident) == 0;
}

class RegionMemoryTest : public testing::Test {
 protected:
  void SetUp() override {
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "addresses are not planned with AddressSanitizer";
#endif
  }

  // Makes and frees a block in each slot; returns the blocks.
  std::vector<char*> UseSlots(uint32_t slots, size_t bytes) {
    std::vector<char*> blocks;
    for (uint32_t slot = 0; slot < slots; ++slot) {
      blocks.push_back(memory_.New(slot, bytes));
      std::memset(blocks.back(), 1, bytes);
      memory_.Free(blocks.back());
    }
    return blocks;
  }

  RegionMemory memory_;
};

TEST_F(RegionMemoryTest, OfManySlotsThatHeldPicturesFewKeepTheirMemory) {
  const std::vector<char*> blocks = UseSlots(100, kPictureBytes);
  EXPECT_EQ(std::count_if(blocks.begin(), blocks.end(), IsMapped), 4);
  EXPECT_TRUE(IsMapped(blocks.back()));
}

TEST_F(RegionMemoryTest, ASlotWhoseMemoryWasUnmappedHasZerosAtTheSameAddress) {
  const std::vector<char*> blocks = UseSlots(100, kPictureBytes);
  char* const again = memory_.New(0, kPictureBytes);
  EXPECT_EQ(again, blocks[0]);
  EXPECT_EQ(std::count(again, again + kPictureBytes, 0), static_cast<long>(kPictureBytes));
}

TEST_F(RegionMemoryTest, ABlockInUseKeepsItsMemoryWhileOthersComeAndGo) {
  char* const picture = memory_.New(200, kPictureBytes);
  memory_.Free(picture);
  ASSERT_EQ(memory_.New(200, kPictureBytes), picture);
  picture[0] = 7;
  UseSlots(100, kPictureBytes);
  ASSERT_TRUE(IsMapped(picture));
  EXPECT_EQ(picture[0], 7);
}

}  // namespace
}  // namespace openr_host
