// Sensor vectors, the OPENR:: functions and power: robot.md sections 5, 7, 8 and 15.
#include <gtest/gtest.h>

#include "tests/virtualrobot/comm_fixture.h"
#include "virtualrobot/vectors/frame_number.h"

namespace openr_host {
namespace {

// ---- sensors

TEST_F(VirtualRobotCommTest, SensorVectorsComeEvery32MillisecondsWithConsecutiveFrames) {
  Boot();
  RunToFrame(16);
  EXPECT_EQ(watcher->frames, (std::vector<longword>{0, 4, 8, 12}));
  EXPECT_EQ(watcher->times, (std::vector<int64_t>{32000, 64000, 96000, 128000}));
}

TEST_F(VirtualRobotCommTest, ASlowObserverLosesVectorsAndThenGetsTheNewest) {
  watcher->assert_ready = false;
  Boot();
  RunToFrame(40);
  EXPECT_EQ(watcher->frames, std::vector<longword>{0});
  RunAs(watcher, [&] { watcher->sensor->AssertReady(); });
  system.RunFor(1);
  EXPECT_EQ(watcher->frames, (std::vector<longword>{0, 36}));
}

TEST_F(VirtualRobotCommTest, AVectorUnderReferenceIsNeverOverwritten) {
  RCRegion* kept = nullptr;
  watcher->on_vector = [&](const ONotifyEvent& event) {
    if (kept != nullptr) return;
    kept = event.RCData(0);
    kept->AddReference();
  };
  Boot();
  RunToFrame(4);
  const std::vector<char> before(kept->Base(), kept->Base() + kept->Size());
  RunToFrame(60);
  EXPECT_EQ(std::memcmp(before.data(), kept->Base(), before.size()), 0);
}

TEST_F(VirtualRobotCommTest, TheVectorHasTheRobotsLayoutAndEveryId) {
  size_t size = 0;
  std::vector<OPrimitiveID> ids;
  watcher->on_vector = [&](const ONotifyEvent& event) {
    size = event.RCData(0)->Size();
    auto* vector = reinterpret_cast<OSensorFrameVectorData*>(event.RCData(0)->Base());
    ids.clear();
    for (int i = 0; i < static_cast<int>(vector->vectorInfo.numData); ++i) {
      ids.push_back(vector->GetInfo(i)->primitiveID);
    }
  };
  Boot();
  RunToFrame(4);
  EXPECT_EQ(size, 9120u);
  ASSERT_EQ(ids.size(), 31u);
  As([&] {
    EXPECT_EQ(ids[1], mover->Open(kPan));
    EXPECT_EQ(ids[5], mover->Open("PRM:/r1/c1/c2/c3/p1-Sensor:p1"));
    EXPECT_EQ(ids[30], mover->Open("PRM:/a3-Sensor:a3"));
  });
}

TEST_F(VirtualRobotCommTest, DistanceIsClampedToTheSensorsRange) {
  Boot();
  const int psd = model.FindSensorByLocator("PRM:/r1/c1/c2/c3/p1-Sensor:p1");
  body->distance_m = 0.03;
  RunToFrame(2);
  EXPECT_EQ(robot->sensor(psd).value, 100000);
  body->distance_m = 5;
  RunToFrame(3);
  EXPECT_EQ(robot->sensor(psd).value, 900000);
}

TEST_F(VirtualRobotCommTest, PawsAndGravityAreReported) {
  Boot();
  body->mutable_state().paws[0] = true;
  body->mutable_state().gravity_B = {0.5, -1.0, -9.81};
  RunToFrame(2);
  EXPECT_EQ(robot->sensor(11).value, oswitchON);
  EXPECT_EQ(robot->sensor(15).value, oswitchOFF);
  EXPECT_EQ(robot->sensor(28).value, 500000);    // front
  EXPECT_EQ(robot->sensor(29).value, 1000000);   // right
  EXPECT_EQ(robot->sensor(30).value, -9810000);  // up
}

TEST_F(VirtualRobotCommTest, APawsSwitchNeedsAForce) {
  Boot();
  body->mutable_state().paws.assign(4, true);
  body->mutable_state().paw_forces_n = {0.19, 0.21, 0, 4};
  RunToFrame(2);
  EXPECT_EQ(robot->sensor(11).value, oswitchOFF);
  EXPECT_EQ(robot->sensor(15).value, oswitchON);
  EXPECT_EQ(robot->sensor(19).value, oswitchOFF);
  EXPECT_EQ(robot->sensor(23).value, oswitchON);
}

TEST_F(VirtualRobotCommTest, ADarkThingIsSeenAsFarAsABrightOneUntilItIsOutOfSight) {
  Boot();
  const int psd = model.FindSensorByLocator("PRM:/r1/c1/c2/c3/p1-Sensor:p1");
  body->distance_m = 0.1;  // the table has no noise here
  body->reflectance = 0.05;
  RunToFrame(2);
  EXPECT_EQ(robot->sensor(psd).value, 100000);
  body->distance_m = 0.45;
  RunToFrame(3);
  EXPECT_EQ(robot->sensor(psd).value, 900000);
  body->reflectance = 1;
  RunToFrame(4);
  EXPECT_NEAR(robot->sensor(psd).value, 450000, 45000);
}

// ---- near and far sensor of an ERS-7 (field-notes.md 8.5)

class Ers7DistanceTest : public VirtualRobotCommTest {
 protected:
  Ers7DistanceTest() : VirtualRobotCommTest({}, "ers7") {}
  const OSensorValue& Near() const { return Newest("distance_near"); }
  const OSensorValue& Far() const { return Newest("distance_far"); }

