// OVirtualRobotComm and the OPENR:: functions: robot.md sections 5 to 9 and 16.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>

#include "runtime/core/system.h"
#include "tests/runtime/objcomm/probe.h"
#include "tests/virtualrobot/follow_body.h"
#include "virtualrobot/virtual_robot.h"

namespace openr_host {
namespace {

constexpr char kPan[] = "PRM:/r1/c1/c2-Joint2:j2";
constexpr char kEyeLed[] = "PRM:/r1/c1/c2/c3/l1-LED2:l1";
constexpr char kEar[] = "PRM:/r1/c1/c2/c3/e1-Joint3:j5";

using Log = std::vector<std::string>;

// Sends command vectors and notes when each ready comes.
class Mover : public CodeObject {
 public:
  explicit Mover(const std::string& name = "Mover") {
    move = AddSubject(name + ".Move.OCommandVectorData.S", [this](const OReadyEvent&) {
      readies.push_back(system().now_us() / kFrameUs);
      if (on_ready) on_ready();
    });
  }

  // A vector with `count` elements and the region that wraps it.
  RCRegion* NewVector(size_t count) {
    MemoryRegionID id = 0;
    OCommandVectorData* data = nullptr;
    EXPECT_EQ(OPENR::NewCommandVectorData(count, &id, &data), oSUCCESS);
    data->SetNumData(count);
    return new RCRegion(data->vectorInfo.memRegionID, data->vectorInfo.offset, data,
                        data->vectorInfo.totalSize);
  }
  static OCommandVectorData* Data(RCRegion* region) {
    return reinterpret_cast<OCommandVectorData*>(region->Base());
  }
  static void FillJoint(RCRegion* region, int element, OPrimitiveID id,
                        const std::vector<int>& values) {
    Data(region)->GetInfo(element)->Set(odataJOINT_COMMAND2, id, values.size());
    auto* const value =
        reinterpret_cast<OJointCommandValue2*>(Data(region)->GetData(element)->value);
    for (size_t i = 0; i < values.size(); ++i) value[i].value = values[i];
  }
  static void FillLed(RCRegion* region, int element, OPrimitiveID id, OLEDValue led, word period) {
    Data(region)->GetInfo(element)->Set(odataLED_COMMAND2, id, 1);
    auto* const value = reinterpret_cast<OLEDCommandValue2*>(Data(region)->GetData(element)->value);
    value[0].led = led;
    value[0].period = period;
  }
  OPrimitiveID Open(const char* locator) {
    OPrimitiveID id = 0;
    EXPECT_EQ(OPENR::OpenPrimitive(locator, &id), oSUCCESS);
    return id;
  }
  void Send(const std::vector<RCRegion*>& regions) {
    for (RCRegion* region : regions) move->SetData(region);
    move->NotifyObservers();
  }

  OSubject* move;
  std::vector<int64_t> readies;  // frame boundaries
  std::function<void()> on_ready;
};

class Watcher : public CodeObject {
 public:
  Watcher() {
    sensor =
        AddObserver("Watcher.Sensor.OSensorFrameVectorData.O", [this](const ONotifyEvent& event) {
          const auto* const vector = static_cast<const OSensorFrameVectorData*>(event.Data(0));
          frames.push_back(const_cast<OSensorFrameVectorData*>(vector)->GetInfo(0)->frameNumber);
          times.push_back(system().now_us());
          if (on_vector) on_vector(event);
          if (assert_ready) sensor->AssertReady();
        });
  }
  OStatus DoStart(const OSystemEvent&) override {
    sensor->AssertReady();
    return oSUCCESS;
  }
  OObserver* sensor;
  std::vector<longword> frames;
  std::vector<int64_t> times;
  bool assert_ready = true;
  std::function<void(const ONotifyEvent&)> on_vector;
};

class VirtualRobotCommTest : public testing::Test {
 protected:
  VirtualRobotCommTest() : model(LoadRobotModel(std::string(OPENR_MODEL_DIR) + "/ers210.json")) {
    dog = system.AddRobot("ERS-210", nullptr);
    auto made = std::make_unique<FollowBody>(model);
    body = made.get();
    robot = AddVirtualRobot(&system, dog, model, std::move(made));
    mover = system.AddObject<Mover>(dog, "mover");
    watcher = system.AddObject<Watcher>(dog, "watcher");
    system.Connect({dog, "Mover.Move.OCommandVectorData.S",
                    "OVirtualRobotComm.Effector.OCommandVectorData.O", "test"});
    system.Connect({dog, "OVirtualRobotComm.Sensor.OSensorFrameVectorData.S",
                    "Watcher.Sensor.OSensorFrameVectorData.O", "test"});
  }
  void Boot() {
    system.Boot();
    system.RunFor(1);
  }
  void RunToFrame(int64_t frame) { system.RunUntil(frame * kFrameUs); }
  void As(const std::function<void()>& body_of_handler) { RunAs(mover, body_of_handler); }
  int Pan() const {
    return devices().joints[static_cast<size_t>(model.FindJointByLocator(kPan))].target_urad;
  }
  const Devices& devices() const { return robot->devices(); }

