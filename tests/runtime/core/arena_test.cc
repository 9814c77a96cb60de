#include "runtime/core/arena.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

namespace openr_host {
namespace {

TEST(ArenaTest, BlocksOfAllSizesAreAlignedUsableAndKnowTheirOwner) {
  Arena arena;
  for (const size_t size : {0, 1, 15, 16, 17, 255, 256, 257, 320, 4096, 32768, 32769, 3000000}) {
    SCOPED_TRACE(size);
    void* const block = arena.Allocate(size);
    ASSERT_NE(block, nullptr);
    EXPECT_EQ(reinterpret_cast<uintptr_t>(block) % 16, 0u);
    EXPECT_GE(Arena::UsableSize(block), size);
    std::memset(block, 0xa5, size);
    EXPECT_EQ(Arena::OwnerOf(block), &arena);
  }
}

TEST(ArenaTest, BlocksOfOneSizeDoNotOverlap) {
  Arena arena;
  std::vector<unsigned char*> blocks;
  for (int i = 0; i < 10000; ++i) {
    blocks.push_back(static_cast<unsigned char*>(arena.Allocate(100)));
    std::memset(blocks.back(), i & 0xff, 100);
  }
  for (int i = 0; i < 10000; ++i) {
    ASSERT_EQ(blocks[static_cast<size_t>(i)][0], i & 0xff);
    ASSERT_EQ(blocks[static_cast<size_t>(i)][99], i & 0xff);
  }
}

TEST(ArenaTest, FreedBlocksAreUsedAgain) {
  Arena arena;
  void* const first = arena.Allocate(48);
  Arena::Free(first);
  EXPECT_EQ(arena.Allocate(40), first);
  void* const large = arena.Allocate(5 << 20);
  Arena::Free(large);
  EXPECT_EQ(arena.bytes_in_use(), Arena::UsableSize(first));
}

TEST(ArenaTest, ABudgetRefusesAndLeavesTheRestUsable) {
  MemoryBudget budget{.limit_bytes = 1000};
  Arena arena(&budget);
  void* const first = arena.Allocate(600);
  EXPECT_NE(first, nullptr);
  EXPECT_EQ(arena.Allocate(600), nullptr);
  EXPECT_NE(arena.Allocate(100), nullptr);
  Arena::Free(first);
  EXPECT_NE(arena.Allocate(600), nullptr);
}

TEST(ArenaTest, ArenasShareABudgetAndGiveItBack) {
  MemoryBudget budget{.limit_bytes = 1000};
  Arena stays(&budget);
  {
    Arena goes(&budget);
    EXPECT_NE(goes.Allocate(600), nullptr);
    EXPECT_EQ(stays.Allocate(600), nullptr);
  }
  EXPECT_NE(stays.Allocate(600), nullptr);
}

TEST(ArenaTest, AllMemoryGoesWithTheArena) {
  void* block = nullptr;
  {
    Arena arena;
    block = arena.Allocate(100);
    EXPECT_EQ(Arena::OwnerOf(block), &arena);
  }
  EXPECT_EQ(Arena::OwnerOf(block), nullptr);
}

TEST(ArenaTest, LargeAlignmentsHold) {
  Arena arena;
  for (const size_t alignment : {32, 64, 4096, 65536}) {
    void* const block = arena.Allocate(100, alignment);
    EXPECT_EQ(reinterpret_cast<uintptr_t>(block) % alignment, 0u) << alignment;
  }
}

TEST(ArenaTest, AddressesOutsideBelongToNobody) {
  int on_the_stack = 0;
  EXPECT_EQ(Arena::OwnerOf(&on_the_stack), nullptr);
  EXPECT_EQ(Arena::OwnerOf(nullptr), nullptr);
}

}  // namespace
}  // namespace openr_host
