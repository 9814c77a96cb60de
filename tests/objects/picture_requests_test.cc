// CAMERA and CAMERA_PART of the remote control.
#include <gtest/gtest.h>

#include <numeric>

#include "remote_robot.h"

namespace openr_host {
namespace {

using Bytes = std::vector<uint8_t>;

class PictureRequestsTest : public testing::Test {
 protected:
  int Ask(uint8_t layer, int client = 0) {
    return robot_.Ask(rcCAMERA, {layer}, RC_VERSION_FILES, client);
  }
  int AskPart(int part, int client = 0) {
    return robot_.Ask(rcCAMERA_PART, {static_cast<uint8_t>(part), static_cast<uint8_t>(part >> 8)},
                      RC_VERSION_FILES, client);
  }
  RcPicturePart Part(int part) {
    EXPECT_EQ(AskPart(part), rcOK) << robot_.error;
    RcReader in(robot_.payload.data(), static_cast<int>(robot_.payload.size()));
    RcPicturePart head;
    head.Read(&in);
    bytes_.assign(in.Rest(), in.Rest() + in.RestSize());
    return head;
  }
  // An image of 44 x 36 pixels and six bands: layer L of the ERS-210.
  void Send() {
    image_.resize(44 * 36 * 6);
    std::iota(image_.begin(), image_.end(), static_cast<uint8_t>(1));
    robot_.handler.SetPicture({777, 44, 36, image_.data(), static_cast<Uint32>(image_.size())});
  }
  void SetFrame(uint32_t frame) {
    SensorValues values = {};
    values.frame = frame;
    robot_.handler.SetSensors(values);
    robot_.frame = frame;
  }

  RemoteRobot robot_;
  Bytes image_, bytes_;
};

TEST_F(PictureRequestsTest, TheCameraIsAskedForOneImageOnly) {
  EXPECT_EQ(robot_.handler.WantedLayer(), -1);
  EXPECT_FALSE(robot_.wants_image);
  ASSERT_EQ(Ask(2), rcOK);
  EXPECT_TRUE(robot_.payload.empty());
  EXPECT_TRUE(robot_.wants_image);
  EXPECT_EQ(robot_.handler.WantedLayer(), 2);
  Send();
  EXPECT_FALSE(robot_.wants_image);
  EXPECT_EQ(robot_.handler.WantedLayer(), -1);
}

TEST_F(PictureRequestsTest, PartsMakeUpTheLayer) {
  ASSERT_EQ(Ask(2), rcOK);
  Send();
  const RcPicturePart head = Part(0);
  EXPECT_EQ(head.frame, 777u);
  EXPECT_EQ(head.layer, 2);
  EXPECT_EQ(head.bands, 6);
  EXPECT_EQ(head.width, 44);
  EXPECT_EQ(head.height, 36);
  ASSERT_EQ(head.parts, 10);
  Bytes all;
  for (int i = 0; i < head.parts; ++i) {
    EXPECT_EQ(Part(i).part, i);
    EXPECT_EQ(robot_.payload.size() + RC_ANSWER_HEADER_SIZE, i < 9 ? 1024u : 588u);
    all.insert(all.end(), bytes_.begin(), bytes_.end());
  }
  EXPECT_EQ(all, image_);
  EXPECT_EQ(Part(3).part, 3) << "a part may be asked for again";
}

TEST_F(PictureRequestsTest, APictureThatIsNotThereYetIsBusy) {
  EXPECT_EQ(AskPart(0), rcerrorNO_PICTURE);
  EXPECT_EQ(robot_.error, "no picture was asked for, or another client has taken over");
  ASSERT_EQ(Ask(2), rcOK);
  EXPECT_EQ(AskPart(0), rcerrorBUSY);
  Send();
  EXPECT_EQ(AskPart(0), rcOK);
  EXPECT_EQ(AskPart(10), rcerrorBAD_VALUE);
  EXPECT_EQ(robot_.error, "part 10: the picture has 10, counted from 0");
}

TEST_F(PictureRequestsTest, ANewRequestReplacesTheOwnPicture) {
  ASSERT_EQ(Ask(2), rcOK);
  Send();
  ASSERT_EQ(Ask(1), rcOK);
  EXPECT_EQ(robot_.handler.WantedLayer(), 1);
  EXPECT_EQ(AskPart(0), rcerrorBUSY);
}

TEST_F(PictureRequestsTest, AnotherClientWaitsUntilThePictureIsForgotten) {
  SetFrame(1000);
  ASSERT_EQ(Ask(2, 0), rcOK);
  EXPECT_EQ(Ask(2, 1), rcerrorBUSY);
  EXPECT_EQ(robot_.error, "another client fetches a picture; try again");
  Send();
  SetFrame(1200);
  EXPECT_EQ(AskPart(0, 0), rcOK);
  EXPECT_EQ(AskPart(0, 1), rcerrorNO_PICTURE);
  SetFrame(1449);
  EXPECT_EQ(Ask(2, 1), rcerrorBUSY);
  SetFrame(1450);
  EXPECT_EQ(Ask(2, 1), rcOK) << "two seconds have passed";
  EXPECT_EQ(AskPart(0, 0), rcerrorNO_PICTURE);
}

TEST_F(PictureRequestsTest, AClientThatGoesLeavesThePlaceToOthers) {
  ASSERT_EQ(Ask(2, 0), rcOK);
  robot_.handler.EndClient(1);
  EXPECT_TRUE(robot_.wants_image);
  robot_.handler.EndClient(0);
  EXPECT_FALSE(robot_.wants_image);
  Send();
  EXPECT_EQ(AskPart(0, 0), rcerrorNO_PICTURE);
  EXPECT_EQ(Ask(2, 1), rcOK);
}

TEST_F(PictureRequestsTest, AnImageLargerThanAnyRobotsIsCutOff) {
  ASSERT_EQ(Ask(0), rcOK);
  const Bytes huge(RC_MAX_PICTURE + 1000);
  robot_.handler.SetPicture({1, 500, 400, huge.data(), static_cast<Uint32>(huge.size())});
  const int parts = Part(0).parts;
  EXPECT_EQ(parts,
            static_cast<int>((RC_MAX_PICTURE + RC_MAX_PICTURE_DATA - 1) / RC_MAX_PICTURE_DATA));
  EXPECT_EQ(AskPart(parts - 1), rcOK);
}

TEST_F(PictureRequestsTest, AnEmptyImageHasNoParts) {
  ASSERT_EQ(Ask(0), rcOK);
  robot_.handler.SetPicture({1, 0, 0, nullptr, 0});
  EXPECT_EQ(AskPart(0), rcerrorBAD_VALUE);
}

TEST_F(PictureRequestsTest, WhatMakesNoSenseIsRefused) {
  EXPECT_EQ(Ask(4), rcerrorNO_SUCH_DEVICE);
  EXPECT_EQ(robot_.error, "layer 4: there are 0 (H), 1 (M), 2 (L) and 3 (C)");
  EXPECT_EQ(robot_.Ask(rcCAMERA, {}, RC_VERSION_FILES), rcerrorMALFORMED);
  EXPECT_EQ(robot_.Ask(rcCAMERA_PART, {0}, RC_VERSION_FILES), rcerrorMALFORMED);
  EXPECT_EQ(robot_.Ask(rcCAMERA, {0}, RC_VERSION), rcerrorUNKNOWN_COMMAND);
  EXPECT_FALSE(robot_.wants_image);
}

}  // namespace
}  // namespace openr_host
