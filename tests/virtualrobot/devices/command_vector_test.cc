// Findings about command vectors: robot.md 4 and 9.5, field-notes.md 7.5.
#include <gtest/gtest.h>

#include "tests/virtualrobot/comm_fixture.h"

namespace openr_host {
namespace {

class CommandVectorTest : public VirtualRobotCommTest {
 protected:
  void SetUp() override {
    Boot();
    As([&] { pan = mover->Open(kPan); });
  }
  // Sends a vector with one element for the pan joint, which `change` may spoil, and runs three
  // frames.
  void Play(const std::function<void(OCommandVectorData*)>& change) {
    mover->readies.clear();
    As([&] {
      RCRegion* region = mover->NewVector(1);
      Mover::FillJoint(region, 0, pan, {7});
      change(Mover::Data(region));
      mover->Send({region});
    });
    RunToFrame(robot->frame() + 3);
  }
  OPrimitiveID pan = 0;
};

TEST_F(CommandVectorTest, AGoodVectorGivesNoFinding) {
  Play([](OCommandVectorData*) {});
  EXPECT_EQ(Pan(), 7);
  EXPECT_EQ(Findings(), "");
}

TEST_F(CommandVectorTest, FindingsAreAboutTheObjectThatSentIt) {
  Play([](OCommandVectorData* data) { data->GetInfo(0)->primitiveID = 7; });
  ASSERT_EQ(system.findings().all().size(), 1u);
  EXPECT_EQ(system.findings().all()[0].object, "mover");
}

TEST_F(CommandVectorTest, MoreFramesThanAVectorHoldsAreReportedAndNotPlayed) {
  Play([](OCommandVectorData* data) {
    auto* const value = reinterpret_cast<OJointCommandValue2*>(data->GetData(0)->value);
    for (int i = 0; i < 16; ++i) value[i].value = 100 + i;
    data->GetInfo(0)->numFrames = 20;
  });
  EXPECT_EQ(CountFindings("element 0 of 1 says 20 frames; a vector has room for 16"), 1);
  RunToFrame(40);
  EXPECT_EQ(Pan(), 115);
  EXPECT_EQ(mover->readies, std::vector<int64_t>{17});
}

TEST_F(CommandVectorTest, AFrameThatWasNeverFilledIsReportedAndPlaysAsZero) {
  Play([](OCommandVectorData* data) { data->GetInfo(0)->numFrames = 2; });
  EXPECT_EQ(CountFindings("says 2 frames, of which frame 1 was never filled"), 1);
  EXPECT_EQ(Pan(), 0);
}

TEST_F(CommandVectorTest, AZeroThatWasMeantIsNone) {
  Play([](OCommandVectorData* data) {
    data->GetInfo(0)->numFrames = 2;
    reinterpret_cast<OJointCommandValue2*>(data->GetData(0)->value)[1].value = 0;
  });
  EXPECT_EQ(Findings(), "");
}

TEST_F(CommandVectorTest, AVectorRefilledWithFewerFramesIsFine) {
  As([&] {
    RCRegion* region = mover->NewVector(1);
    Mover::FillJoint(region, 0, pan, std::vector<int>(16, 5));
    Mover::FillJoint(region, 0, pan, {6, 6, 6, 6});
    mover->Send({region});
  });
  RunToFrame(10);
  EXPECT_EQ(Findings(), "");
}

TEST_F(CommandVectorTest, MoreElementsThanTheVectorWasMadeForAreReportedAndIgnored) {
  Play([](OCommandVectorData* data) { data->SetNumData(3); });
  EXPECT_EQ(CountFindings("SetNumData(3) on a vector made for 1 elements"), 1);
  EXPECT_EQ(Pan(), 7);
}

TEST_F(CommandVectorTest, AnElementThatNobodyOpenedIsIgnoredAndTakesItsTime) {
  Play([&](OCommandVectorData* data) { data->GetInfo(0)->primitiveID = pan + 1; });
  EXPECT_EQ(CountFindings("which nobody opened"), 1);
  EXPECT_EQ(mover->readies, std::vector<int64_t>{2});
}

TEST_F(CommandVectorTest, TheDataTypeMustBeThatOfThePrimitive) {
  Play([](OCommandVectorData* data) { data->GetInfo(0)->type = odataLED_COMMAND2; });
  EXPECT_EQ(CountFindings("has data type 260, which does not fit PRM:/r1/c1/c2-Joint2:j2"), 1);
  EXPECT_EQ(Pan(), 0);
}

TEST_F(CommandVectorTest, DataOutsideOfTheVectorAreNotRead) {
  Play([](OCommandVectorData* data) { data->GetInfo(0)->dataOffset = 1'000'000; });
  EXPECT_EQ(CountFindings("has its data at offset 1000000"), 1);
  Play([](OCommandVectorData* data) { data->GetInfo(0)->dataOffset += 2; });
  EXPECT_EQ(CountFindings("which is no place in the vector"), 2);
  EXPECT_EQ(Pan(), 0);
}

#ifndef __SANITIZE_ADDRESS__
TEST_F(CommandVectorTest, AWriteBehindTheEndIsReported) {
  Play([](OCommandVectorData* data) {
    reinterpret_cast<char*>(data)[data->vectorInfo.totalSize] = 1;
  });
  EXPECT_EQ(CountFindings("command vector: somebody wrote behind its end"), 1);
}
#endif

TEST_F(CommandVectorTest, AHeaderThatNamesOtherMemoryIsReported) {
  Play([](OCommandVectorData* data) { data->vectorInfo.memRegionID += 1; });
  EXPECT_EQ(CountFindings("its memRegionID names other memory than it came in"), 1);
  EXPECT_EQ(Pan(), 7);
}

TEST_F(CommandVectorTest, ARegionTooSmallForAVectorTakesAFrame) {
  mover->readies.clear();
  As([&] {
    const int number = 1;
    mover->move->SetData(&number, sizeof number);
    mover->move->NotifyObservers();
  });
  RunToFrame(4);
  EXPECT_EQ(CountFindings("4 bytes hold no vector"), 1);
  EXPECT_EQ(mover->readies, std::vector<int64_t>{2});
}

TEST_F(CommandVectorTest, AnEndlessWaitIsPointedOut) {
  Play([](OCommandVectorData* data) { data->vectorInfo.wait = 125'000; });
  EXPECT_EQ(CountFindings("wait = 125000: it starts only after 1000 s"), 1);
}

TEST_F(CommandVectorTest, TheObjectMayChangeAVectorWhileItPlays) {
  RCRegion* region = nullptr;
  As([&] {
    region = mover->NewVector(1);
    Mover::FillJoint(region, 0, pan, {1, 2, 3, 4});
    mover->Send({region});
  });
  RunToFrame(2);
  Mover::Data(region)->GetInfo(0)->dataOffset = 4'000'000;
  Mover::Data(region)->GetInfo(0)->numFrames = 4'000'000;
  RunToFrame(8);
  EXPECT_EQ(Pan(), 4);
}

// ---- the ERS-7's lights and ears

class Ers7Test : public VirtualRobotCommTest {
 protected:
  Ers7Test() : VirtualRobotCommTest({}, "ers7") {}
  static constexpr char kFace1[] = "PRM:/r1/c1/c2/c3/la-LED3:la";
  static constexpr char kFace14[] = "PRM:/r1/c1/c2/c3/ln-LED3:ln";
  static constexpr char kBack[] = "PRM:/lu-LED3:lu";
  static constexpr char kLeftEar[] = "PRM:/r1/c1/c2/c3/e5-Joint4:15";

  void FillLed3(RCRegion* region, int element, const char* locator, OLEDCommandValue3 value) {
    Mover::Data(region)->GetInfo(element)->Set(odataLED_COMMAND3, mover->Open(locator), 1);
    *reinterpret_cast<OLEDCommandValue3*>(Mover::Data(region)->GetData(element)->value) = value;
  }
  const LedDevice& Light(const std::string& locator) const {
    for (size_t i = 0; i < model.leds.size(); ++i) {
      if (model.leds[i].locator == locator) return devices().leds[i];
    }
    return devices().leds.at(1000);
  }
};

TEST_F(Ers7Test, ALightHasAnIntensityAndLastsItsPeriod) {
  Boot();
  mover->readies.clear();
  As([&] {
    RCRegion* region = mover->NewVector(2);
    FillLed3(region, 0, kFace1, {200, oled3_MODE_A, 5, 0});
    FillLed3(region, 1, kBack, {300, oled3_MODE_A, 3, 0});
    mover->Send({region});
  });
  RunToFrame(10);
  EXPECT_EQ(Light(kFace1).intensity, 200);
  EXPECT_EQ(Light(kBack).intensity, 255);
  EXPECT_EQ(mover->readies, std::vector<int64_t>{6});
  EXPECT_EQ(Findings(), "");
}

TEST_F(Ers7Test, TheModeOfTheLastLightOfTheFaceHoldsForAll) {
  Boot();
  As([&] {
    RCRegion* region = mover->NewVector(3);
    FillLed3(region, 0, kFace14, {200, oled3_MODE_B, 1, 0});
    FillLed3(region, 1, kFace1, {200, oled3_MODE_A, 1, 0});
    FillLed3(region, 2, kBack, {200, oled3_MODE_A, 1, 0});
    mover->Send({region});
  });
  RunToFrame(3);
  EXPECT_EQ(Light(kFace1).mode, oled3_MODE_B);
  EXPECT_EQ(Light(kBack).mode, oled3_MODE_A);  // is no part of the face
  EXPECT_EQ(CountFindings("modes A and B for lights of one face"), 1);
}

TEST_F(Ers7Test, AnEarLastsItsPeriod) {
  Boot();
  mover->readies.clear();
  As([&] {
    RCRegion* region = mover->NewVector(1);
    Mover::Data(region)->GetInfo(0)->Set(odataJOINT_COMMAND4, mover->Open(kLeftEar), 2);
    auto* const value =
        reinterpret_cast<OJointCommandValue4*>(Mover::Data(region)->GetData(0)->value);
    value[0] = {ojoint4_STATE0, 16, 0};
    value[1] = {ojoint4_STATE1, 16, 0};
    mover->Send({region});
  });
  RunToFrame(16);
  EXPECT_EQ(devices().plungers[0].state, ojoint4_STATE0);
  RunToFrame(40);
  EXPECT_EQ(devices().plungers[0].state, ojoint4_STATE1);
  EXPECT_EQ(mover->readies, std::vector<int64_t>{33});
}

}  // namespace
}  // namespace openr_host
