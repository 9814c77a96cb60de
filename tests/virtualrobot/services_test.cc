// Wiring, streams and the rhythm of the samples: robot.md 1, 6, 7, 9, 10 and 14.
#include <OPENR/OPENRServices.h>
#include <gtest/gtest.h>

#include "tests/virtualrobot/comm_fixture.h"

namespace openr_host {
namespace {

TEST_F(VirtualRobotCommTest, TheRobotHasItsSixServices) {
  Boot();
  for (const char* service :
       {ovrcommSENSOR, ovrcommEFFECTOR, ovrcommFBK, ovrcommMIC, ovrcommSPEAKER, ovrcommALERT}) {
    EXPECT_EQ(system.robot(dog).directory.count(service), 1u) << service;
  }
}

TEST_F(VirtualRobotCommTest, EveryPrimitiveOfTheErs210CanBeOpenedByEveryObject) {
  Boot();
  std::vector<std::string> locators = {kSpeaker, kMic, kCamera};
  for (const Sensor& sensor : model.sensors) locators.push_back(sensor.locator);
  for (const Led& led : model.leds) locators.push_back(led.locator);
  for (const Plunger& plunger : model.plungers) locators.push_back(plunger.locator);
  EXPECT_EQ(locators.size(), 3u + 31 + 9 + 2);
  for (const std::string& locator : locators) {
    OPrimitiveID a = 0, b = 0;
    As([&] { EXPECT_EQ(OPENR::OpenPrimitive(locator.c_str(), &a), oSUCCESS) << locator; });
    RunAs(watcher, [&] { OPENR::OpenPrimitive(locator.c_str(), &b); });
    EXPECT_EQ(a, b);
    EXPECT_NE(a, oprimitiveID_UNDEF);
  }
}

// Opens a primitive in DoInit, as most programs do, and fails if that fails.
class Opener : public CodeObject {
 public:
  explicit Opener(const char* locator) : locator_(locator) {}
  OStatus DoInit(const OSystemEvent&) override { return OPENR::OpenPrimitive(locator_, &id); }
  OPrimitiveID id = 0;

