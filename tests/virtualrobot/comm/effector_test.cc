// The Effector service and synchronisation keys: robot.md sections 7.4, 9 and 10.
#include <gtest/gtest.h>

#include "tests/virtualrobot/comm_fixture.h"

namespace openr_host {
namespace {

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
  EXPECT_EQ(Pan(), 41);  // a new set point in each frame, none left out
}

// field-notes.md, 7.6: readies after 8, 32, 8, 32 ms.
TEST_F(VirtualRobotCommTest, ABufferOfOneFrameAmongTwoBreaksTheRhythm) {
  Boot();
  mover->readies.clear();
  std::vector<RCRegion*> buffers;
  OPrimitiveID pan = 0;
  int value = 0;
  const auto fill = [&](RCRegion* region) {
    std::vector<int> values(region == buffers[0] ? 1u : 4u);
    for (int& each : values) each = ++value;
    Mover::FillJoint(region, 0, pan, values);
  };
  As([&] {
    pan = mover->Open(kPan);
    buffers = {mover->NewVector(1), mover->NewVector(1)};
    for (RCRegion* region : buffers) fill(region);
    mover->Send(buffers);
  });
  mover->on_ready = [&] {
    for (RCRegion* region : buffers) {
      if (region->NumberOfReference() != 1) continue;
      fill(region);
      mover->Send({region});
      return;
    }
    ADD_FAILURE() << "no free region";
  };
  RunToFrame(22);
  EXPECT_EQ(mover->readies, (std::vector<int64_t>{2, 6, 7, 11, 12, 16, 17, 21, 22}));
  EXPECT_EQ(Pan(), 22);  // the joint notices nothing: one new set point per frame
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
      OReadyMessage ready;
      ready.command = objcommCMD_ASSERT_READY;
      ready.observerID = mover->move->begin()->GetObserverID();
      mover->move->ReadyHandler(ready);
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

}  // namespace
}  // namespace openr_host
