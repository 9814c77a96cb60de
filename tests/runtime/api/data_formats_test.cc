#include <OPENR/ODataFormats.h>
#include <gtest/gtest.h>

#include <cstring>

namespace {

TEST(OCdtInfoTest, InitEmptiesTheTable) {
  OCdtInfo info;
  info.Init(7, ocdtCHANNEL2);
  EXPECT_EQ(info.type, odataCDT);
  EXPECT_EQ(info.primitiveID, 7u);
  EXPECT_EQ(info.channel, 4u);
  EXPECT_EQ(info.table[0], 0x80808080u);
  EXPECT_EQ(info.table[31], 0x80808080u);
}

TEST(OCdtInfoTest, SetPacksCbAboveCrAndMaxAboveMin) {
  OCdtInfo info;
  info.Init(7, ocdtCHANNEL0);
  info.Set(31, 0x11, 0x22, 0x33, 0x44);
  EXPECT_EQ(info.table[31], 0x33441122u);
  EXPECT_EQ(info.table[30], ocdtINIT);
}

TEST(OCdtInfoTest, ASegmentOutsideTheTableChangesNothing) {
  OCdtInfo info;
  info.Init(7, ocdtCHANNEL0);
  const OCdtInfo before = info;
  info.Set(-1, 1, 2, 3, 4);
  info.Set(32, 1, 2, 3, 4);
  EXPECT_EQ(std::memcmp(&info, &before, sizeof info), 0);
}

TEST(OCommandInfoTest, SetWritesTypePrimitiveAndFrames) {
  OCommandInfo info = {};
  info.dataSize = 128;
  info.Set(odataJOINT_COMMAND2, 12, 16);
  EXPECT_EQ(info.type, 259u);
  EXPECT_EQ(info.primitiveID, 12u);
  EXPECT_EQ(info.numFrames, 16u);
  EXPECT_EQ(info.dataSize, 128u);
}

TEST(OSoundInfoTest, SetWritesTypePrimitiveAndSize) {
  OSoundInfo info = {};
  info.Set(odataSOUND, 3, 256);
  EXPECT_EQ(info.type, 16u);
  EXPECT_EQ(info.primitiveID, 3u);
  EXPECT_EQ(info.dataSize, 256u);
}

TEST(OFbkImageVectorDataTest, SetPrimitiveIDReachesEveryLayer) {
  // A vector of the camera has infos for all layers, but its C++ type declares only one.
  struct {
    OFbkImageVectorData vector;
    OFbkImageInfo more[ofbkimageNUM_LAYERS - 1];
  } room = {};
  room.vector.SetPrimitiveID(9);
  EXPECT_EQ(room.vector.GetInfo(ofbkimageLAYER_H)->primitiveID, 9u);
  EXPECT_EQ(room.vector.GetInfo(ofbkimageLAYER_C)->primitiveID, 9u);
}

TEST(OJointCommandValueTest, SetTakesTheValueAndThreeGains) {
  OJointCommandValue value = {};
  value.Set(-5, 1, 2, 3);
  EXPECT_EQ(value.value, -5);
  EXPECT_EQ(value.p + 10 * value.i + 100 * value.d, 321);
}

TEST(OUnitsTest, MicroTruncatesTowardZero) {
  EXPECT_EQ(micro(1.9999999), 1999999);
  EXPECT_EQ(micro(-1.9999999), -1999999);
}

// The last set points of Sony's MovingLegs sample on the robot, in 10^-6 rad: each is
// one sixteenth of its last vector short of the target.
TEST(OUnitsTest, SetPointsOfMovingLegsComeOutExactly) {
  EXPECT_EQ(oradians(60.07421875), 1048492);
  EXPECT_EQ(oradians(0.1171875), 2045);
  EXPECT_EQ(oradians(70.0 / 768), 1590);
  EXPECT_EQ(oradians(147 - 117.0 / 768), 2562975);
}

TEST(OUnitsTest, ConstantsAreThoseOfTheConversion) {
  EXPECT_EQ(oradians(180), oradiansPI);
  EXPECT_EQ(oradians(90), oradiansPI_2);
  EXPECT_EQ(oradians(45), oradiansPI_4);
  EXPECT_DOUBLE_EQ(degrees(radians(37.5)), 37.5);
}

}  // namespace
