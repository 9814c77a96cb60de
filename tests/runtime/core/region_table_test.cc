#include "runtime/core/region_table.h"

#include <gtest/gtest.h>

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
}

#ifndef __SANITIZE_ADDRESS__
TEST(RegionTableTest, ACopyThatNobodyHasLendsItsMemoryToTheNext) {
  RegionTable table;
  char* const base = table.AdoptCopy(0x10005, 64);
  table.KeepCopy(0x10005);
  base[0] = 'x';
  table.DropCopy(0x10005);
  uint32_t id = 0;
  size_t offset = 0;
  EXPECT_EQ(table.BaseOf(0x10005), nullptr);
  EXPECT_FALSE(table.Locate(base, &id, &offset));
  EXPECT_EQ(table.AdoptCopy(0x10005, 64), base);
  EXPECT_EQ(table.BaseOf(0x10005), base);
  EXPECT_FALSE(table.WrittenBeyond(0x10005));
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

}  // namespace
}  // namespace openr_host
