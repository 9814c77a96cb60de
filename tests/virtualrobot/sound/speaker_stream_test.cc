// The Speaker service: robot.md 12.2, field-notes.md 10.5 and 10.6.
#include <gtest/gtest.h>

#include "tests/virtualrobot/sound/sound_fixture.h"

namespace openr_host {
namespace {

TEST_F(SoundTest, TheSpeakerIsReadyBeforeDoStartOfTheApplication) {
  Boot();
  RunAs(player, [&] { EXPECT_EQ(player->play->IsReady(), 1); });
  EXPECT_EQ(player->readies, std::vector<int64_t>{0});
}

TEST_F(SoundTest, ReadyComesWhenTheSoundHasBeenPlayedAndItsRegionIsFree) {
  BootForSound();
  RCRegion* sound = nullptr;
  int references = 0;
  player->on_ready = [&] { references = sound->NumberOfReference(); };
  RunAs(player, [&] {
    sound = player->NewSound(256, 1);
    player->Send({sound});
    EXPECT_EQ(sound->NumberOfReference(), 2);
  });
  RunToFrame(20);
  EXPECT_EQ(player->readies, std::vector<int64_t>{5});  // begins at frame 1, 32 ms long
  EXPECT_EQ(references, 1);
  EXPECT_EQ(Player::Data(sound)->GetInfo(0)->frameNumber, 1u);
  EXPECT_EQ(Player::Data(sound)->GetInfo(0)->actualDataSize, 256u);
  EXPECT_EQ(Heard(), "1:128x256; 2:128x256; 3:128x256; 4:128x256");
  EXPECT_EQ(Findings(), "");
}

// SoundPlay: two vectors with one notification, then the free one on each ready.
TEST_F(SoundTest, ADoubleBufferedStreamHasOneReadyEvery32MillisecondsAndNoGap) {
  BootForSound();
  std::vector<RCRegion*> buffers;
  int value = 2;
  player->on_ready = [&] {
    for (RCRegion* region : buffers) {
      if (region->NumberOfReference() != 1) continue;
      std::memset(Player::Data(region)->GetData(0), ++value, 256);
      player->Send({region});
      return;
    }
    ADD_FAILURE() << "no free region";
  };
  RunAs(player, [&] {
    buffers = {player->NewSound(256, 1), player->NewSound(256, 2)};
    player->Send(buffers);
  });
  RunToFrame(25);
  EXPECT_EQ(player->readies, (std::vector<int64_t>{5, 9, 13, 17, 21, 25}));
  ASSERT_GE(sink->entries.size(), 24u);
  for (size_t i = 0; i < 24; ++i) {
    EXPECT_EQ(sink->entries[i].frame, static_cast<int64_t>(i + 1));
    EXPECT_EQ(sink->entries[i].samples[0], static_cast<int>(i / 4 + 1) * 256) << i;
  }
}

TEST_F(SoundTest, SixteenBitSoundHas1024BytesIn32Milliseconds) {
  BootForSound();
  RunAs(player, [&] {
    EXPECT_EQ(
        Ask(oprmreqSPEAKER_SET_SOUND_TYPE, OPrimitiveControl_SpeakerSoundType(ospksndMONO16K16B)),
        oSUCCESS);
    player->Send({player->NewSound(1024, 2)});
  });
  RunToFrame(10);
  EXPECT_EQ(player->readies, std::vector<int64_t>{5});
  EXPECT_EQ(Heard(), "1:128x514; 2:128x514; 3:128x514; 4:128x514");  // 0x0202
}

TEST_F(SoundTest, VectorsOfAnySizeAreJoinedSampleBySample) {
  BootForSound();
  RunAs(player, [&] {
    player->Send({player->NewSound(96, 1), player->NewSound(8, 2), player->NewSound(8, -3)});
  });
  RunToFrame(10);
  EXPECT_EQ(Heard(), "1:128x256; 2:64x256 16x512 16x-768 32x0");
  EXPECT_EQ(player->readies, (std::vector<int64_t>{3, 3, 3}));
}

TEST_F(SoundTest, SoundsOfOneVectorComeOneAfterTheOther) {
  BootForSound();
  RunAs(player, [&] {
    MemoryRegionID id = 0;
    OSoundVectorData* data = nullptr;
    EXPECT_EQ(OPENR::NewSoundVectorData(2, 64, &id, &data), oSUCCESS);
    data->SetNumData(2);
    for (int i = 0; i < 2; ++i) {
      data->GetInfo(i)->Set(odataSOUND, player->Open(), 64);
      std::memset(data->GetData(i), i + 1, 64);
    }
    player->Send({new RCRegion(id, 0, data, data->vectorInfo.totalSize)});
  });
  RunToFrame(10);
  EXPECT_EQ(Heard(), "1:128x256; 2:128x512");
  EXPECT_EQ(player->readies, std::vector<int64_t>{3});
}

TEST_F(SoundTest, TwoSubjectsArePlayedInTheOrderOfArrivalAndEachGetsItsReady) {
  Player* const other = system.AddObject<Player>(dog, "other", "Other");
  system.Connect({dog, "Other.Play.OSoundVectorData.S",
                  "OVirtualRobotAudioComm.Speaker.OSoundVectorData.O", "test"});
  BootForSound();
  other->readies.clear();
  RunAs(player, [&] { player->Send({player->NewSound(256, 1)}); });
  RunAs(other, [&] { other->Send({other->NewSound(128, 2)}); });
  RunToFrame(12);
  EXPECT_EQ(player->readies, std::vector<int64_t>{5});
  EXPECT_EQ(other->readies, std::vector<int64_t>{7});
}

TEST_F(SoundTest, AVectorWithoutSoundTakesAFrame) {
  BootForSound();
  RunAs(player, [&] {
    RCRegion* const region = player->NewSound(256, 1);
    Player::Data(region)->SetNumData(0);
    player->Send({region});
  });
  RunToFrame(8);
  EXPECT_EQ(player->readies, std::vector<int64_t>{2});
  EXPECT_EQ(Heard(), "");
}

TEST_F(SoundTest, WaitDelaysTheStart) {
  BootForSound();
  RunAs(player, [&] {
    RCRegion* const region = player->NewSound(64, 1);
    Player::Data(region)->vectorInfo.wait = 3;
    player->Send({region});
  });
  RunToFrame(10);
  EXPECT_EQ(Heard(), "4:128x256");
  EXPECT_EQ(player->readies, std::vector<int64_t>{5});
}

// ---- mute, volume, power

TEST_F(SoundTest, MuteAndVolumeChangeWhatIsHeardAndNotTheTime) {
  BootForSound();
  RunAs(player, [&] {
    Ask(oprmreqSPEAKER_MUTE_ON);
    player->Send({player->NewSound(256, 100)});
  });
  RunToFrame(1);
  RunAs(player, [&] { Ask(oprmreqSPEAKER_MUTE_OFF); });
  RunToFrame(2);
  RunAs(player,
        [&] { Ask(oprmreqSPEAKER_SET_VOLUME, OPrimitiveControl_SpeakerVolume(ospkvolinfdB)); });
  RunToFrame(3);
  // 10 dB louder than allowed is 3.16 times full scale and clipped.
  RunAs(player, [&] { Ask(oprmreqSPEAKER_SET_VOLUME, OPrimitiveControl_SpeakerVolume(0)); });
  RunToFrame(10);
  EXPECT_EQ(Heard(), "1:128x0; 2:128x25600; 3:128x0; 4:128x32767");
  EXPECT_EQ(player->readies, std::vector<int64_t>{5});
}

TEST_F(SoundTest, EightDecibelsLessAre40PerCentOfTheAmplitude) {
  BootForSound();
  RunAs(player, [&] {
    Ask(oprmreqSPEAKER_SET_VOLUME, OPrimitiveControl_SpeakerVolume(ospkvol18dB));
    player->Send({player->NewSound(64, 100)});
  });
  RunToFrame(5);
  ASSERT_EQ(sink->entries.size(), 1u);
  EXPECT_NEAR(sink->entries[0].samples[0], 25600 * 0.398107, 10);
}

TEST_F(SoundTest, WithoutMotorPowerTheAmplifierIsSilentAndTheTimePasses) {
  Boot();
  player->readies.clear();
  RunAs(player, [&] { player->Send({player->NewSound(256, 1)}); });
  RunToFrame(10);
  EXPECT_EQ(Heard(), "1:128x0; 2:128x0; 3:128x0; 4:128x0");
  EXPECT_EQ(player->readies, std::vector<int64_t>{5});
  EXPECT_EQ(CountFindings("sound is played while motor power is off"), 1);
}

TEST_F(SoundTest, TheKindOfSoundIsThatOfTheMomentTheVectorBegins) {
  BootForSound();
  RunAs(player, [&] { player->Send({player->NewSound(256, 1), player->NewSound(256, 1)}); });
  RunToFrame(2);
  RunAs(player, [&] {
    Ask(oprmreqSPEAKER_SET_SOUND_TYPE, OPrimitiveControl_SpeakerSoundType(ospksndMONO16K16B));
  });
  RunToFrame(10);
  EXPECT_EQ(player->readies, (std::vector<int64_t>{5, 6}));
  EXPECT_EQ(Heard(), "1:128x256; 2:128x256; 3:128x256; 4:128x256; 5:128x257");
}

// ---- findings

TEST_F(SoundTest, AWrongVectorIdIsError4097AndIsNotPlayed) {
  BootForSound();
  RunAs(player, [&] {
    RCRegion* const region = player->NewSound(256, 1);
    Player::Data(region)->vectorInfo.memRegionID += 1;
    player->Send({region});
  });
  RunToFrame(10);
  EXPECT_EQ(
      CountFindings("OSpeakerObserver::DoneWriteAsync() error 4097 (oINVALID_DATA_VECTOR_ID)"), 1);
  EXPECT_EQ(system.findings().all()[0].object, "player");
  EXPECT_EQ(Heard(), "");
  EXPECT_EQ(player->readies, std::vector<int64_t>{2});
}

TEST_F(SoundTest, AVectorOfAnotherPrimitiveIsSilentAndTakesItsTime) {
  BootForSound();
  RunAs(player, [&] {
    RCRegion* const region = player->NewSound(256, 1);
    Player::Data(region)->GetInfo(0)->primitiveID = oprimitiveID_UNDEF;
    player->Send({region});
  });
  RunToFrame(10);
  EXPECT_EQ(
      CountFindings("names primitive 0xffffffff, which the robot does not have; it is silent"), 1);
  EXPECT_EQ(player->readies, std::vector<int64_t>{5});
}

TEST_F(SoundTest, DataSizesBeyondTheRoomAreCutOff) {
  BootForSound();
  RunAs(player, [&] {
    RCRegion* const region = player->NewSound(64, 1);
    Player::Data(region)->GetInfo(0)->dataSize = 100'000;
    player->Send({region});
  });
  RunToFrame(5);
  EXPECT_EQ(CountFindings("says 100000 bytes, has room for 64"), 1);
  EXPECT_EQ(player->readies, std::vector<int64_t>{2});
}

TEST_F(SoundTest, SoundThatSaysItIsOfAnotherKindThanTheSpeakerIsSetToIsReported) {
  BootForSound();
  RunAs(player, [&] {
    RCRegion* const region = player->NewSound(1024, 1);
    Player::Data(region)->GetInfo(0)->samplingRate = 16000;
    Player::Data(region)->GetInfo(0)->bitsPerSample = 16;
    player->Send({region});
  });
  RunToFrame(30);
  EXPECT_EQ(CountFindings("says 16000 Hz, 16 bits, 0 channels; the speaker is set to 8000 Hz, 8 "
                          "bits, mono"),
            1);
  EXPECT_EQ(player->readies, std::vector<int64_t>{17});  // 128 ms as 8k8b
}

TEST_F(SoundTest, MidiAndOtherDataAreNotPlayed) {
  BootForSound();
  RunAs(player, [&] {
    RCRegion* const midi = player->NewSound(64, 1);
    Player::Data(midi)->GetInfo(0)->format = osoundformatSMF;
    RCRegion* const joint = player->NewSound(64, 1);
    Player::Data(joint)->GetInfo(0)->type = odataJOINT_COMMAND2;
    player->Send({midi, joint});
  });
  RunToFrame(10);
  EXPECT_EQ(CountFindings("has format 3; only PCM (1) is played"), 1);
  EXPECT_EQ(CountFindings("has data type 259; odataSOUND is 16"), 1);
  EXPECT_EQ(player->readies, (std::vector<int64_t>{2, 3}));
}

TEST_F(SoundTest, TheQueueIsBounded) {
  BootForSound();
  RunAs(player, [&] {
    for (int event = 0; event < 3; ++event) {
      std::vector<RCRegion*> regions;
      for (int i = 0; i < 13; ++i) regions.push_back(player->NewSound(256, 1));
      player->Send(regions);
      OReadyMessage ready;
      ready.command = objcommCMD_ASSERT_READY;
      ready.observerID = player->play->begin()->GetObserverID();
      player->play->ReadyHandler(ready);
    }
  });
  system.RunFor(1);
  EXPECT_EQ(CountFindings("more than 32 sound vectors wait"), 1);
}

// ---- keys, optional bytes, cost, state

// MoNet: one part of a key in the first motion vector, one in the first sound vector.
TEST_F(SoundTest, MotionAndSoundWithPartsOfOneKeyBeginInOneFrame) {
  BootForSound();
  OVRSyncKey first = 0, second = 0;
  As([&] {
    OVRSyncKey key = 0;
    OPENR::NewSyncKey(&key);
    EXPECT_EQ(OPENR::DivideSyncKey(key, &first, &second), oSUCCESS);
    RCRegion* const region = mover->NewVector(1);
    Mover::FillJoint(region, 0, mover->Open(kPan), {9});
    Mover::Data(region)->vectorInfo.syncKey = first;
    mover->Send({region});
  });
  RunToFrame(10);
  EXPECT_EQ(Pan(), 0);
  RunAs(player, [&] {
    RCRegion* const region = player->NewSound(64, 1);
    Player::Data(region)->vectorInfo.syncKey = second;
    player->Send({region});
  });
  RunToFrame(11);
  EXPECT_EQ(Pan(), 9);
  EXPECT_EQ(Heard(), "11:128x256");
}

TEST_F(SoundTest, AndTheOtherWayRound) {
  BootForSound();
  OVRSyncKey first = 0, second = 0;
  RunAs(player, [&] {
    OVRSyncKey key = 0;
    OPENR::NewSyncKey(&key);
    EXPECT_EQ(OPENR::DivideSyncKey(key, &first, &second), oSUCCESS);
    RCRegion* const region = player->NewSound(64, 1);
    Player::Data(region)->vectorInfo.syncKey = first;
    player->Send({region});
  });
  RunToFrame(10);
  EXPECT_EQ(Heard(), "");
  As([&] {
    RCRegion* const region = mover->NewVector(1);
    Mover::FillJoint(region, 0, mover->Open(kPan), {9});
    Mover::Data(region)->vectorInfo.syncKey = second;
    mover->Send({region});
  });
  RunToFrame(11);
  EXPECT_EQ(Pan(), 9);
  EXPECT_EQ(Heard(), "11:128x256");
}

TEST_F(SoundTest, OptionalBytesOfSoundGoToTheSensorVectorsToo) {
  longword size = 0;
  watcher->on_vector = [&](const ONotifyEvent& event) {
    size = static_cast<const OSensorFrameVectorData*>(event.Data(0))->vectorInfo.optSize;
  };
  BootForSound();
  RunAs(player, [&] {
    RCRegion* const region = player->NewSound(64, 1);
    Player::Data(region)->vectorInfo.optSize = 5;
    player->Send({region});
  });
  RunToFrame(8);
  EXPECT_EQ(size, 5u);
}

TEST_F(SoundTest, WithoutSoundTheSoundObjectIsNeverWoken) {
  Boot();
  const Object* const sound = system.FindObject(dog, "OVirtualRobotAudioComm");
  const uint64_t before = sound->message_count();
  RunToFrame(100);
  EXPECT_EQ(sound->message_count(), before);
}

TEST_F(SoundTest, TheStateHashSeesTheSpeaker) {
  BootForSound();
  const uint64_t before = system.state_hash();
  RunAs(player, [&] { Ask(oprmreqSPEAKER_MUTE_ON); });
  EXPECT_NE(system.state_hash(), before);
}

TEST(SpeakerTest, TheSinkGoesOnWhereTheRobotWasSwitchedOff) {
  auto owned = std::make_unique<MemorySoundSink>();
  const MemorySoundSink& sink = *owned;
  Speaker speaker(std::move(owned));
  EXPECT_EQ(speaker.Play(7, SoundFrame{}, true), "");
  speaker.SwitchOff(10);
  EXPECT_EQ(speaker.Play(2, SoundFrame{}, true), "");
  ASSERT_EQ(sink.entries.size(), 2u);
  EXPECT_EQ(sink.entries[0].frame, 7);
  EXPECT_EQ(sink.entries[1].frame, 12);
}

}  // namespace
}  // namespace openr_host
