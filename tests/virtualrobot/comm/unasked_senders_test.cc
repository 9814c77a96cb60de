// Programs that send to Effector and Speaker without asking whether they are ready: two shapes
// that worked on robots (docs/body.md, "What robot.md leaves open").
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/virtualrobot/sound/sound_fixture.h"

namespace openr_host {
namespace {

constexpr size_t kRegions = 4;
constexpr int kBurst = 7;
constexpr int kStep_urad = 500;  // between the set points of one vector and the next

// The first region to which nobody else refers.  A program that does not check writes through
// null when there is none.
RCRegion* FirstFree(const std::vector<RCRegion*>& regions) {
  const auto found = std::find_if(regions.begin(), regions.end(), [](const RCRegion* region) {
    return region->NumberOfReference() == 1;
  });
  return found == regions.end() ? nullptr : *found;
}

class UnaskedSenderTest : public SoundTest {
 protected:
  void MakeRegions() {
    As([&] {
      pan = mover->Open(kPan);
      for (size_t i = 0; i < kRegions; ++i) regions.push_back(mover->NewVector(1));
    });
  }
  // As code of the mover: one vector of `frames` frames that all have the next set point.
  void SendNext(size_t frames) {
    RCRegion* const region = FirstFree(regions);
    ASSERT_NE(region, nullptr) << "vector " << sent + 1;
    Mover::FillJoint(region, 0, pan, std::vector<int>(frames, ++sent * kStep_urad));
    mover->Send({region});
  }
  int NumberInForce() const { return Pan() / kStep_urad; }
  // Runs for `frames` frames and notes every vector that comes into force.
  void Watch(int frames) {
    for (int i = 0; i < frames; ++i) {
      system.RunFor(kFrameUs);
      if (NumberInForce() != played.back()) played.push_back(NumberInForce());
    }
  }

  OPrimitiveID pan = 0;
  std::vector<RCRegion*> regions;
  int sent = 0;
  std::vector<int> played{0};  // numbers of vectors
};

// A program that follows what its camera sees.
class ImageFollower : public CodeObject {
 public:
  ImageFollower() {
    image = AddObserver("Follower.Image.OFbkImageVectorData.O", [this](const ONotifyEvent&) {
      on_image();
      image->AssertReady();
    });
  }
  OStatus DoStart(const OSystemEvent&) override {
    image->AssertReady();
    return oSUCCESS;
  }
  OObserver* image;
  std::function<void()> on_image;
};

// 40 ms vectors, one for each image, which come every 40 ms: a vector begins a frame after the one
// before has ended, so now and then a vector that waits is replaced.
TEST_F(UnaskedSenderTest, AVectorForEachImageAlwaysFindsARegionAndFollowsTheCamera) {
  auto* const follower = system.AddObject<ImageFollower>(dog, "follower");
  system.Connect({dog, "OVirtualRobotComm.FbkImageSensor.OFbkImageVectorData.S",
                  "Follower.Image.OFbkImageVectorData.O", "test"});
  int most_behind = 0;
  follower->on_image = [&] {
    most_behind = std::max(most_behind, sent - NumberInForce());
    As([&] { SendNext(5); });
  };
  Boot();
  MakeRegions();
  Watch(1250);
  EXPECT_GT(sent, 240);
  EXPECT_TRUE(std::is_sorted(played.begin(), played.end()));
  EXPECT_GT(played.size(), static_cast<size_t>(sent) * 4 / 5);  // few are replaced
  EXPECT_LE(most_behind, 3);                                    // and none comes late
  EXPECT_EQ(Findings(), "");
}

// Up to seven commands in a burst, each a message of its own.
TEST_F(UnaskedSenderTest, ABurstOfCommandsAlwaysFindsARegionAndItsLastOneIsInForce) {
  Boot();
  MakeRegions();
  for (int size = 1; size <= kBurst; ++size) {
    for (int gap : {1, 3, 9, 40}) {  // frames; shorter and longer than the vectors
      const int first = sent + 1;
      for (int i = 0; i < size; ++i) As([&] { SendNext(4); });
      ASSERT_FALSE(HasFatalFailure()) << "burst of " << size << ", " << gap << " frames later";
      Watch(gap);
      if (gap < 40) continue;
      EXPECT_EQ(played.back(), sent);
      EXPECT_TRUE(std::count(played.begin(), played.end(), first)) << "the first finds it idle";
    }
  }
  EXPECT_TRUE(std::is_sorted(played.begin(), played.end()));
  EXPECT_EQ(Findings(), "");
}

TEST_F(UnaskedSenderTest, ABurstOfOneHandlerDoesAsWell) {
  Boot();
  MakeRegions();
  As([&] {
    for (int i = 0; i < kBurst; ++i) SendNext(16);
  });
  Watch(60);
  EXPECT_EQ(played, (std::vector<int>{0, 1, kBurst}));
}

TEST_F(UnaskedSenderTest, ABurstOfSoundsPlaysTheFirstAndTheLast) {
  BootForSound();
  std::vector<RCRegion*> sounds;
  RunAs(player, [&] {
    for (size_t i = 0; i < kRegions; ++i) sounds.push_back(player->NewSound(64, 0));
  });
  for (int i = 1; i <= kBurst; ++i) {
    RunAs(player, [&] {
      RCRegion* const region = FirstFree(sounds);
      ASSERT_NE(region, nullptr) << "sound " << i;
      std::memset(Player::Data(region)->GetData(0), i, 64);
      player->Send({region});
    });
  }
  RunToFrame(10);
  EXPECT_EQ(Heard(), fmt::format("1:128x256; 3:128x{}", kBurst * 256));
  EXPECT_EQ(Findings(), "");
}

}  // namespace
}  // namespace openr_host