 private:
  const OSensorValue& Newest(const char* name) const {
    return robot->sensor(model.SensorsNamed(name).front());
  }
};

// Near is measured in frames 0 to 6, which begin in the first 50 ms, far in frames 7 to 12.
TEST_F(Ers7DistanceTest, NearAndFarAreMeasuredInTurnAndTheSignalSaysWhich) {
  Boot();
  body->distance_m = 0.3;
  RunToFrame(1);  // the first frame measures both
  EXPECT_EQ(Near().value, 300'000);
  EXPECT_EQ(Far().value, 300'000);
  body->distance_m = 0.4;
  RunToFrame(7);
  EXPECT_EQ(Near().value, 400'000);
  EXPECT_EQ(Near().signal, 1);
  EXPECT_EQ(Far().value, 300'000);  // kept
  EXPECT_EQ(Far().signal, 0);
  RunToFrame(8);
  EXPECT_EQ(Far().value, 400'000);
  EXPECT_EQ(Far().signal, 1);
  EXPECT_EQ(Near().signal, 0);
  body->distance_m = 0.25;
  RunToFrame(13);
  EXPECT_EQ(Near().value, 400'000);
  EXPECT_EQ(Far().value, 250'000);
  RunToFrame(14);
  EXPECT_EQ(Near().value, 250'000);
}

// A program that polls far every 96 ms gets ten or so new values, then ten or so old ones (BBS 1904
// to 1909).
TEST_F(Ers7DistanceTest, PollingBeatsWithTheTurns) {
  Boot();
  std::string fresh;
  for (int i = 1; i <= 50; ++i) {
    RunToFrame(12 * i);
    fresh += Far().signal != 0 ? 'f' : '-';
  }
  EXPECT_EQ(fresh, "ffffffffff-------------ffffffffffff-------------ff");
}

TEST_F(Ers7DistanceTest, AHandBeforeASensorIsSeenAtAnyTime) {
  Boot();
  body->distance_m = 0.3;
  RunToFrame(2);
  EXPECT_EQ(system.inputs().Add(dog, "set distance_far 700000"), "");
  RunToFrame(3);
  EXPECT_EQ(Far().value, 700'000);
}

// ---- OPENR functions

TEST_F(VirtualRobotCommTest, ForeignLocatorsAreNotFound) {
  Boot();
  As([&] {
    OPrimitiveID id = 7;
    EXPECT_EQ(OPENR::OpenPrimitive("PRM:/r1/c1-Joint2:11", &id), oNOT_FOUND);
    EXPECT_EQ(id, oprimitiveID_UNDEF);
    EXPECT_EQ(OPENR::OpenPrimitive(nullptr, &id), oINVALID_ARG);
    char design[orobotdesignNAME_MAX + 1];
    EXPECT_EQ(OPENR::GetRobotDesign(design), oSUCCESS);
    EXPECT_STREQ(design, "ERS-210");
  });
}

TEST_F(VirtualRobotCommTest, GainsAreIneffectiveUntilEnabled) {
  Boot();
  As([&] {
    const OPrimitiveID pan = mover->Open(kPan);
    word p = 1, i = 1, d = 1, ps = 1, is = 1, ds = 1;
    EXPECT_EQ(OPENR::SetJointGain(pan, 0xd, 8, 0xb, 0xe, 2, 0xf), oGAIN_DISABLED);
    EXPECT_EQ(OPENR::GetJointGain(pan, &p, &i, &d, &ps, &is, &ds), oGAIN_DISABLED);
    EXPECT_EQ(p + i + d + ps + is + ds, 0);
    EXPECT_EQ(OPENR::EnableJointGain(pan), oSUCCESS);
    EXPECT_EQ(OPENR::SetJointGain(pan, 0xd, 8, 0xb, 0xe, 2, 0xf), oSUCCESS);
    EXPECT_EQ(OPENR::GetJointGain(pan, &p, &i, &d, &ps, &is, &ds), oSUCCESS);
    EXPECT_EQ(p, 0xd);
    EXPECT_EQ(OPENR::DisableJointGain(pan), oSUCCESS);
    EXPECT_EQ(OPENR::SetDefaultJointGain(pan), oFAIL);
    EXPECT_EQ(OPENR::RegisterDefaultJointGain(pan, 1, 2, 3, 4, 5, 6), oSUCCESS);
    EXPECT_EQ(OPENR::EnableJointGain(oprimitiveID_UNDEF), oSUCCESS);
    EXPECT_EQ(OPENR::SetDefaultJointGain(pan), oSUCCESS);
    EXPECT_EQ(OPENR::EnableJointGain(12345), oINVALID_PRIMITIVE_ID);
  });
}

TEST_F(VirtualRobotCommTest, ServosAreDrivenOnlyWithGainAndMotorPower) {
  Boot();
  const auto pan_index = static_cast<size_t>(model.FindJointByLocator(kPan));
  RunToFrame(1);
  EXPECT_FALSE(body->last_commands[pan_index].enabled);
  As([&] {
    OPENR::EnableJointGain(mover->Open(kPan));
    OPENR::SetJointGain(mover->Open(kPan), 13, 8, 11, 14, 2, 15);
  });
  RunToFrame(2);
  EXPECT_FALSE(body->last_commands[pan_index].enabled);
  As([&] { EXPECT_EQ(OPENR::SetMotorPower(opowerON), oSUCCESS); });
  RunToFrame(3);
  EXPECT_TRUE(body->last_commands[pan_index].enabled);
  EXPECT_EQ(body->last_commands[pan_index].gains.p, 13);
}

TEST_F(VirtualRobotCommTest, JointValuesAreThereBeforeTheFirstFrame) {
  body->mutable_state().joints[static_cast<size_t>(model.FindJointByLocator(kPan))].angle_rad =
      0.25;
  Boot();
  As([&] {
    OJointValue value;
    EXPECT_EQ(OPENR::GetJointValue(mover->Open(kPan), &value), oSUCCESS);
    EXPECT_EQ(value.value, 250000);
    EXPECT_EQ(OPENR::GetJointValue(mover->Open(kEyeLed), &value), oINVALID_PRIMITIVE_ID);
  });
}

// ---- power

class PowerWatcher : public CodeObject {
 public:
  PowerWatcher() {
    entry = AddExtra("UpdatePowerStatus", [this](void* message) {
      seen.push_back(static_cast<OPowerStatusMessage*>(message)->powerStatus.robotStatus);
    });
  }
  OServiceEntry Entry() const { return OServiceEntry(myOID_, entry); }
  Selector entry;
  std::vector<longword> seen;
};

TEST_F(VirtualRobotCommTest, PowerWatchersHearBothEdgesOfTheirBitsUntilTheyCancel) {
  PowerWatcher* power = system.AddObject<PowerWatcher>(dog, "power");
  Boot();
  RunAs(power, [&] {
    OPowerStatus filter;
    filter.Set(orsbMOTOR_POWER | orsbPAUSE, 0, opsoREMAINING_CAPACITY_NOT_NOTIFY,
               opsoTEMPERATURE_NOT_NOTIFY, opsoTIME_DIF_NOT_NOTIFY, opsoVOLUME_NOT_NOTIFY);
    EXPECT_EQ(OPENR::ObservePowerStatus(filter, power->Entry()), oSUCCESS);
    OPENR::SetMotorPower(opowerON);
    OPENR::SetMotorPower(opowerON);  // twice is harmless, and no edge
    OPENR::SetMotorPower(opowerOFF);
  });
  system.RunFor(1);
  ASSERT_EQ(power->seen.size(), 2u);
  EXPECT_NE(power->seen[0] & orsbMOTOR_POWER, 0u);
  EXPECT_EQ(power->seen[1] & orsbMOTOR_POWER, 0u);
  robot->PressPause();
  system.RunFor(1);
  ASSERT_EQ(power->seen.size(), 3u);
  EXPECT_NE(power->seen[2] & orsbPAUSE, 0u);
  RunAs(power, [&] {
    EXPECT_EQ(OPENR::UnobservePowerStatus(power->Entry()), oSUCCESS);
    EXPECT_EQ(OPENR::UnobservePowerStatus(power->Entry()), oINVALID_ARG);
  });
}

TEST_F(VirtualRobotCommTest, ThePauseButtonCutsMotorPowerInHardware) {
  Boot();
  As([&] { OPENR::SetMotorPower(opowerON); });
  robot->PressPause();
  As([&] {
    OPENR::SetMotorPower(opowerON);
    OPowerStatus status;
    EXPECT_EQ(OPENR::GetPowerStatus(&status), oSUCCESS);
    EXPECT_EQ(status.robotStatus & orsbMOTOR_POWER, 0u);
  });
}

TEST_F(VirtualRobotCommTest, ShutdownReturnsToItsCallerThenStopsAndDestroys) {
  Boot();
  bool returned = false;
  As([&] {
    EXPECT_EQ(OPENR::Shutdown(OBootCondition(obcbPAUSE_SW)), oSUCCESS);
    returned = true;
  });
  EXPECT_TRUE(returned);
  EXPECT_FALSE(system.powered_off());
  system.RunFor(kFrameUs);
  EXPECT_TRUE(system.powered_off());
}

TEST_F(VirtualRobotCommTest, TheClockCanBeSetAndRunsOnVirtualTime) {
  Boot();
  As([&] {
    EXPECT_EQ(OPENR::SetTime(OTime(1000, 2)), oSUCCESS);
    OTime now;
    EXPECT_EQ(OPENR::GetTime(&now), oSUCCESS);
    EXPECT_EQ(now.GetClock(), 1000);
  });
  RunToFrame(250);  // 2 s
  As([&] {
    OTime now;
    OPENR::GetTime(&now);
    EXPECT_EQ(now.GetClock(), 1002);
    EXPECT_EQ(now.GetTimeDif(), 2);
    EXPECT_EQ(OPENR::SetTimeDifference(13), oFAIL);
  });
}

TEST(FrameNumberTest, BeginsAnewAfterTheLargestNumber) {
  EXPECT_EQ(FrameNumber(5), 5u);
  EXPECT_EQ(FrameNumber(oframeMAX_NUMBER), oframeMAX_NUMBER);
  EXPECT_EQ(FrameNumber(int64_t{oframeMAX_NUMBER} + 1), 0u);
}

}  // namespace
}  // namespace openr_host
