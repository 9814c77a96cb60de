#include "openr/render/picture_request.h"

#include <gtest/gtest.h>

namespace openr_host {
namespace {

PictureRequest ParsedRequest(const char* text) {
  PictureRequest plan;
  EXPECT_EQ(ParsePictureRequest(text, &plan), "") << text;
  return plan;
}

std::string RequestRefusal(const char* text) {
  PictureRequest plan;
  return ParsePictureRequest(text, &plan);
}

TEST(PictureRequestTest, AllPartsAreOptional) {
  const PictureRequest plan = ParsedRequest("");
  EXPECT_EQ(plan.time_us, -1);
  EXPECT_EQ(plan.view, View::kIso);
  EXPECT_EQ(plan.width_px, 1280);
  EXPECT_EQ(plan.height_px, 720);
}

TEST(PictureRequestTest, EveryPartIsRead) {
  const PictureRequest plan = ParsedRequest("t=5s,view=side,size=640x480,robot=2");
  EXPECT_EQ(plan.time_us, 5'000'000);
  EXPECT_EQ(plan.view, View::kSide);
  EXPECT_EQ(plan.width_px, 640);
  EXPECT_EQ(plan.height_px, 480);
  EXPECT_EQ(plan.robot, 2);
}

TEST(PictureRequestTest, TheEndOfTheRunHasAName) { EXPECT_EQ(ParsedRequest("t=end").time_us, -1); }

TEST(PictureRequestTest, AnUnknownViewListsTheOnesThereAre) {
  EXPECT_EQ(RequestRefusal("view=left"),
            "unknown view 'left'; there are side, front, top, iso, follow, world, camera");
}

TEST(PictureRequestTest, SizesThatMakeNoPictureAreRefused) {
  for (const char* text :
       {"size=0x0", "size=1280", "size=1280x", "size=99999x10", "size=20x20x20"}) {
    EXPECT_NE(RequestRefusal(text).find("is not like 1280x720"), std::string::npos) << text;
  }
}

TEST(PictureRequestTest, TheRobotsOwnViewHasTheSizeOfItsCamera) {
  EXPECT_EQ(ParsedRequest("view=camera").view, View::kCamera);
  EXPECT_EQ(RequestRefusal("size=640x480,view=camera"),
            "view=camera has the size of the robot's camera; leave out size");
}

TEST(PictureRequestTest, UnknownPartsAndBareWordsAreRefused) {
  EXPECT_EQ(RequestRefusal("zoom=2"), "unknown part 'zoom'; there are t, view, size, robot");
  EXPECT_EQ(RequestRefusal("side"), "'side' is not like t=5s or view=side");
  EXPECT_EQ(RequestRefusal("t=5"), "'5' has no unit; write 5s or 5ms");
  EXPECT_EQ(RequestRefusal("robot=-1"), "robot '-1' is no number; the first robot is 0");
}

}  // namespace
}  // namespace openr_host
