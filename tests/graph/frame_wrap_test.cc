// The frame number in answers of the remote control, where the robot's counter begins anew.
#include <gtest/gtest.h>
#include <openr/testing.h>

#include <algorithm>
#include <cstring>
#include <vector>

#include "RemoteProtocol.h"
#include "virtualrobot/virtual_robot.h"

namespace openr_host {
namespace {

using openr::testing::Bench;
using openr::testing::DefaultStick;

TEST(FrameWrapTest, TheAnswersOfTheRemoteControlBeginAnewAsTheirPageSays) {
  constexpr int64_t kLast = 0x0ffffff0;
  Bench bench({.stick = DefaultStick(), .body = "ideal"});
  bench.dog().set_first_frame(kLast - 40);
  ASSERT_TRUE(bench.Boot());
  const std::string info = {'R', 'C', 8, 0, 1, rcINFO, 0, 0};
  openr::testing::TcpClient& client = bench.AddClient();
  client.Connect(RC_PORT);
  for (int i = 0; i < 100; ++i) {
    client.Send(info);
    bench.Frame();
  }
  ASSERT_TRUE(client.done());
  std::vector<uint32_t> frames;
  uint16_t size = 0;
  for (size_t at = 0; at + 16 <= client.heard().size(); at += size) {
    uint32_t frame = 0;
    std::memcpy(&size, client.heard().data() + at + 2, sizeof size);
    std::memcpy(&frame, client.heard().data() + at + 8, sizeof frame);
    if (frames.empty() || frames.back() != frame) frames.push_back(frame);
    ASSERT_GE(size, 16);
  }
  const auto found = std::find(frames.begin(), frames.end(), 0x0ffffff3u);
  ASSERT_GE(frames.end() - found, 3) << frames.size();
  EXPECT_EQ(found[1], 6u);
  EXPECT_EQ(found[2], 10u);
}

}  // namespace
}  // namespace openr_host
