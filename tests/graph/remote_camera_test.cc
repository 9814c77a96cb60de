// Pictures of the camera over the remote control, with the real RCServer.
#include <gtest/gtest.h>

#include "RemoteCamera.h"
#include "tests/graph/graph.h"
#include "tests/graph/remote_packets.h"

namespace openr_host {
namespace {

using std::chrono::milliseconds;
using std::chrono::seconds;

constexpr char kImages[] = "OVirtualRobotComm.FbkImageSensor";
constexpr char kObserver[] = "RCServer.Image";

class RemoteCameraTest : public testing::Test {
 protected:
  RemoteCameraTest() : graph_(kIdeal), client_(graph_.AddClient()) {
    graph_.RunFor(seconds(1));
    client_.Connect(RC_PORT);
    graph_.RunFor(milliseconds(50));
  }

  std::vector<HeardPacket> Ask(const std::string& packets, milliseconds time) {
    const size_t heard = client_.heard().size();
    client_.Send(packets);
    graph_.RunFor(time);
    return RcHeard(client_.heard().substr(heard));
  }
  static std::string Part(int part) {
    return RcPacket(rcCAMERA_PART, {static_cast<char>(part), static_cast<char>(part >> 8)});
  }
  Graph graph_;
  openr::testing::TcpClient& client_;
};

TEST_F(RemoteCameraTest, ALayerComesWholeInParts) {
  for (const uint32_t size : {152064u, 38016u, 9504u, 6336u}) {
    const int layer = size == 152064u ? 0 : size == 38016u ? 1 : size == 9504u ? 2 : 3;
    const auto asked = Ask(RcPacket(rcCAMERA, std::string(1, static_cast<char>(layer))) + Part(0),
                           milliseconds(150));
    ASSERT_EQ(asked.size(), 2u);
    EXPECT_EQ(asked[0].status, rcOK);
    EXPECT_EQ(asked[1].status, rcerrorBUSY) << "an image takes at least 40 ms";
    std::string bytes;
    for (int part = 0, parts = 1; part < parts; ++part) {
      const auto answer = Ask(Part(part), milliseconds(40));
      ASSERT_EQ(answer.size(), 1u);
      ASSERT_EQ(answer[0].status, rcOK);
      RcReader in(reinterpret_cast<const Uint8*>(answer[0].payload.data()),
                  static_cast<int>(answer[0].payload.size()));
      RcPicturePart head;
      head.Read(&in);
      parts = head.parts;
      EXPECT_EQ(head.part, part);
      EXPECT_EQ(head.layer, layer);
      EXPECT_EQ(static_cast<uint32_t>(head.bands * head.width * head.height), size);
      bytes += answer[0].payload.substr(RcPicturePart::SIZE);
    }
    EXPECT_EQ(bytes.size(), size);
  }
}

TEST_F(RemoteCameraTest, RCServerGetsNoImageForWhichNobodyHasAsked) {
  graph_.Disallow(kImages, kObserver);
  graph_.RunFor(seconds(2));
}

TEST_F(RemoteCameraTest, RCServerGetsOneImageForAPicture) {
  graph_.Expect(kImages, kObserver);
  Ask(RcPacket(rcCAMERA, std::string(1, 1)), milliseconds(200));
  graph_.Verify();
  graph_.Disallow(kImages, kObserver);
  graph_.RunFor(seconds(1));
}

TEST_F(RemoteCameraTest, AClientThatGoesBeforeItsPictureLeavesItToTheNext) {
  Ask(RcPacket(rcCAMERA, std::string(1, 2)), milliseconds(8));
  client_.Reset();
  graph_.RunFor(seconds(2));
  auto& next = graph_.AddClient();
  next.Connect(RC_PORT).Send(Part(0) + RcPacket(rcCAMERA, std::string(1, 2)));
  graph_.RunFor(milliseconds(300));
  next.Send(Part(9));
  graph_.RunFor(milliseconds(100));
  const auto heard = RcHeard(next.heard());
  ASSERT_EQ(heard.size(), 3u);
  EXPECT_EQ(heard[0].status, rcerrorNO_PICTURE);
  EXPECT_EQ(heard[1].status, rcOK);
  EXPECT_EQ(heard[2].status, rcOK);
}

}  // namespace
}  // namespace openr_host
