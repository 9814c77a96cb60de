// ControlPrimitive(): robot.md 7.1 and 13.3.
#include <gtest/gtest.h>

#include "tests/virtualrobot/comm_fixture.h"

namespace openr_host {
namespace {

class PrimitiveRequestsTest : public VirtualRobotCommTest {
 protected:
  using VirtualRobotCommTest::VirtualRobotCommTest;
  void SetUp() override { Boot(); }

  OStatus Ask(const char* locator, OPrimitiveRequest request) {
    return OPENR::ControlPrimitive(mover->Open(locator), request, nullptr, 0, nullptr, 0);
  }
  template <typename T>
  OStatus Ask(const char* locator, OPrimitiveRequest request, T param) {
    return OPENR::ControlPrimitive(mover->Open(locator), request, &param, sizeof param, nullptr, 0);
  }
};

TEST_F(PrimitiveRequestsTest, SwitchesOfSpeakerMicrophoneAndCamera) {
  As([&] {
    for (const OPrimitiveRequest request : {oprmreqSPEAKER_MUTE_ON, oprmreqSPEAKER_MUTE_OFF})
      EXPECT_EQ(Ask(kSpeaker, request), oSUCCESS) << request;
    for (const OPrimitiveRequest request :
         {oprmreqMIC_UNI, oprmreqMIC_OMNI, oprmreqMIC_ALC_ON, oprmreqMIC_ALC_OFF})
      EXPECT_EQ(Ask(kMic, request), oSUCCESS) << request;
    for (const OPrimitiveRequest request :
         {oprmreqCAM_AE_ON, oprmreqCAM_AE_OFF, oprmreqCAM_AWB_ON, oprmreqCAM_AWB_OFF})
      EXPECT_EQ(Ask(kCamera, request), oSUCCESS) << request;
    EXPECT_EQ(Ask(kSpeaker, oprmreqSPEAKER_SET_VOLUME_MIDI), oSUCCESS);
    EXPECT_EQ(
        Ask(kSpeaker, oprmreqSPEAKER_MASTER_TUNING_MIDI, OPrimitiveControl_MasterTuningMIDI(5)),
        oSUCCESS);
  });
  EXPECT_EQ(Findings(), "");
}

TEST_F(PrimitiveRequestsTest, TheSoundTypeIsSetAndRead) {
  As([&] {
    const OPrimitiveID speaker = mover->Open(kSpeaker);
    OPrimitiveControl_SpeakerSoundType type(99);
    const auto get = [&] {
      return OPENR::ControlPrimitive(speaker, oprmreqSPEAKER_GET_SOUND_TYPE, nullptr, 0, &type,
                                     sizeof type);
    };
    EXPECT_EQ(get(), oSUCCESS);
    EXPECT_EQ(type.type, ospksndMONO8K8B);  // the default
    EXPECT_EQ(Ask(kSpeaker, oprmreqSPEAKER_SET_SOUND_TYPE,
                  OPrimitiveControl_SpeakerSoundType(ospksndMONO16K16B)),
              oSUCCESS);
    EXPECT_EQ(get(), oSUCCESS);
    EXPECT_EQ(type.type, ospksndMONO16K16B);
    for (const longword reserved : {1, 2, 4, 5}) {
      EXPECT_EQ(Ask(kSpeaker, oprmreqSPEAKER_SET_SOUND_TYPE,
                    OPrimitiveControl_SpeakerSoundType(reserved)),
                oINVALID_ARG);
    }
  });
}

TEST_F(PrimitiveRequestsTest, VolumesUpToTenDecibelsBelowFullAreSafe) {
  As([&] {
    for (const longword volume : {ospkvolinfdB, ospkvol25dB, ospkvol18dB, ospkvol10dB}) {
      EXPECT_EQ(Ask(kSpeaker, oprmreqSPEAKER_SET_VOLUME, OPrimitiveControl_SpeakerVolume(volume)),
                oSUCCESS);
      EXPECT_EQ(robot->speaker().volume(), volume);
    }
    EXPECT_EQ(Findings(), "");
    EXPECT_EQ(Ask(kSpeaker, oprmreqSPEAKER_SET_VOLUME, OPrimitiveControl_SpeakerVolume(0)),
              oSUCCESS);
  });
  EXPECT_EQ(CountFindings("speaker volume 0x0 is louder than ospkvol10dB (0xf600)"), 1);
}

TEST_F(PrimitiveRequestsTest, CameraSettingsHaveThreeValuesEach) {
  As([&] {
    for (const OPrimitiveRequest request :
         {oprmreqCAM_SET_WHITE_BALANCE, oprmreqCAM_SET_GAIN, oprmreqCAM_SET_SHUTTER_SPEED}) {
      for (const longword good : {1, 2, 3})
        EXPECT_EQ(Ask(kCamera, request, OPrimitiveControl_CameraParam(good)), oSUCCESS);
      for (const longword bad : {0, 4})
        EXPECT_EQ(Ask(kCamera, request, OPrimitiveControl_CameraParam(bad)), oINVALID_ARG);
    }
  });
}

TEST_F(PrimitiveRequestsTest, JointsAndLightsTakeDirectCommands) {
  Angle(kPan) = 0.25;
  As([&] {
    EXPECT_EQ(Ask(kPan, oprmreqJOINT2_SET_COMMAND, OPrimitiveControl_JointCommandValue2(1234)),
              oSUCCESS);
    EXPECT_EQ(Ask(kEyeLed, oprmreqLED2_SET_COMMAND, OPrimitiveControl_LEDCommandValue2(oledON)),
              oSUCCESS);
    EXPECT_EQ(Pan(), 1234);
    EXPECT_EQ(devices().leds[0].intensity, 1);
    OPrimitiveControl_JointValue value;
    EXPECT_EQ(OPENR::ControlPrimitive(mover->Open(kPan), oprmreqJOINT2_GET_VALUE, nullptr, 0,
                                      &value, sizeof value),
              oSUCCESS);
    EXPECT_EQ(value.jval.value, 250000);
  });
}

// The joints of an object that crashes go to a safe posture, and those of others stay.
TEST_F(PrimitiveRequestsTest, AJointBelongsToTheObjectThatHasCommandedIt) {
  As([&] {
    EXPECT_EQ(Ask(kPan, oprmreqJOINT2_SET_COMMAND, OPrimitiveControl_JointCommandValue2(1234)),
              oSUCCESS);
  });
  const auto pan = static_cast<size_t>(model.FindJointByLocator(kPan));
  EXPECT_EQ(devices().joints[pan].commander, mover->host().id);
}

TEST_F(PrimitiveRequestsTest, WrongIdsRequestsAndSizesAreRefused) {
  As([&] {
    OPrimitiveControl_SpeakerVolume volume(ospkvol18dB);
    const OPrimitiveID speaker = mover->Open(kSpeaker);
    const auto set = [&](OPrimitiveID id, void* param, size_t size) {
      return OPENR::ControlPrimitive(id, oprmreqSPEAKER_SET_VOLUME, param, size, nullptr, 0);
    };
    EXPECT_EQ(set(12345, &volume, sizeof volume), oINVALID_PRIMITIVE_ID);
    EXPECT_EQ(set(oprimitiveID_UNDEF, &volume, sizeof volume), oINVALID_PRIMITIVE_ID);
    EXPECT_EQ(set(speaker, nullptr, 0), oINVALID_ARG);
    EXPECT_EQ(set(speaker, &volume, 1), oINVALID_ARG);
    char large[200] = {};
    EXPECT_EQ(set(speaker, large, sizeof large), oINVALID_ARG);
    EXPECT_EQ(robot->speaker().volume(), ospkvol10dB);
    EXPECT_EQ(Ask(kMic, oprmreqSPEAKER_MUTE_ON), oINVALID_ARG);  // no speaker
    EXPECT_EQ(Ask(kSpeaker, 4711), oINVALID_ARG);
    EXPECT_EQ(Ask(kSpeaker, oprmreqUNDEF), oINVALID_ARG);
    EXPECT_EQ(Ask(kSpeaker, oprmreqBT_ATTACH), oINVALID_ARG);
  });
  EXPECT_EQ(CountFindings("request 130 of PRM:/r1/c1/c2/c3/s1-Speaker:S1 takes 4 bytes and answers "
                          "0, got room for 1 and 0"),
            1);
  EXPECT_EQ(CountFindings("PRM:/r1/c1/c2/c3/m1-Mic:M1 has no request 128"), 1);
}

// The packing of its 100 bytes is not known.
TEST_F(PrimitiveRequestsTest, ReadingATableOfColoursIsNotSupported) {
  As([&] {
    OPrimitiveControl_Cdt table = {};
    EXPECT_EQ(OPENR::ControlPrimitive(mover->Open(kCamera), oprmreqCAM_GET_CDT_TABLE, &table,
                                      sizeof table, &table, sizeof table),
              oNOT_SUPPORTED);
  });
}

class Ers7RequestsTest : public PrimitiveRequestsTest {
 protected:
  Ers7RequestsTest() : PrimitiveRequestsTest({}, "ers7") {}
};

TEST_F(Ers7RequestsTest, EarsAndLightsOfTheErs7) {
  As([&] {
    EXPECT_EQ(Ask("PRM:/r1/c1/c2/c3/e5-Joint4:15", oprmreqJOINT4_SET_COMMAND,
                  OPrimitiveControl_JointCommandValue4(ojoint4_STATE1)),
              oSUCCESS);
    EXPECT_EQ(devices().plungers[0].state, ojoint4_STATE1);
    EXPECT_EQ(Ask("PRM:/r1/c1/c2/c3/la-LED3:la", oprmreqLED3_SET_COMMAND,
                  OPrimitiveControl_LEDCommandValue3(99, oled3_MODE_B)),
              oSUCCESS);
    EXPECT_EQ(devices().leds[6].intensity, 99);
    EXPECT_EQ(devices().leds[7].mode, oled3_MODE_B);  // the face has one mode
  });
}

}  // namespace
}  // namespace openr_host
