#include "runtime/core/region_table.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "runtime/base/hasher.h"

namespace openr_host {
namespace {

TEST(RegionTableTest, FreshBlocksAreZeroAndFound) {
  RegionTable table;
  const uint32_t id = table.New(100, 1);
  ASSERT_NE(table.BaseOf(id), nullptr);
  EXPECT_EQ(table.SizeOf(id), 100u);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(table.BaseOf(id)[i], 0);
}

#ifndef __SANITIZE_ADDRESS__
TEST(RegionTableTest, AWriteBehindTheEndShows) {
  RegionTable table;
  const uint32_t id = table.New(8, 1);
  table.BaseOf(id)[7] = 1;
  EXPECT_FALSE(table.WrittenBeyond(id));
  table.BaseOf(id)[8] = 1;
  EXPECT_TRUE(table.WrittenBeyond(id));
  EXPECT_FALSE(table.WrittenBeyond(12345));
}
#endif

TEST(RegionTableTest, AnIdNeverNamesALaterBlock) {
  RegionTable table;
  const uint32_t first = table.New(8, 1);
  EXPECT_TRUE(table.Delete(first));
  const uint32_t second = table.New(8, 1);
  EXPECT_NE(first, second);
  EXPECT_EQ(table.BaseOf(first), nullptr);
  EXPECT_FALSE(table.Delete(first));
}

// A program that makes and deletes a region in every frame has made 70,000 within ten minutes.
TEST(RegionTableTest, AnIdNeverNamesALaterBlockOfManyEither) {
  RegionTable table;
  std::set<uint32_t> ids;
  for (int i = 0; i < 70'000; ++i) {
    const uint32_t id = table.New(8, 1);
    EXPECT_TRUE(ids.insert(id).second) << "block " << i << " has the id of an earlier one";
    EXPECT_TRUE(table.Delete(id));
    EXPECT_TRUE(table.WasDeleted(id));
  }
  const uint32_t last = table.New(8, 1);
  for (const uint32_t id : ids) EXPECT_TRUE(table.WasDeleted(id) && !table.Delete(id)) << id;
  EXPECT_NE(table.BaseOf(last), nullptr);
}

TEST(RegionTableTest, OnlyWhenAllIdsWereGivenIsTheOldestGivenAgain) {
  constexpr int kSlots = 0xffff, kGenerations = 2;
  RegionTable table(kGenerations);
  std::vector<uint32_t> ids;
  for (int i = 0; i < kSlots * kGenerations; ++i) {
    ids.push_back(table.New(8, 1));
    EXPECT_TRUE(table.Delete(ids.back()));
  }
  EXPECT_EQ(std::set<uint32_t>(ids.begin(), ids.end()).size(), ids.size());
  EXPECT_EQ(table.New(8, 1), ids[0]);
  EXPECT_EQ(table.New(8, 1), ids[kGenerations]);  // the first id of the second slot
}

TEST(RegionTableTest, PinnedMemoryOutlivesItsBlock) {
  RegionTable table;
  const uint32_t id = table.New(8, 1);
  table.Pin(id);
  table.Delete(id);
  EXPECT_NE(table.BaseOf(id), nullptr);
  EXPECT_EQ(table.live_count(), 0);
  table.Unpin(id);
  EXPECT_EQ(table.BaseOf(id), nullptr);
}

TEST(RegionTableTest, ABlockIsWhereItWasMadeWhoeverOwnsIt) {
  RegionTable table;
  const uint32_t given = table.New(8, 1), deleted = table.New(8, 1);
  table.SetOwner(given, 2);
  EXPECT_EQ(table.MakerOf(given), 1);
  table.Pin(deleted);
  table.Delete(deleted);
  EXPECT_EQ(table.MakerOf(deleted), kNoObject);
  table.DeleteAllOf(1);
  EXPECT_NE(table.BaseOf(given), nullptr);
  EXPECT_EQ(table.MakerOf(given), kNoObject) << "its maker is gone";
}

TEST(RegionTableTest, TheBlocksOfOneOwnerGoTogether) {
  RegionTable table;
  table.New(8, 1);
  table.New(8, 1);
  table.New(8, 2);
  table.DeleteAllOf(1);
  EXPECT_EQ(table.CountOf(1), 0);
  EXPECT_EQ(table.CountOf(2), 1);
  EXPECT_EQ(table.live_count(), 1);
  EXPECT_EQ(table.used_count(), 1);
}

TEST(RegionTableTest, AnAddressInsideABlockNamesTheBlock) {
  RegionTable table;
  uint32_t id = 0;
  size_t offset = 0;
  for (const uint32_t block : {table.New(8, 1), table.New(24, 1)}) {
    char* const base = table.BaseOf(block);
    const auto last = table.SizeOf(block) - 1;
    EXPECT_TRUE(table.Locate(base, &id, &offset));
    EXPECT_EQ(id, block);
    EXPECT_EQ(offset, 0u);
    EXPECT_TRUE(table.Locate(base + last, &id, &offset));
    EXPECT_EQ(id, block);
    EXPECT_EQ(offset, last);
    EXPECT_FALSE(table.Locate(base + last + 1, &id, &offset));
    EXPECT_FALSE(table.Locate(base - 1, &id, &offset));
  }
  EXPECT_FALSE(table.Locate(nullptr, &id, &offset));
  EXPECT_FALSE(table.Locate(&table, &id, &offset));
}

TEST(RegionTableTest, OnlyAnIdThatNamedABlockWasDeleted) {
  RegionTable table;
  const uint32_t first = table.New(8, 1);
  EXPECT_FALSE(table.WasDeleted(first));
  table.Delete(first);
  EXPECT_TRUE(table.WasDeleted(first));
  const uint32_t second = table.New(8, 1);  // in the same slot
  EXPECT_TRUE(table.WasDeleted(first));
  EXPECT_FALSE(table.WasDeleted(second));
  EXPECT_FALSE(table.WasDeleted(RegionTable::kNoRegion));
  EXPECT_FALSE(table.WasDeleted(first & 0xffff)) << "generations begin with 1";
  EXPECT_FALSE(table.WasDeleted(second + 1)) << "that slot was never used";
  EXPECT_FALSE(table.WasDeleted(second + 0x10000)) << "that id comes later";
}

TEST(RegionTableTest, ThePlaceThatMadeMostBlocksIsFound) {
  const int here = 0, there = 0;
  RegionTable table;
  EXPECT_EQ(table.MostCommonPlace(), (std::pair<const void*, int>(nullptr, 0)));
  std::vector<uint32_t> blocks;
  for (const int* place : {&here, &there, &there}) {
    blocks.push_back(table.New(8, 1));
    table.NotePlace(blocks.back(), place);
  }
  table.New(8, 1);  // without a place
  EXPECT_EQ(table.PlaceOf(blocks[0]), &here);
  EXPECT_EQ(table.PlaceOf(12345), nullptr);
  EXPECT_EQ(table.MostCommonPlace(), (std::pair<const void*, int>(&there, 2)));
  table.Delete(blocks[1]);
  EXPECT_EQ(table.MostCommonPlace(), (std::pair<const void*, int>(&here, 1)));
}

TEST(RegionTableTest, LiveBlocksOfAnOwnerAreVisitedInTheOrderOfTheirSlots) {
  RegionTable table;
  const uint32_t first = table.New(8, 1), other = table.New(16, 2), deleted = table.New(24, 1),
                 last = table.New(32, 1);
  table.Delete(deleted);
  const uint32_t reused = table.New(40, 1);
  std::vector<uint32_t> ids;
  std::vector<size_t> sizes;
  table.ForEachOf(1, [&](uint32_t id, char* base, size_t size) {
    EXPECT_EQ(base, table.BaseOf(id));
    ids.push_back(id);
    sizes.push_back(size);
  });
  EXPECT_EQ(ids, (std::vector<uint32_t>{first, reused, last}));
  EXPECT_EQ(sizes, (std::vector<size_t>{8, 40, 32}));
  EXPECT_EQ(table.CountOf(1), 3);
  EXPECT_EQ(table.OwnerOf(other), 2);
  EXPECT_EQ(table.OwnerOf(deleted), kNoObject);
}

TEST(RegionTableTest, ABlockShrinksAndGrowsWithinItsMemory) {
  RegionTable table;
  const uint32_t id = table.New(16, 1);
  EXPECT_TRUE(table.Resize(id, 8));
  EXPECT_EQ(table.SizeOf(id), 8u);
  EXPECT_FALSE(table.WrittenBeyond(id));
  EXPECT_TRUE(table.Resize(id, 16));
  EXPECT_FALSE(table.WrittenBeyond(id));
  EXPECT_FALSE(table.Resize(id, 17));
  EXPECT_FALSE(table.Resize(id, 0));
  EXPECT_FALSE(table.Resize(12345, 8));
  EXPECT_EQ(table.SizeOf(id), 16u);
}

TEST(RegionTableTest, ABlockOfAWorkerHasTheIdOfTheMaster) {
  RegionTable table;
  const uint32_t id = 0x30001;  // in the first slot of a table that has none yet
  char* const base = table.AdoptOwn(id, 8, 4);
  ASSERT_NE(base, nullptr);
  EXPECT_EQ(table.BaseOf(id), base);
  EXPECT_EQ(table.OwnerOf(id), 4);
  EXPECT_EQ(table.live_count(), 1);
  EXPECT_EQ(table.AdoptOwn(id, 8, 4), nullptr) << "the slot has a live block";
  EXPECT_EQ(table.AdoptOwn(RegionTable::kNoRegion, 8, 4), nullptr);
  table.RemoveAdopted(id);
  table.RemoveAdopted(id);
  EXPECT_EQ(table.BaseOf(id), nullptr);
  EXPECT_EQ(table.live_count(), 0);
  EXPECT_NE(table.AdoptOwn(0x40001, 8, 4), nullptr);
  EXPECT_FALSE(table.WasDeleted(id)) << "New() did not make it";
}

TEST(RegionTableTest, ALostBlockThatIsReadKeepsItsMemory) {
  RegionTable table;
  char* const base = table.AdoptOwn(0x10002, 8, 4);
  base[0] = 'x';
  table.Pin(0x10002);
  table.RemoveAdopted(0x10002);
  EXPECT_EQ(table.BaseOf(0x10002), base);
  char* const next = table.AdoptOwn(0x20002, 8, 4);  // the next block of this slot
  EXPECT_NE(next, base);
  EXPECT_EQ(base[0], 'x');
  EXPECT_EQ(next[0], 0);
}

#ifndef __SANITIZE_ADDRESS__
TEST(RegionTableTest, ACopyThatNobodyHasLendsItsMemoryToTheNext) {
  RegionTable table;
  char* const base = table.AdoptCopy(0x10005, 64);
  table.KeepCopy(0x10005);
  base[0] = 'x';
  table.DropCopy(0x10005);
  EXPECT_EQ(table.used_count(), 1);
  uint32_t id = 0;
  size_t offset = 0;
  EXPECT_EQ(table.BaseOf(0x10005), nullptr);
  EXPECT_FALSE(table.Locate(base, &id, &offset));
  EXPECT_EQ(table.AdoptCopy(0x10005, 64), base);
  EXPECT_EQ(table.BaseOf(0x10005), base);
  EXPECT_FALSE(table.WrittenBeyond(0x10005));
}
#endif

#ifndef __SANITIZE_ADDRESS__
TEST(RegionTableTest, ALaterBlockHasTheAddressOfItsSlot) {
  RegionTable table;
  char* const base = table.AdoptCopy(0x10005, 64);
  table.KeepCopy(0x10005);
  table.DropCopy(0x10005);
  EXPECT_EQ(table.AdoptCopy(0x20005, 64), base);
  EXPECT_EQ(table.used_count(), 1);
}
#endif

TEST(RegionTableTest, ACopyOfAnotherSizeOrBlockGetsFreshMemory) {
  RegionTable table;
  const auto use = [&table](uint32_t id, size_t size) {
    char* const base = table.AdoptCopy(id, size);
    table.KeepCopy(id);
    const bool fresh = base[0] == 0;
    base[0] = 'x';
    EXPECT_EQ(table.SizeOf(id), size);
    table.DropCopy(id);
    return fresh;
  };
  EXPECT_TRUE(use(0x10005, 64));
  EXPECT_TRUE(use(0x10005, 128));
  EXPECT_TRUE(use(0x20005, 128)) << "another block in the same place";
  EXPECT_EQ(table.live_count(), 0);
}

TEST(RegionTableTest, ContentIsState) {
  const auto hash = [](const RegionTable& table) {
    Hasher hasher;
    table.HashState(&hasher);
    return hasher.Digest();
  };
  RegionTable table;
  const uint32_t id = table.New(8, 1);
  const uint64_t before = hash(table);
  table.BaseOf(id)[3] = 1;
  EXPECT_NE(hash(table), before);
}

TEST(RegionTableTest, SlotIdOwnerAndSizeAreState) {
  const auto hash_with = [](int blocks_before, int deleted_before, ObjectId owner, size_t size) {
    RegionTable table;
    std::vector<uint32_t> before;
    for (int i = 0; i < blocks_before; ++i) before.push_back(table.New(8, 1));
    for (int i = 0; i < deleted_before; ++i) table.Delete(table.New(8, 1));
    table.New(size, owner);
    for (const uint32_t id : before) table.Delete(id);
    Hasher hasher;
    table.HashState(&hasher);
    return hasher.Digest();
  };
  const uint64_t hash = hash_with(0, 0, 1, 8);
  EXPECT_EQ(hash_with(0, 0, 1, 8), hash);
  EXPECT_NE(hash_with(1, 0, 1, 8), hash) << "another slot";
  EXPECT_NE(hash_with(0, 1, 1, 8), hash) << "another generation of the slot";
  EXPECT_NE(hash_with(0, 0, 2, 8), hash) << "another owner";
  EXPECT_NE(hash_with(0, 0, 1, 9), hash) << "another size";
}

}  // namespace
}  // namespace openr_host
