#include "openr/snapshot.h"

#include <gtest/gtest.h>

namespace openr_host {
namespace {

SnapshotPlan Parsed(const char* text) {
  SnapshotPlan plan;
  EXPECT_EQ(ParseSnapshot(text, &plan), "") << text;
  return plan;
}

std::string Refusal(const char* text) {
  SnapshotPlan plan;
  return ParseSnapshot(text, &plan);
}

TEST(SnapshotTest, AllPartsAreOptional) {
  const SnapshotPlan plan = Parsed("");
  EXPECT_EQ(plan.time_us, -1);
  EXPECT_EQ(plan.view, View::kIso);
  EXPECT_EQ(plan.width_px, 1280);
  EXPECT_EQ(plan.height_px, 720);
}

TEST(SnapshotTest, EveryPartIsRead) {
  const SnapshotPlan plan = Parsed("t=5s,view=side,size=640x480,robot=2");
  EXPECT_EQ(plan.time_us, 5'000'000);
  EXPECT_EQ(plan.view, View::kSide);
  EXPECT_EQ(plan.width_px, 640);
  EXPECT_EQ(plan.height_px, 480);
  EXPECT_EQ(plan.robot, 2);
}

TEST(SnapshotTest, TheEndOfTheRunHasAName) { EXPECT_EQ(Parsed("t=end").time_us, -1); }

TEST(SnapshotTest, AnUnknownViewListsTheOnesThereAre) {
  EXPECT_EQ(Refusal("view=left"), "unknown view 'left'; there are side, front, top, iso, follow");
}

TEST(SnapshotTest, SizesThatMakeNoPictureAreRefused) {
  for (const char* text :
       {"size=0x0", "size=1280", "size=1280x", "size=99999x10", "size=20x20x20"}) {
    EXPECT_NE(Refusal(text).find("is not like 1280x720"), std::string::npos) << text;
  }
}

TEST(SnapshotTest, UnknownPartsAndBareWordsAreRefused) {
  EXPECT_EQ(Refusal("zoom=2"), "unknown part 'zoom'; there are t, view, size, robot");
  EXPECT_EQ(Refusal("side"), "'side' is not like t=5s or view=side");
  EXPECT_EQ(Refusal("t=5"), "'5' has no unit; write 5s or 5ms");
  EXPECT_EQ(Refusal("robot=-1"), "robot '-1' is no number; the first robot is 0");
}

}  // namespace
}  // namespace openr_host
