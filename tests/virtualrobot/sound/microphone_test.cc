// The Mic service: robot.md 12.2, field-notes.md 10.4.
#include <gtest/gtest.h>

#include "tests/virtualrobot/sound/sound_fixture.h"

namespace openr_host {
namespace {

TEST_F(SoundTest, TheMicrophoneDelivers512StereoSamplesEvery32Milliseconds) {
  AddListener();
  std::vector<OSoundInfo> infos;
  ODataVectorInfo header{};
  std::vector<OSoundSampleStereo16> samples;
  listener->on_vector = [&](OSoundVectorData* vector) {
    header = vector->vectorInfo;
    infos.push_back(*vector->GetInfo(0));
    const auto* const data = reinterpret_cast<OSoundSampleStereo16*>(vector->GetData(0));
    samples.insert(samples.end(), data, data + vector->GetInfo(0)->dataSize / sizeof *data);
  };
  Boot();
  RunToFrame(9);
  EXPECT_EQ(listener->times, (std::vector<int64_t>{32000, 64000}));
  EXPECT_EQ(header.type, odataSOUND_VECTOR);
  EXPECT_EQ(header.numData, 1u);
  EXPECT_EQ(header.infoSize, 64u);
  EXPECT_EQ(header.totalSize, 192u + 64 + 2048);
  ASSERT_EQ(infos.size(), 2u);
  EXPECT_EQ(infos[0].type, odataSOUND);
  EXPECT_EQ(infos[0].frameNumber, 0u);
  EXPECT_EQ(infos[1].frameNumber, 4u);
  EXPECT_EQ(infos[1].dataSize, 2048u);
  EXPECT_EQ(infos[1].actualDataSize, 2048u);
  EXPECT_EQ(infos[1].format, osoundformatPCM);
  EXPECT_EQ(infos[1].channel, osoundchannelSTEREO);
  EXPECT_EQ(infos[1].samplingRate, 16000);
  EXPECT_EQ(infos[1].bitsPerSample, 16);
  RunAs(player, [&] {
    OPrimitiveID id = 0;
    OPENR::OpenPrimitive(kMic, &id);
    EXPECT_EQ(infos[1].primitiveID, id);
  });
  // Left then right, without a gap; silence when the source has ended.
  ASSERT_EQ(samples.size(), 1024u);
  for (size_t i = 0; i < samples.size(); ++i) {
    EXPECT_EQ(samples[i].L, i < 1000 ? static_cast<int>(i) : 0);
    EXPECT_EQ(samples[i].R, i < 1000 ? -static_cast<int>(i) : 0);
  }
}

TEST_F(SoundTest, WhoBeginsToListenLateHearsWhatIsSaidThen) {
  AddListener();
  std::vector<sword> first;
  listener->on_vector = [&](OSoundVectorData* vector) {
    first.push_back(reinterpret_cast<OSoundSampleStereo16*>(vector->GetData(0))->L);
  };
  Boot();
  RunAs(listener, [&] { listener->mic->DeassertReady(); });
  RunToFrame(5);
  EXPECT_TRUE(first.empty());
  RunAs(listener, [&] { listener->mic->AssertReady(); });
  RunToFrame(8);
  EXPECT_EQ(first, std::vector<sword>{512});
}

TEST_F(SoundTest, TheSourceGoesOnWhereTheRobotWasSwitchedOff) {
  AddListener();
  std::vector<sword> first;
  listener->on_vector = [&](OSoundVectorData* vector) {
    first.push_back(reinterpret_cast<OSoundSampleStereo16*>(vector->GetData(0))->L);
  };
  Boot();
  RunToFrame(5);
  robot->SwitchOff();  // in frame 5; the frames begin again with 0
  system.RunFor(5 * kFrameUs);
  EXPECT_EQ(first, (std::vector<sword>{0, 5 * 128}));
}

class Ers7SoundTest : public SoundTest {
 protected:
  Ers7SoundTest() : SoundTest("ers7") {}
};

TEST_F(Ers7SoundTest, TheErs7Delivers256SamplesEvery16Milliseconds) {
  AddListener();
  longword bytes = 0;
  listener->on_vector = [&](OSoundVectorData* vector) { bytes = vector->GetInfo(0)->dataSize; };
  Boot();
  RunToFrame(5);
  EXPECT_EQ(listener->times, (std::vector<int64_t>{16000, 32000}));
  EXPECT_EQ(bytes, 1024u);
}

// field-notes.md 10.4
TEST_F(Ers7SoundTest, ModeAndLevelControlOfTheMicrophoneOfAnErs7ChangeNoSound) {
  AddListener();
  std::vector<OSoundSampleStereo16> heard;
  listener->on_vector = [&](OSoundVectorData* vector) {
    const auto* const data = reinterpret_cast<OSoundSampleStereo16*>(vector->GetData(0));
    heard.insert(heard.end(), data, data + vector->GetInfo(0)->dataSize / sizeof *data);
  };
  Boot();
  int frame = 0;
  for (const OPrimitiveRequest request : {oprmreqMIC_UNI, oprmreqMIC_OMNI, oprmreqMIC_ALC_ON}) {
    RunAs(player, [&] {
      OPrimitiveID id = 0;
      EXPECT_EQ(OPENR::OpenPrimitive(kMic, &id), oSUCCESS);
      EXPECT_EQ(OPENR::ControlPrimitive(id, request, nullptr, 0, nullptr, 0), oSUCCESS);
    });
    RunToFrame(frame += 2);
  }
  RunToFrame(frame + 1);
  ASSERT_EQ(heard.size(), 3 * 256u);
  for (size_t i = 0; i < heard.size(); ++i) {
    EXPECT_EQ(heard[i].L, static_cast<int>(i));
    EXPECT_EQ(heard[i].R, -static_cast<int>(i));
  }
}

TEST(MemorySoundSourceTest, LoopsOrEndsInSilence) {
  const std::vector<OSoundSampleStereo16> three = {{1, 2}, {3, 4}, {5, 6}};
  MemorySoundSource ends(three);
  MemorySoundSource loops(three, AfterEnd::kLoop);
  OSoundSampleStereo16 out[2];
  ends.Read(2, out, 2);
  EXPECT_EQ(out[0].L, 5);
  EXPECT_EQ(out[1].L, 0);
  loops.Read(3'000'000'000'002, out, 2);
  EXPECT_EQ(out[0].R, 6);
  EXPECT_EQ(out[1].R, 2);
  MemorySoundSource nothing({}, AfterEnd::kLoop);
  nothing.Read(7, out, 2);
  EXPECT_EQ(out[1].L, 0);
}

}  // namespace
}  // namespace openr_host
