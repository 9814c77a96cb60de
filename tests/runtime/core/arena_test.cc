#include "runtime/core/arena.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <vector>

namespace openr_host {
namespace {

class ArenaTest : public testing::Test {
 protected:
  void SetUp() override {
    if (place_.heap() == nullptr) GTEST_SKIP() << "sanitizers bring a heap of their own";
  }

  const ObjectAddresses place_{0};
};

TEST_F(ArenaTest, BlocksOfAllSizesAreAlignedUsableAndKnowTheirOwner) {
  Arena arena(place_);
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

TEST_F(ArenaTest, BlocksOfOneSizeDoNotOverlap) {
  Arena arena(place_);
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

TEST_F(ArenaTest, FreedBlocksAreUsedAgain) {
  Arena arena(place_);
  void* const first = arena.Allocate(48);
  Arena::Free(first);
  EXPECT_EQ(arena.Allocate(40), first);
  void* const large = arena.Allocate(5 << 20);
  Arena::Free(large);
  EXPECT_EQ(arena.bytes_in_use(), Arena::UsableSize(first));
}

TEST_F(ArenaTest, WhatIsNotInUseCannotBeFreed) {
  Arena arena(place_);
  char* const small = static_cast<char*>(arena.Allocate(100));
  char* const large = static_cast<char*>(arena.Allocate(100000));
  for (char* const block : {small, large}) {
    EXPECT_FALSE(Arena::Free(block + 16));
    EXPECT_FALSE(Arena::WasFreed(block + 16));
    EXPECT_TRUE(Arena::Free(block));
    EXPECT_FALSE(Arena::Free(block));
    EXPECT_TRUE(Arena::WasFreed(block));
  }
  EXPECT_FALSE(Arena::WasFreed(small + 112));  // never allocated
  EXPECT_EQ(arena.bytes_in_use(), 0u);
  EXPECT_EQ(arena.Allocate(100), small);
  EXPECT_NE(arena.Allocate(100), small);
}

TEST_F(ArenaTest, CallsAreKeptWhileABlockIsInUse) {
  Arena arena(place_);
  arena.KeepCalls();
  void* const first = arena.Allocate(48);
  arena.NoteCalls(first, {&arena});
  size_t blocks = 0;
  const auto count = [&](char* block, size_t bytes, const Arena::Calls& calls) {
    EXPECT_EQ(block, first);
    EXPECT_EQ(bytes, 48u);
    EXPECT_EQ(calls.size(), 1u);
    ++blocks;
  };
  arena.ForEachBlock(count);
  EXPECT_EQ(blocks, 1u);
  Arena::Free(first);
  arena.ForEachBlock(count);
  EXPECT_EQ(blocks, 1u);
}

TEST_F(ArenaTest, ABudgetRefusesAndLeavesTheRestUsable) {
  MemoryBudget budget{.limit_bytes = 1000};
  Arena arena(place_, &budget);
  void* const first = arena.Allocate(600);
  EXPECT_NE(first, nullptr);
  EXPECT_EQ(arena.Allocate(600), nullptr);
  EXPECT_NE(arena.Allocate(100), nullptr);
  Arena::Free(first);
  EXPECT_NE(arena.Allocate(600), nullptr);
}

TEST_F(ArenaTest, ArenasShareABudgetAndGiveItBack) {
  MemoryBudget budget{.limit_bytes = 1000};
  Arena stays(place_, &budget);
  {
    const ObjectAddresses other(1);
    Arena goes(other, &budget);
    EXPECT_NE(goes.Allocate(600), nullptr);
    EXPECT_EQ(stays.Allocate(600), nullptr);
  }
  EXPECT_NE(stays.Allocate(600), nullptr);
}

TEST_F(ArenaTest, AnArenaCanLeaveItsBudget) {
  MemoryBudget budget{.limit_bytes = 1000};
  Arena arena(place_, &budget);
  void* const block = arena.Allocate(100);
  EXPECT_GE(budget.used_bytes, 100u);
  arena.LeaveBudget();
  EXPECT_EQ(budget.used_bytes, 0u);
  EXPECT_TRUE(Arena::Free(block));
  EXPECT_EQ(budget.used_bytes, 0u);
  EXPECT_EQ(arena.bytes_in_use(), 0u);
}

TEST_F(ArenaTest, AllMemoryGoesWithTheArena) {
  void* block = nullptr;
  {
    Arena arena(place_);
    block = arena.Allocate(100);
    EXPECT_EQ(Arena::OwnerOf(block), &arena);
  }
  EXPECT_EQ(Arena::OwnerOf(block), nullptr);
}

TEST_F(ArenaTest, LargeAlignmentsHold) {
  Arena arena(place_);
  for (const size_t alignment : {32, 64, 4096, 65536}) {
    void* const block = arena.Allocate(100, alignment);
    EXPECT_EQ(reinterpret_cast<uintptr_t>(block) % alignment, 0u) << alignment;
  }
}

TEST_F(ArenaTest, AddressesOutsideBelongToNobody) {
  int on_the_stack = 0;
  EXPECT_EQ(Arena::OwnerOf(&on_the_stack), nullptr);
  EXPECT_EQ(Arena::OwnerOf(nullptr), nullptr);
}

TEST_F(ArenaTest, AddressesThatWereNeverMappedBelongToNoBlock) {
  Arena arena(place_);
  void* const block = arena.Allocate(100);
  char* const far = place_.heap() + ObjectAddresses::kHeapBytes - 16;
  ASSERT_EQ(Arena::OwnerOf(far), &arena);
  EXPECT_FALSE(Arena::Free(far));
  EXPECT_FALSE(Arena::WasFreed(far));
  EXPECT_EQ(Arena::UsableSize(far), 0u);
  EXPECT_TRUE(Arena::Free(block));
}

TEST_F(ArenaTest, BlocksAreZeroAlsoWhenTheyAreUsedAgain) {
  Arena arena(place_);
  for (const size_t size : {24, 5000, 100'000}) {
    SCOPED_TRACE(size);
    void* const first = arena.Allocate(size);
    std::memset(first, 0xa5, size);
    Arena::Free(first);
    const auto* const again = static_cast<const char*>(arena.Allocate(size));
    ASSERT_EQ(again, first);
    EXPECT_EQ(std::count(again, again + size, 0), static_cast<ptrdiff_t>(size));
  }
}

TEST_F(ArenaTest, AddressesFollowFromThePlaceAndTheOrderOfCallsOnly) {
  std::vector<void*> first, second;
  for (std::vector<void*>* blocks : {&first, &second}) {
    Arena arena(place_);
    for (const size_t size : {24, 500'000, 7, 40'000, 24}) blocks->push_back(arena.Allocate(size));
  }
  EXPECT_EQ(first, second);
  EXPECT_EQ(first[0], static_cast<void*>(place_.heap()));
}

TEST_F(ArenaTest, AFullHeapAreaRefusesAndLeavesTheRestUsable) {
  Arena arena(place_);
  void* const most = arena.Allocate(ObjectAddresses::kHeapBytes);
  EXPECT_NE(most, nullptr);
  EXPECT_EQ(arena.Allocate(1), nullptr);
  Arena::Free(most);
  EXPECT_NE(arena.Allocate(1), nullptr);
}

}  // namespace
}  // namespace openr_host
