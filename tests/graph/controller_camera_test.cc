// A controller that looks: images come only while it wants them, in their colours.
#include <openr/testing.h>

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <vector>

#include "Messages.h"
#include "virtualrobot/camera/image_source.h"

namespace openr_host {
namespace {

using openr::testing::Bench;
using openr::testing::MessageKind;
using openr::testing::SeenMessage;
using openr::testing::StandIn;

// The camera sends luminance and two differences of colour, which are cut off at a byte
// (field-notes.md, 9.4): saturated colours come out paler than they are.
std::vector<double> AsSeen(const uint8_t* rgb) {
  const double y = 0.30 * rgb[0] + 0.59 * rgb[1] + 0.11 * rgb[2];
  const double cr = std::clamp(rgb[0] - y, -128.0, 127.0);
  const double cb = std::clamp(rgb[2] - y, -128.0, 127.0);
  std::vector<double> seen = {y + cr, y - 0.51 * cr - 0.19 * cb, y + cb};
  for (double& value : seen) value = std::clamp(value, 0.0, 255.0);
  return seen;
}

TEST(ControllerCameraGraphTest, PicturesComeWhileEnabledAndHaveTheColoursOfWhatIsSeen) {
  Bench bench({.stick = OPENR_STICK,
               .replace = {"JointMover",
                           StandIn("Controller",
                                   [](Bench& b) { b.AddImage(OPENR_IMAGES "/LOOKING.BIN"); })},
               .body = "ideal",
               .images = "pattern"});
  int images = 0;
  bench.OnMessage([&](const SeenMessage& message) {
    images += message.to().service.starts_with("Controller.Image.") &&
              message.kind() == MessageKind::kNotify;
  });
  bench.Boot();
  bench.RunFor(std::chrono::seconds(1));
  EXPECT_EQ(images, 0) << "not enabled";
  bench.probe("JointMover").subject("MainExecution").Send(MainExecutionMessage{});
  bench.RunFor(std::chrono::milliseconds(600));
  EXPECT_EQ(images, 0) << "not yet";
  bench.RunFor(std::chrono::seconds(1));
  const int images_then = images;
  EXPECT_GE(images_then, 3);
  EXPECT_LE(images_then, 8);
  bench.RunFor(std::chrono::seconds(1));
  EXPECT_EQ(images, images_then) << "disabled";
  EXPECT_EQ(bench.Findings(), "");

  Picture pattern{352, 288, std::vector<uint8_t>(size_t{352} * 288 * 3)};
  TestPattern().Capture({}, &pattern);
  std::istringstream words(bench.console().substr(bench.console().find("state: running")));
  std::string word;
  words >> word >> word;
  int pixels = 0;
  for (; words >> word && word != "picture"; ++pixels) {
    int rgb[3] = {};
    ASSERT_EQ(std::sscanf(word.c_str(), "%d,%d,%d", &rgb[0], &rgb[1], &rgb[2]), 3) << word;
    const std::vector<double> wanted = AsSeen(pattern.At(2 * (11 + 22 * pixels), 72));
    for (size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(rgb[i], wanted[i], 2) << "pixel " << pixels << " colour " << i;
    }
  }
  EXPECT_EQ(pixels, 8);
}

}  // namespace
}  // namespace openr_host