 private:
  const char* const locator_;
};

// A broken ERS-7 logged status 6 (field-notes.md 5.4).
TEST_F(VirtualRobotCommTest, APartThatIsMissingBeforeTheBootCannotBeOpened) {
  const auto* const opener = system.AddObject<Opener>(dog, "opener", kPan);
  EXPECT_EQ(system.inputs().Add(dog, "break neck_pan missing"), "");
  Boot();
  EXPECT_EQ(opener->id, oprimitiveID_UNDEF);
  EXPECT_EQ(CountFindings("DoInit returned status 6"), 1);
  As([&] {
    OPrimitiveID id = 0;
    EXPECT_EQ(OPENR::OpenPrimitive(kPan, &id), oNOT_FOUND);
    EXPECT_EQ(OPENR::OpenPrimitive(kTilt, &id), oSUCCESS);
  });
}

// field-notes.md 5.3: such a robot does not boot.
TEST_F(VirtualRobotCommTest, ALimbThatIsMissingBeforeTheBootIsReported) {
  for (const char* joint : {"LF_j1", "LF_j2", "LF_j3", "neck_pan"})
    EXPECT_EQ(system.inputs().Add(dog, std::string("break ") + joint + " missing"), "");
  Boot();
  EXPECT_EQ(CountFindings("all joints of PRM:/r2 are missing (LF_j1, LF_j2, LF_j3): the robot's "
                          "boot ends with 'DR OPEN-R SDK version can run odrexecMODE3 only' and "
                          "OPENR::Fatal(-1)"),
            1);
  EXPECT_EQ(CountFindings("all joints of"), 1);  // the head has other joints
}

TEST_F(VirtualRobotCommTest, ALimbThatIsMissingAfterTheBootEndsNoBoot) {
  for (const char* joint : {"LF_j1", "LF_j2"})
    EXPECT_EQ(system.inputs().Add(dog, std::string("break ") + joint + " missing"), "");
  Boot();
  EXPECT_EQ(system.inputs().Add(dog, "break LF_j3 missing"), "");
  RunToFrame(1);
  EXPECT_EQ(CountFindings("all joints of"), 0);
}

TEST_F(VirtualRobotCommTest, ALimbThatIsRepairedBeforeTheBootIsNotReported) {
  for (const char* line :
       {"break LF_j1 missing", "break LF_j2 missing", "break LF_j3 missing", "repair LF_j2"})
    EXPECT_EQ(system.inputs().Add(dog, line), "");
  Boot();
  EXPECT_EQ(CountFindings("all joints of"), 0);
}

// All inputs of faults come before DoInit at time 0, so that they keep their order.
TEST_F(VirtualRobotCommTest, AllFaultsAtTimeZeroComeBeforeTheBoot) {
  EXPECT_EQ(system.inputs().Add(dog, "break neck_pan dead"), "");
  system.Boot();
  EXPECT_TRUE(system.RunUntil([&] { return system.booted(); }, 0));
  EXPECT_EQ(robot->parts().faults.Present(), Log{"neck_pan dead"});
}

TEST_F(VirtualRobotCommTest, OtherInputsAtTimeZeroComeAfterTheBoot) {
  EXPECT_EQ(system.inputs().Add(dog, "battery 42%"), "");
  system.Boot();
  EXPECT_TRUE(system.RunUntil([&] { return system.booted(); }, 0));
  EXPECT_NE(robot->parts().power.remaining_percent(), 42);
  system.RunFor(1);
  EXPECT_EQ(robot->parts().power.remaining_percent(), 42);
}

TEST_F(VirtualRobotCommTest, APartThatIsOpenStaysOpenWhenItIsMissingLater) {
  Boot();
  OPrimitiveID pan = 0;
  As([&] { pan = mover->Open(kPan); });
  EXPECT_EQ(system.inputs().Add(dog, "break neck_pan missing"), "");
  RunToFrame(1);
  As([&] {
    OPrimitiveID again = 0;
    EXPECT_EQ(OPENR::OpenPrimitive(kPan, &again), oNOT_FOUND);
    OJointValue value;
    EXPECT_EQ(OPENR::GetJointValue(pan, &value), oSUCCESS);
  });
  EXPECT_EQ(Findings(), "");
}

// Lights and the camera have no name, so they are named by their locators.
TEST_F(VirtualRobotCommTest, AMissingLightCanBeRepaired) {
  Boot();
  const std::string eye = kEyeLed;
  EXPECT_EQ(system.inputs().Add(dog, "break " + eye + " missing"), "");
  RunToFrame(1);
  EXPECT_EQ(robot->parts().faults.Present(), Log{eye + " missing"});
  OPrimitiveID id = 0;
  As([&] { EXPECT_EQ(OPENR::OpenPrimitive(kEyeLed, &id), oNOT_FOUND); });
  EXPECT_EQ(system.inputs().Add(dog, "repair " + eye), "");
  RunToFrame(2);
  As([&] { EXPECT_EQ(OPENR::OpenPrimitive(kEyeLed, &id), oSUCCESS); });
  EXPECT_TRUE(robot->parts().faults.Present().empty());
}

TEST_F(VirtualRobotCommTest, SeveralObserversGetEverySensorVector) {
  class Second : public CodeObject {
   public:
    Second() {
      sensor = AddObserver("Second.Sensor.OSensorFrameVectorData.O", [this](const ONotifyEvent&) {
        ++count;
        sensor->AssertReady();
      });
    }
    OStatus DoStart(const OSystemEvent&) override { return sensor->AssertReady(); }
    OObserver* sensor;
    int count = 0;
  };
  auto* const second = system.AddObject<Second>(dog, "second");
  system.Connect({dog, "OVirtualRobotComm.Sensor.OSensorFrameVectorData.S",
                  "Second.Sensor.OSensorFrameVectorData.O", "test"});
  Boot();
  RunToFrame(40);
  EXPECT_EQ(watcher->frames.size(), 10u);
  EXPECT_EQ(second->count, 10);
}

TEST_F(VirtualRobotCommTest, AnObjectThatKeepsEveryVectorIsReported) {
  watcher->on_vector = [](const ONotifyEvent& event) { event.RCData(0)->AddReference(); };
  Boot();
  RunToFrame(4 * 63);
  EXPECT_EQ(Findings(), "");
  RunToFrame(4 * 64);
  EXPECT_EQ(CountFindings("objects keep 64 vectors of one stream"), 1);
}

// BattChecker: a subject that never sends.
TEST_F(VirtualRobotCommTest, ASilentSubjectOfTheEffectorDisturbsNobody) {
  system.AddObject<Mover>(dog, "silent", "Silent");
  system.Connect({dog, "Silent.Move.OCommandVectorData.S",
                  "OVirtualRobotComm.Effector.OCommandVectorData.O", "test"});
  Boot();
  mover->readies.clear();
  As([&] {
    RCRegion* const region = mover->NewVector(1);
    Mover::FillJoint(region, 0, mover->Open(kPan), {1, 2});
    mover->Send({region});
  });
  RunToFrame(10);
  EXPECT_EQ(mover->readies, std::vector<int64_t>{3});
}

TEST_F(VirtualRobotCommTest, OnlyListedPrimitivesAreTouchedAndTheLastSetPointStays) {
  Boot();
  OPrimitiveID pan = 0, tilt = 0;
  As([&] {
    pan = mover->Open(kPan);
    tilt = mover->Open(kTilt);
    RCRegion* const both = mover->NewVector(2);
    Mover::FillJoint(both, 0, pan, {100});
    Mover::FillJoint(both, 1, tilt, {200});
    RCRegion* const one = mover->NewVector(15);
    Mover::Data(one)->SetNumData(1);  // PIDControl: one of fifteen
    Mover::FillJoint(one, 0, pan, {300});
    mover->Send({both, one});
  });
  RunToFrame(1000);
  EXPECT_EQ(Pan(), 300);
  EXPECT_EQ(devices().joints[0].target_urad, 200);
  EXPECT_EQ(Findings(), "");
}

// MovingLegs: 1 + 48 + 48 vectors of 16 frames, two at a time.
TEST_F(VirtualRobotCommTest, NinetySevenVectorsTakeTwelveAndAHalfSeconds) {
  Boot();
  mover->readies.clear();
  std::vector<RCRegion*> buffers;
  OPrimitiveID leg = 0;
  int sent = 0;
  // `count` free regions with one notification.
  const auto send_free = [&](size_t count) {
    std::vector<RCRegion*> regions;
    for (RCRegion* region : buffers) {
      if (region->NumberOfReference() != 1 || regions.size() == count || sent == 97) continue;
      Mover::FillJoint(region, 0, leg, std::vector<int>(16, ++sent));
      regions.push_back(region);
    }
    if (!regions.empty()) mover->Send(regions);
  };
  mover->on_ready = [&] { send_free(sent == 1 ? 2 : 1); };  // both are free after the first
  As([&] {
    leg = mover->Open("PRM:/r2/c1-Joint2:j1");
    buffers = {mover->NewVector(1), mover->NewVector(1)};
    send_free(1);
  });
  RunToFrame(2000);
  EXPECT_EQ(sent, 97);
  ASSERT_EQ(mover->readies.size(), 97u);
  // 12.416 s and one frame behind the holding vector, whose ready had nothing to follow it.
  EXPECT_EQ(mover->readies.back(), 1 + 97 * 16 + 1);
}

// MovingEar: vectors of sixteen frames, each 128 ms.
TEST_F(VirtualRobotCommTest, SixteenFramesOfAnEarTakeTwoSeconds) {
  Boot();
  mover->readies.clear();
  As([&] {
    RCRegion* const region = mover->NewVector(1);
    Mover::Data(region)->GetInfo(0)->Set(odataJOINT_COMMAND3, mover->Open(kEar), 16);
    auto* const value =
        reinterpret_cast<OJointCommandValue3*>(Mover::Data(region)->GetData(0)->value);
    for (int i = 0; i < 16; ++i) value[i].value = ojoint3_STATE1;
    mover->Send({region});
  });
  RunToFrame(300);
  EXPECT_EQ(mover->readies, std::vector<int64_t>{1 + 256});
}

TEST_F(VirtualRobotCommTest, ALightLastsTheSumOfItsPeriodsAndAPeriodOfZeroCountsAsOne) {
  Boot();
  mover->readies.clear();
  As([&] {
    RCRegion* const region = mover->NewVector(1);
    Mover::Data(region)->GetInfo(0)->Set(odataLED_COMMAND2, mover->Open(kEyeLed), 3);
    auto* const value =
        reinterpret_cast<OLEDCommandValue2*>(Mover::Data(region)->GetData(0)->value);
    value[0] = {oledON, 4, 0};
    value[1] = {oledOFF, 0, 0};
    value[2] = {oledON, 2, 0};
    mover->Send({region});
  });
  RunToFrame(4);
  EXPECT_EQ(devices().leds[0].intensity, 1);
  RunToFrame(5);
  EXPECT_EQ(devices().leds[0].intensity, 0);
  RunToFrame(6);
  EXPECT_EQ(devices().leds[0].intensity, 1);
  RunToFrame(20);
  EXPECT_EQ(mover->readies, std::vector<int64_t>{8});
}

TEST_F(VirtualRobotCommTest, ALateVectorBeginsWithTheNextFrameAndTheJointHoldsUntilThen) {
  Boot();
  As([&] {
    RCRegion* const region = mover->NewVector(1);
    Mover::FillJoint(region, 0, mover->Open(kPan), {11});
    mover->Send({region});
  });
  RunToFrame(50);
  EXPECT_EQ(Pan(), 11);
  system.RunFor(1000);
  As([&] {
    RCRegion* const region = mover->NewVector(1);
    Mover::FillJoint(region, 0, mover->Open(kPan), {22});
    mover->Send({region});
  });
  system.RunFor(6999);
  EXPECT_EQ(Pan(), 11);
  RunToFrame(51);
  EXPECT_EQ(Pan(), 22);
}

// ---- gains for all opened joints

TEST_F(VirtualRobotCommTest, TheUndefinedIdStandsForEveryOpenedJoint) {
  Boot();
  As([&] {
    mover->Open(kPan);
    mover->Open(kEyeLed);
    EXPECT_EQ(OPENR::EnableJointGain(oprimitiveID_UNDEF), oSUCCESS);
    EXPECT_EQ(OPENR::SetJointGain(oprimitiveID_UNDEF, 1, 2, 3, 4, 5, 6), oSUCCESS);
    for (size_t j = 0; j < devices().joints.size(); ++j) {
      const bool opened = model.joints[j].locator == kPan;
      EXPECT_EQ(devices().joints[j].gain_enabled, opened);
      EXPECT_EQ(devices().joints[j].gains[5], opened ? 6 : 0);
    }
    word p = 1, i = 1, d = 1, ps = 1, is = 1, ds = 1;
    EXPECT_EQ(OPENR::GetJointGain(oprimitiveID_UNDEF, &p, &i, &d, &ps, &is, &ds),
              oINVALID_PRIMITIVE_ID);
    EXPECT_EQ(p + i + d + ps + is + ds, 0);
    EXPECT_EQ(OPENR::DisableJointGain(oprimitiveID_UNDEF), oSUCCESS);
    EXPECT_EQ(devices().joints[1].gains[5], 0);
  });
}

TEST_F(VirtualRobotCommTest, ALimpJointReportsWhereItIsAndItsSetPointStays) {
  Boot();
  OPrimitiveID pan = 0;
  As([&] {
    pan = mover->Open(kPan);
    RCRegion* const region = mover->NewVector(1);
    Mover::FillJoint(region, 0, pan, {1000});
    mover->Send({region});
  });
  Angle(kPan) = -0.5;  // by hand
  RunToFrame(5);
  As([&] {
    OJointValue value;
    EXPECT_EQ(OPENR::GetJointValue(pan, &value), oSUCCESS);
    EXPECT_EQ(value.value, -500000);
    EXPECT_EQ(value.refValue, 1000);
  });
}

TEST_F(VirtualRobotCommTest, TheHeaderOfASensorVector) {
  ODataVectorInfo header{};
  OSensorFrameInfo info{};
  watcher->on_vector = [&](const ONotifyEvent& event) {
    auto* const vector = reinterpret_cast<OSensorFrameVectorData*>(event.RCData(0)->Base());
    header = vector->vectorInfo;
    info = *vector->GetInfo(30);
    EXPECT_EQ(event.NumOfData(), 1);
    EXPECT_EQ(header.memRegionID, event.RCData(0)->MemID());
  };
  Boot();
  RunToFrame(4);
  EXPECT_EQ(header.type, odataSENSOR_FRAME_VECTOR);
  EXPECT_EQ(header.offset, 0u);
  EXPECT_EQ(header.totalSize, 9120u);
  EXPECT_EQ(header.infoOffset, 192u);
  EXPECT_EQ(header.infoSize, 32u);
  EXPECT_EQ(header.maxNumData, 31u);
  EXPECT_EQ(header.numData, 31u);
  EXPECT_EQ(header.syncKey, ovrsynckeyUNDEF);
  EXPECT_EQ(info.type, odataACCELERATION);
  EXPECT_EQ(info.numFrames, 4u);
  EXPECT_EQ(info.frameSize, 16u);
  EXPECT_EQ(info.dataSize, 256u);
}

// ---- what the power manager watches: robot.md 15.2

class NumberWatcher : public CodeObject {
 public:
  NumberWatcher() {
    entry = AddExtra("Update", [this](void* message) {
      seen.push_back(static_cast<OPowerStatusMessage*>(message)->powerStatus);
    });
  }
  void Watch(word capacity, sbyte time_difference, byte volume) {
    OPowerStatus what;
    what.Set(0, 0, capacity, opsoTEMPERATURE_NOT_NOTIFY, time_difference, volume);
    EXPECT_EQ(OPENR::ObservePowerStatus(what, OServiceEntry(myOID_, entry)), oSUCCESS);
  }
  Selector entry;
  std::vector<OPowerStatus> seen;
};

TEST_F(VirtualRobotCommTest, ANumberIsWatchedForEveryChangeForOneValueOrNever) {
  auto* const every = system.AddObject<NumberWatcher>(dog, "every");
  auto* const becomes = system.AddObject<NumberWatcher>(dog, "becomes");
  auto* const never = system.AddObject<NumberWatcher>(dog, "never");
  Boot();
  const word no_capacity = opsoREMAINING_CAPACITY_NOT_NOTIFY;
  RunAs(every, [&] {
    every->Watch(no_capacity, opsoTIME_DIF_NOTIFY_EVERY_CHANGE, opsoVOLUME_NOTIFY_EVERY_CHANGE);
  });
  RunAs(becomes, [&] { becomes->Watch(no_capacity, opsoTIME_DIF_NOT_NOTIFY, ovolumeSW1); });
  RunAs(never, [&] { never->Watch(no_capacity, opsoTIME_DIF_NOT_NOTIFY, opsoVOLUME_NOT_NOTIFY); });
  As([&] {
    EXPECT_EQ(OPENR::SetVolumeSwitch(4), oFAIL);
    EXPECT_EQ(OPENR::SetVolumeSwitch(ovolumeSW1), oSUCCESS);
    EXPECT_EQ(OPENR::SetVolumeSwitch(ovolumeSW1), oSUCCESS);  // no change
    EXPECT_EQ(OPENR::SetVolumeSwitch(ovolumeSW0), oSUCCESS);  // leaves the value
    EXPECT_EQ(OPENR::SetTimeDifference(9), oSUCCESS);
    OVolumeSwitch volume = 9;
    EXPECT_EQ(OPENR::GetVolumeSwitch(&volume), oSUCCESS);
    EXPECT_EQ(volume, ovolumeSW0);
    sbyte hours = 0;
    EXPECT_EQ(OPENR::GetTimeDifference(&hours), oSUCCESS);
    EXPECT_EQ(hours, 9);
  });
  system.RunFor(1);
  ASSERT_EQ(every->seen.size(), 3u);
  EXPECT_EQ(every->seen[0].volume, ovolumeSW1);
  EXPECT_EQ(every->seen[2].timeDif, 9);
  ASSERT_EQ(becomes->seen.size(), 1u);
  EXPECT_EQ(becomes->seen[0].volume, ovolumeSW1);
  EXPECT_TRUE(never->seen.empty());
}

TEST_F(VirtualRobotCommTest, RemainingCapacityFallsAndIsWatched) {
  auto* const power = system.AddObject<NumberWatcher>(dog, "power");
  Boot();
  RunAs(power, [&] { power->Watch(98, opsoTIME_DIF_NOT_NOTIFY, opsoVOLUME_NOT_NOTIFY); });
  RunToFrame(30'000);  // 240 s of 90 minutes
  ASSERT_EQ(power->seen.size(), 1u);
  EXPECT_EQ(power->seen[0].remainingCapacity, 98);
}

TEST_F(VirtualRobotCommTest, TheBootConditionSaysWhyTheRobotRuns) {
  Boot();
  As([&] {
    OBootCondition condition;
    EXPECT_EQ(OPENR::GetBootCondition(&condition), oSUCCESS);
    EXPECT_EQ(condition.bitmap, obcbPAUSE_SW);
  });
}

}  // namespace
}  // namespace openr_host
