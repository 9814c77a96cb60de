// Where memory of objects lies, and which addresses are no function of a run.
#include "runtime/core/address_plan.h"

#include <gtest/gtest.h>
#include <sys/mman.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

#include "runtime/core/host_addresses.h"
#include "runtime/core/region_memory.h"

namespace openr_host {
namespace {

class AddressPlanTest : public testing::Test {
 protected:
  void SetUp() override {
    if (ObjectAddresses(0).heap() == nullptr) GTEST_SKIP() << "sanitizers need these addresses";
  }
};

TEST_F(AddressPlanTest, APlaceFollowsFromTheObject) {
  const char* first = nullptr;
  {
    const ObjectAddresses place(7);
    first = place.heap();
    EXPECT_TRUE(IsPlanned(first));
    EXPECT_TRUE(IsPlanned(place.copies() + ObjectAddresses::kCopyBytes - 1));
    EXPECT_EQ(ObjectAddresses::OfHeap(first + 100), ObjectAddresses::OfHeap(first));
  }
  EXPECT_EQ(ObjectAddresses(7).heap(), first);
  EXPECT_NE(ObjectAddresses(8).heap(), first);
}

TEST_F(AddressPlanTest, ASuccessorHasTheSecondPlaceWhileTheFirstIsInUse) {
  auto first = std::make_unique<ObjectAddresses>(7);
  const ObjectAddresses second(7);
  EXPECT_EQ(second.heap() - first->heap(), static_cast<ptrdiff_t>(ObjectAddresses::kHeapBytes));
  const char* const address = first->heap();
  first.reset();
  EXPECT_EQ(ObjectAddresses(7).heap(), address);
}

TEST_F(AddressPlanTest, AnotherSystemOfTheProcessHasPlacesFromTheEnd) {
  const ObjectAddresses first(7), second(7), third(7);
  const ObjectAddresses of_a_large_number(10'000'000);
  EXPECT_GT(third.heap(), second.heap());
  EXPECT_EQ(third.heap() - of_a_large_number.heap(),
            static_cast<ptrdiff_t>(ObjectAddresses::kHeapBytes));
}

TEST_F(AddressPlanTest, MemoryIsNotMappedTwice) {
  const ObjectAddresses place(7);
  ASSERT_TRUE(MapAt(place.stack(0), 4096));
  EXPECT_FALSE(MapAt(place.stack(0), 4096));
  munmap(place.stack(0), 4096);
}

TEST_F(AddressPlanTest, ARegionLiesWhereItsSlotAndSizePutIt) {
  std::vector<const void*> first, second;
  for (std::vector<const void*>* blocks : {&first, &second}) {
    RegionMemory memory;
    for (const uint32_t slot : {3u, 500u, 65535u}) {
      // Blocks that were there before and are freed do not count.
      if (blocks == &second) memory.Free(memory.New(slot, 5000));
      for (const size_t bytes : {1u, 65u, 5000u, 300'000u, 16u << 20})
        blocks->push_back(memory.New(slot, bytes));
    }
  }
  EXPECT_EQ(first, second);
  for (const void* const block : first) EXPECT_TRUE(IsPlanned(block));
}

TEST_F(AddressPlanTest, RegionsAreZeroAlsoWhenTheirMemoryIsUsedAgain) {
  RegionMemory memory;
  for (const size_t bytes : {40u, 10'000u, 2'000'000u}) {
    SCOPED_TRACE(bytes);
    char* const first = memory.New(9, bytes);
    std::memset(first, 1, bytes);
    memory.Free(first);
    const char* const again = memory.New(9, bytes);
    EXPECT_EQ(again, first);
    EXPECT_EQ(std::count(again, again + bytes, 0), static_cast<ptrdiff_t>(bytes));
  }
}

TEST_F(AddressPlanTest, ARegionWithoutAPlaceComesFromTheHostsHeap) {
  RegionMemory memory;
  char* const first = memory.New(9, 100);
  char* const second = memory.New(9, 100);  // the slot's memory of this size is in use
  char* const large = memory.New(9, (16u << 20) + 1);
  EXPECT_FALSE(IsPlanned(second));
  EXPECT_FALSE(IsPlanned(large));
  std::memset(second, 1, 100);
  for (char* block : {first, second, large}) memory.Free(block);
  memory.Free(nullptr);
}

TEST_F(AddressPlanTest, AddressesOfTheHostAreFound) {
  HostAddresses addresses;
  const auto on_the_heap = std::make_unique<int>();
  uint64_t words[4] = {1, 0x7fff, UINT64_MAX, 0};
  EXPECT_EQ(addresses.FindIn(words, sizeof words), -1);
  words[3] = reinterpret_cast<uint64_t>(on_the_heap.get());
  EXPECT_EQ(addresses.FindIn(words, sizeof words), 24);
  EXPECT_EQ(addresses.FindIn(words, sizeof words - 1), -1);  // not the whole of it
  words[1] = reinterpret_cast<uint64_t>(&std::puts);
  EXPECT_EQ(addresses.FindIn(words, sizeof words), 8);
}

TEST_F(AddressPlanTest, PlannedAddressesAreNoFinding) {
  HostAddresses addresses;
  RegionMemory memory;
  const char* const block = memory.New(0, 100);
  EXPECT_EQ(addresses.FindIn(&block, sizeof block), -1);
}

TEST_F(AddressPlanTest, NumbersThatLookLikeAddressesEndTheSearch) {
  HostAddresses addresses;
  const auto on_the_heap = std::make_unique<int>();
  const auto address = reinterpret_cast<uint64_t>(on_the_heap.get());
  std::vector<uint64_t> numbers;
  for (uint64_t i = 0; i < 64; ++i) numbers.push_back((uint64_t{0x6000} << 32) + i);
  EXPECT_EQ(addresses.FindIn(&address, sizeof address), 0);
  EXPECT_EQ(addresses.FindIn(numbers.data(), numbers.size() * 8), -1);
  EXPECT_EQ(addresses.FindIn(&address, sizeof address), -1);
}

}  // namespace
}  // namespace openr_host