  RobotModel model;
  System system;
  int dog;
  FollowBody* body;
  VirtualRobot* robot;
  Mover* mover;
  Watcher* watcher;
};

// ---- ready

TEST_F(VirtualRobotCommTest, TheEffectorIsReadyBeforeDoStartOfTheApplication) {
  Boot();
  As([&] { EXPECT_EQ(mover->move->IsReady(), 1); });
  EXPECT_EQ(mover->readies, std::vector<int64_t>{0});
}

TEST_F(VirtualRobotCommTest, ReadyComesWhenTheVectorIsOverAndItsRegionIsFree) {
  Boot();
  mover->readies.clear();
  RCRegion* a = nullptr;
  int references = 0;
  mover->on_ready = [&] { references = a->NumberOfReference(); };
  As([&] {
    a = mover->NewVector(1);
    Mover::FillJoint(a, 0, mover->Open(kPan), {10, 20, 30, 40});
    mover->Send({a});
    EXPECT_EQ(a->NumberOfReference(), 2);
  });
  RunToFrame(10);
  EXPECT_EQ(mover->readies, std::vector<int64_t>{5});  // begins at frame 1, 4 frames long
  EXPECT_EQ(references, 1);
  EXPECT_EQ(Mover::Data(a)->GetInfo(0)->frameNumber, 1u);
}

TEST_F(VirtualRobotCommTest, TwoVectorsInOneNotificationPlayInOrderAndEachGetsItsReady) {
  Boot();
  mover->readies.clear();
  RCRegion* a = nullptr;
  RCRegion* b = nullptr;
  std::vector<std::pair<int, int>> references;
  mover->on_ready = [&] {
    references.emplace_back(a->NumberOfReference(), b->NumberOfReference());
  };
  As([&] {
    const OPrimitiveID pan = mover->Open(kPan);
    a = mover->NewVector(1);
    b = mover->NewVector(1);
    Mover::FillJoint(a, 0, pan, std::vector<int>(16, 1000));
    Mover::FillJoint(b, 0, pan, std::vector<int>(16, 2000));
    mover->Send({a, b});
  });
  RunToFrame(16);
  EXPECT_EQ(Pan(), 1000);
  RunToFrame(17);
  EXPECT_EQ(Pan(), 2000);  // no gap
  RunToFrame(40);
  EXPECT_EQ(mover->readies, (std::vector<int64_t>{17, 33}));
  EXPECT_EQ(references, (std::vector<std::pair<int, int>>{{1, 2}, {1, 1}}));
}

TEST_F(VirtualRobotCommTest, ADoubleBufferedStreamHasASteadyRhythm) {
  Boot();
  mover->readies.clear();
  std::vector<RCRegion*> buffers;
  OPrimitiveID pan = 0;
  int value = 0;
  const auto fill_free = [&] {
    for (RCRegion* region : buffers) {
      if (region->NumberOfReference() != 1) continue;
      Mover::FillJoint(region, 0, pan, {++value, ++value, ++value, ++value});
      mover->Send({region});
      return;
    }
    ADD_FAILURE() << "no free region";
  };
  As([&] {
    pan = mover->Open(kPan);
    buffers = {mover->NewVector(1), mover->NewVector(1)};
    Mover::FillJoint(buffers[0], 0, pan, {++value, ++value, ++value, ++value});
    Mover::FillJoint(buffers[1], 0, pan, {++value, ++value, ++value, ++value});
    mover->Send(buffers);
  });
  mover->on_ready = fill_free;
  RunToFrame(41);
  EXPECT_EQ(mover->readies, (std::vector<int64_t>{5, 9, 13, 17, 21, 25, 29, 33, 37, 41}));
  EXPECT_EQ(Pan(), 41);  // one new set point per frame, none left out
}

TEST_F(VirtualRobotCommTest, SubjectsOfTheEffectorAreIndependent) {
  Mover* lights = system.AddObject<Mover>(dog, "lights", "Lights");
  system.Connect({dog, "Lights.Move.OCommandVectorData.S",
                  "OVirtualRobotComm.Effector.OCommandVectorData.O", "test"});
  Boot();
  mover->readies.clear();
  lights->readies.clear();
  As([&] {
    RCRegion* region = mover->NewVector(1);
    Mover::FillJoint(region, 0, mover->Open(kPan), {1, 2});
    mover->Send({region});
  });
  RunAs(lights, [&] {
    RCRegion* region = lights->NewVector(1);
    Mover::FillLed(region, 0, lights->Open(kEyeLed), oledON, 64);
    lights->Send({region});
  });
  RunToFrame(100);
  EXPECT_EQ(mover->readies, std::vector<int64_t>{3});
  EXPECT_EQ(lights->readies, std::vector<int64_t>{65});  // 64 frames: 512 ms
  EXPECT_EQ(devices().leds[0].intensity, 1);             // the last state stays
}

TEST_F(VirtualRobotCommTest, AnEarFrameLasts128Milliseconds) {
  Boot();
  mover->readies.clear();
  As([&] {
    RCRegion* region = mover->NewVector(1);
    Mover::Data(region)->GetInfo(0)->Set(odataJOINT_COMMAND3, mover->Open(kEar), 1);
    auto* const value =
        reinterpret_cast<OJointCommandValue3*>(Mover::Data(region)->GetData(0)->value);
    value->value = ojoint3_STATE1;
    mover->Send({region});
  });
  RunToFrame(30);
  EXPECT_EQ(mover->readies, std::vector<int64_t>{17});
  EXPECT_EQ(devices().plungers[0].state, ojoint3_STATE1);
}

TEST_F(VirtualRobotCommTest, TheLongestElementEndsTheVectorAndShorterOnesHold) {
  Boot();
  mover->readies.clear();
  As([&] {
    RCRegion* region = mover->NewVector(2);
    Mover::FillJoint(region, 0, mover->Open(kPan), {5, 6});
    Mover::FillLed(region, 1, mover->Open(kEyeLed), oledON, 10);
    mover->Send({region});
  });
  RunToFrame(20);
  EXPECT_EQ(mover->readies, std::vector<int64_t>{11});
  EXPECT_EQ(Pan(), 6);
}

TEST_F(VirtualRobotCommTest, AnEmptyVectorEndsWithItsFrame) {
  Boot();
  mover->readies.clear();
  As([&] {
    RCRegion* region = mover->NewVector(1);
    Mover::Data(region)->SetNumData(0);
    mover->Send({region});
  });
  RunToFrame(5);
  EXPECT_EQ(mover->readies, std::vector<int64_t>{2});
}

TEST_F(VirtualRobotCommTest, WaitDelaysTheStart) {
  Boot();
  As([&] {
    RCRegion* region = mover->NewVector(1);
    Mover::FillJoint(region, 0, mover->Open(kPan), {7});
    Mover::Data(region)->vectorInfo.wait = 3;
    mover->Send({region});
  });
  RunToFrame(3);
  EXPECT_EQ(Pan(), 0);
  RunToFrame(4);
  EXPECT_EQ(Pan(), 7);
}

TEST_F(VirtualRobotCommTest, ElementsThatWereNeverFilledAreReportedAndIgnored) {
  Boot();
  As([&] {
    RCRegion* region = mover->NewVector(2);
    Mover::FillJoint(region, 0, mover->Open(kPan), {7});
    mover->Send({region});
  });
  RunToFrame(3);
  EXPECT_EQ(Pan(), 7);
  ASSERT_EQ(system.findings().all().size(), 1u);
  EXPECT_NE(system.findings().all()[0].text.find("element 1 of 2 names primitive 0xffffffff"),
            std::string::npos);
}

TEST_F(VirtualRobotCommTest, TheQueueOfOneSubjectIsBounded) {
  Boot();
  As([&] {
    const OPrimitiveID pan = mover->Open(kPan);
    for (int event = 0; event < 3; ++event) {
      std::vector<RCRegion*> regions;
      for (int i = 0; i < 13; ++i) {
        regions.push_back(mover->NewVector(1));
        Mover::FillJoint(regions.back(), 0, pan, std::vector<int>(16, 1));
      }
      mover->Send(regions);
      mover->move->ReadyHandler(OReadyMessage{
          omsgREADY_V22, objcommCMD_ASSERT_READY, mover->move->begin()->GetObserverID(), 0, {}});
    }
  });
  system.RunFor(1);
  ASSERT_FALSE(system.findings().all().empty());
  EXPECT_NE(system.findings().all()[0].text.find("more than 32 command vectors"),
            std::string::npos);
}

// ---- synchronisation keys

TEST_F(VirtualRobotCommTest, VectorsWithPartsOfOneKeyStartTogether) {
  Mover* lights = system.AddObject<Mover>(dog, "lights", "Lights");
  system.Connect({dog, "Lights.Move.OCommandVectorData.S",
                  "OVirtualRobotComm.Effector.OCommandVectorData.O", "test"});
  Boot();
  OVRSyncKey first = ovrsynckeyUNDEF;
  OVRSyncKey second = ovrsynckeyUNDEF;
  As([&] {
    OVRSyncKey key = ovrsynckeyUNDEF;
    EXPECT_EQ(OPENR::NewSyncKey(&key), oSUCCESS);
    EXPECT_EQ(OPENR::DivideSyncKey(key, &first, &second), oSUCCESS);
    RCRegion* region = mover->NewVector(1);
    Mover::FillJoint(region, 0, mover->Open(kPan), {9});
    Mover::Data(region)->vectorInfo.syncKey = first;
    mover->Send({region});
  });
  RunToFrame(10);
  EXPECT_EQ(Pan(), 0);
  RunAs(lights, [&] {
    RCRegion* region = lights->NewVector(1);
    Mover::FillLed(region, 0, lights->Open(kEyeLed), oledON, 1);
    Mover::Data(region)->vectorInfo.syncKey = second;
    lights->Send({region});
  });
  RunToFrame(11);
  EXPECT_EQ(Pan(), 9);
  EXPECT_EQ(devices().leds[0].intensity, 1);
}

TEST_F(VirtualRobotCommTest, ThereAreEightKeysOfSixteenParts) {
  Boot();
  As([&] {
    OVRSyncKey key = 0;
    for (int i = 0; i < 8; ++i) EXPECT_EQ(OPENR::NewSyncKey(&key), oSUCCESS);
    OVRSyncKey ninth = 0;
    EXPECT_EQ(OPENR::NewSyncKey(&ninth), oNO_SYNC_KEY);
    EXPECT_EQ(ninth, ovrsynckeyUNDEF);
    OVRSyncKey a = 0;
    OVRSyncKey b = 0;
    for (int part = 1; part < 16; ++part) EXPECT_EQ(OPENR::DivideSyncKey(key, &a, &b), oSUCCESS);
    EXPECT_EQ(OPENR::DivideSyncKey(key, &a, &b), oFAIL);
    EXPECT_EQ(OPENR::CancelSyncKey(key), oSUCCESS);
    EXPECT_EQ(OPENR::CancelSyncKey(key), oINVALID_SYNC_KEY);
  });
}

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
