// The camera as a controller has it.
#include <device/camera.h>

#include "controller_fixture.h"

namespace openr_host {
namespace {

constexpr const char* kCamera = "PRM:/r1/c1/c2/c3/i1-FbkImageSensor:F1";

class ControllerCameraTest : public ControllerTest {
 protected:
  ~ControllerCameraTest() override { camera_disable(camera); }
  const DeviceTag camera = robot_get_device(kCamera);
};

TEST_F(ControllerCameraTest, ItsSizeAndItsFieldOfViewAreThoseOfTheRobot) {
  EXPECT_NE(camera, 0);
  EXPECT_EQ(camera_get_width(camera), 176);
  EXPECT_EQ(camera_get_height(camera), 144);
  EXPECT_NEAR(camera_get_fov(camera), 57.6 / 57.29578, 1e-5);
}

TEST_F(ControllerCameraTest, ImagesAreAskedForOnlyWhileItIsEnabled) {
  EXPECT_FALSE(camera_on);
  EXPECT_EQ(CameraBuffer(), nullptr);
  camera_enable(camera, 64);
  EXPECT_TRUE(camera_on);
  camera_disable(camera);
  EXPECT_FALSE(camera_on);
  EXPECT_EQ(CameraBuffer(), nullptr);
}

TEST_F(ControllerCameraTest, TheImageIsNullBeforeTheFirstOneAndAfterwards) {
  camera_enable(camera, 64);
  EXPECT_EQ(camera_get_image(camera), nullptr);
  Uint8* const buffer = CameraBuffer();
  EXPECT_EQ(camera_get_image(camera), buffer);
  camera_enable(camera, 64);
  EXPECT_EQ(camera_get_image(camera), buffer) << "enabled already";
  camera_disable(camera);
  EXPECT_EQ(camera_get_image(camera), nullptr);
}

TEST_F(ControllerCameraTest, PixelsAreThreeBytesRowByRow) {
  camera_enable(camera, 64);
  Uint8* const buffer = CameraBuffer();
  buffer[3 * (2 * 176 + 5)] = 10;
  buffer[3 * (2 * 176 + 5) + 1] = 20;
  buffer[3 * (2 * 176 + 5) + 2] = 60;
  const unsigned char* image = camera_get_image(camera);
  EXPECT_EQ(camera_image_get_red(image, 176, 5, 2), 10);
  EXPECT_EQ(camera_image_get_green(image, 176, 5, 2), 20);
  EXPECT_EQ(camera_image_get_blue(image, 176, 5, 2), 60);
  EXPECT_EQ(camera_image_get_grey(image, 176, 5, 2), 30);
}

TEST_F(ControllerCameraTest, WhatIsNoCameraHasNoPicture) {
  for (const DeviceTag tag : {robot_get_device(kPsd), DeviceTag{0}, DeviceTag{999}}) {
    camera_enable(tag, 64);
    EXPECT_FALSE(camera_on);
    EXPECT_EQ(camera_get_width(tag) + camera_get_height(tag), 0);
    EXPECT_EQ(camera_get_fov(tag), 0.0f);
    EXPECT_EQ(camera_get_image(tag), nullptr);
  }
}

}  // namespace
}  // namespace openr_host
