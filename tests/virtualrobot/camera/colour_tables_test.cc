#include "virtualrobot/camera/colour_tables.h"

#include <gtest/gtest.h>

namespace openr_host {
namespace {

OCdtInfo Table(OCdtChannel channel) {
  OCdtInfo info;
  info.Init(0, channel);
  return info;
}

TEST(ColourTablesTest, NothingIsDetectedAtFirstAndByAnEmptyTable) {
  ColourTables tables;
  EXPECT_TRUE(tables.empty());
  EXPECT_TRUE(tables.Set(Table(ocdtCHANNEL0)));
  EXPECT_FALSE(tables.empty());
  for (int value = 0; value < 256; ++value)
    EXPECT_EQ(tables.Detect(static_cast<uint8_t>(value), 128, 128), 0);
}

TEST(ColourTablesTest, APixelIsInATableWhenCrAndCbAreInTheRectangleOfItsLuminance) {
  OCdtInfo pink = Table(ocdtCHANNEL2);
  pink.Set(10, 230, 150, 190, 120);  // Y 80..87: Cr 150..230, Cb 120..190
  ColourTables tables;
  EXPECT_TRUE(tables.Set(pink));
  EXPECT_EQ(tables.Detect(80, 150, 120), 0x04);
  EXPECT_EQ(tables.Detect(87, 230, 190), 0x04);
  EXPECT_EQ(tables.Detect(79, 200, 150), 0);
  EXPECT_EQ(tables.Detect(88, 200, 150), 0);
  EXPECT_EQ(tables.Detect(80, 149, 150), 0);
  EXPECT_EQ(tables.Detect(80, 231, 150), 0);
  EXPECT_EQ(tables.Detect(80, 200, 119), 0);
  EXPECT_EQ(tables.Detect(80, 200, 191), 0);
}

TEST(ColourTablesTest, EveryChannelHasItsBitAndAPixelMayBeInSeveral) {
  ColourTables tables;
  for (const OCdtChannel channel : {ocdtCHANNEL0, ocdtCHANNEL3, ocdtCHANNEL7}) {
    OCdtInfo all = Table(channel);
    for (int segment = 0; segment < 32; ++segment) all.Set(segment, 255, 0, 255, 0);
    EXPECT_TRUE(tables.Set(all));
  }
  EXPECT_EQ(tables.Detect(7, 8, 9), 0x89);
}

TEST(ColourTablesTest, ATableReplacesTheOneBefore) {
  ColourTables tables;
  OCdtInfo wide = Table(ocdtCHANNEL1);
  wide.Set(0, 255, 0, 255, 0);
  OCdtInfo narrow = Table(ocdtCHANNEL1);
  narrow.Set(0, 10, 10, 10, 10);
  tables.Set(wide);
  tables.Set(narrow);
  EXPECT_EQ(tables.Detect(0, 10, 10), 0x02);
  EXPECT_EQ(tables.Detect(0, 11, 10), 0);
}

TEST(ColourTablesTest, AChannelIsOneBitOfEight) {
  ColourTables tables;
  for (const OCdtChannel bad : {0u, 3u, 0x100u}) EXPECT_FALSE(tables.Set(Table(bad)));
  EXPECT_TRUE(tables.empty());
}

}  // namespace
}  // namespace openr_host
