// Synchronisation keys, wait and optional bytes: robot.md 3 and 7.4.
#include <gtest/gtest.h>

#include "tests/virtualrobot/comm_fixture.h"

namespace openr_host {
namespace {

class SyncTest : public VirtualRobotCommTest {
 protected:
  SyncTest() {
    lights = system.AddObject<Mover>(dog, "lights", "Lights");
    system.Connect({dog, "Lights.Move.OCommandVectorData.S",
                    "OVirtualRobotComm.Effector.OCommandVectorData.O", "test"});
  }
  void SetUp() override {
    Boot();
    As([&] {
      pan = mover->Open(kPan);
      eye = mover->Open(kEyeLed);
    });
  }
  // A key in two parts.
  void Divide() {
    As([&] {
      EXPECT_EQ(OPENR::NewSyncKey(&key), oSUCCESS);
      EXPECT_EQ(OPENR::DivideSyncKey(key, &first, &second), oSUCCESS);
    });
  }
  RCRegion* Pan1(Mover* who, int value, OVRSyncKey part) {
    RCRegion* const region = who->NewVector(1);
    Mover::FillJoint(region, 0, pan, {value});
    Mover::Data(region)->vectorInfo.syncKey = part;
    return region;
  }
  RCRegion* Eye(Mover* who, OVRSyncKey part) {
    RCRegion* const region = who->NewVector(1);
    Mover::FillLed(region, 0, eye, oledON, 1);
    Mover::Data(region)->vectorInfo.syncKey = part;
    return region;
  }
  Mover* lights;
  OPrimitiveID pan = 0, eye = 0;
  OVRSyncKey key = 0, first = 0, second = 0;
};

TEST_F(SyncTest, SeveralElementsOfSeveralVectorsBeginInOneFrame) {
  Divide();
  As([&] {
    RCRegion* const region = mover->NewVector(2);
    Mover::FillJoint(region, 0, pan, {9});
    Mover::FillJoint(region, 1, mover->Open(kTilt), {8});
    Mover::Data(region)->vectorInfo.syncKey = first;
    mover->Send({region});
  });
  RunToFrame(5);
  RunAs(lights, [&] { lights->Send({Eye(lights, second)}); });
  system.RunFor(kFrameUs - 1);
  EXPECT_EQ(Pan(), 0);
  EXPECT_EQ(devices().leds[0].intensity, 0);
  RunToFrame(6);
  EXPECT_EQ(Pan(), 9);
  EXPECT_EQ(devices().joints[0].target_urad, 8);
  EXPECT_EQ(devices().leds[0].intensity, 1);
}

// A part can be divided again.  But of two parts in one queue the second never becomes the first
// that waits, so the vectors wait for ever.
TEST_F(SyncTest, TwoPartsInOneQueueHoldEachOtherUp) {
  Divide();
  OVRSyncKey third = 0;
  As([&] {
    OVRSyncKey part = 0;
    EXPECT_EQ(OPENR::DivideSyncKey(second, &part, &third), oSUCCESS);
    second = part;
    mover->Send({Pan1(mover, 5, first)});
  });
  RunAs(lights, [&] { lights->Send({Eye(lights, second), Eye(lights, third)}); });
  RunToFrame(20);
  EXPECT_EQ(Pan(), 0);
}

TEST_F(SyncTest, AVectorBehindOneThatWaitsWaitsAsWell) {
  Divide();
  As([&] { mover->Send({Pan1(mover, 5, first), Pan1(mover, 6, ovrsynckeyUNDEF)}); });
  RunToFrame(10);
  EXPECT_EQ(Pan(), 0);
}

TEST_F(SyncTest, APartThatNeverComesIsReportedAfterTenSeconds) {
  Divide();
  As([&] { mover->Send({Pan1(mover, 5, first)}); });
  RunToFrame(1240);
  EXPECT_EQ(Findings(), "");
  RunToFrame(1260);
  EXPECT_EQ(Findings(),
            "mover: a vector has waited 10 s for the other parts of its synchronisation key: 1 of "
            "2 parts have come; send them, or CancelSyncKey()\n");
}

TEST_F(SyncTest, CancellingAKeyLetsItsVectorsGo) {
  Divide();
  As([&] { mover->Send({Pan1(mover, 5, first)}); });
  RunToFrame(10);
  As([&] { EXPECT_EQ(OPENR::CancelSyncKey(key), oSUCCESS); });
  RunToFrame(11);
  EXPECT_EQ(Pan(), 5);
}

TEST_F(SyncTest, AKeyThatDoesNotExistHoldsNothingUp) {
  As([&] { mover->Send({Pan1(mover, 5, 12345)}); });
  RunToFrame(1);
  EXPECT_EQ(Pan(), 5);
  As([&] {
    EXPECT_EQ(OPENR::CancelSyncKey(12345), oINVALID_SYNC_KEY);
    OVRSyncKey a = 0, b = 0;
    EXPECT_EQ(OPENR::DivideSyncKey(12345, &a, &b), oFAIL);
    EXPECT_EQ(a, ovrsynckeyUNDEF);
    EXPECT_EQ(b, ovrsynckeyUNDEF);
  });
}

// The frames of a wait of a vector with a key begin when all parts are there.  That is our choice,
// because no source says when they begin.
TEST_F(SyncTest, AWaitCountsFromTheCommonStart) {
  Divide();
  As([&] {
    RCRegion* const region = Pan1(mover, 5, first);
    Mover::Data(region)->vectorInfo.wait = 4;
    mover->Send({region});
  });
  RunToFrame(10);
  RunAs(lights, [&] { lights->Send({Eye(lights, second)}); });
  RunToFrame(14);
  EXPECT_EQ(Pan(), 0);
  EXPECT_EQ(devices().leds[0].intensity, 1);
  RunToFrame(15);
  EXPECT_EQ(Pan(), 5);
}

// ---- optional bytes

class OptionalTest : public VirtualRobotCommTest {
 protected:
  void SetUp() override {
    watcher->on_vector = [this](const ONotifyEvent& event) {
      header = static_cast<const OSensorFrameVectorData*>(event.Data(0))->vectorInfo;
    };
    Boot();
  }
  void Send(longword offset, longword size, longword wait = 0) {
    As([&] {
      RCRegion* const region = mover->NewVector(1);
      Mover::FillJoint(region, 0, mover->Open(kPan), {1, 1});
      ODataVectorInfo& info = Mover::Data(region)->vectorInfo;
      info.optOffset = offset;
      info.optSize = size;
      info.wait = wait;
      for (size_t i = 0; i < sizeof info.optional; ++i) info.optional[i] = static_cast<byte>(i + 1);
      mover->Send({region});
    });
  }
  ODataVectorInfo header{};
};

TEST_F(OptionalTest, TheMarkedBytesOfACommandStandInTheSensorVectorsThatFollow) {
  RunToFrame(4);
  EXPECT_EQ(header.optSize, 0u);
  Send(10, 3);
  RunToFrame(8);
  EXPECT_EQ(header.optOffset, 10u);
  EXPECT_EQ(header.optSize, 3u);
  EXPECT_EQ(header.optional[9], 0);
  EXPECT_EQ(header.optional[10], 11);
  EXPECT_EQ(header.optional[12], 13);
  EXPECT_EQ(header.optional[13], 0);
  RunToFrame(40);
  EXPECT_EQ(header.optional[10], 11);
}

TEST_F(OptionalTest, ARangeThatDoesNotFitIsReported) {
  Send(120, 9);
  RunToFrame(8);
  EXPECT_EQ(header.optSize, 0u);
  EXPECT_EQ(CountFindings("9 optional bytes at 120 do not fit into 128"), 1);
}

// ---- streams

TEST_F(OptionalTest, NothingIsQueuedForAnObserverThatDeassertedItsReady) {
  watcher->assert_ready = false;
  RunToFrame(4);
  RunAs(watcher, [&] { watcher->sensor->DeassertReady(); });
  RunToFrame(21);
  EXPECT_EQ(watcher->frames, std::vector<longword>{0});
  RunAs(watcher, [&] { watcher->sensor->AssertReady(); });
  system.RunFor(1);
  EXPECT_EQ(watcher->frames, std::vector<longword>{0});
  RunToFrame(24);
  EXPECT_EQ(watcher->frames, (std::vector<longword>{0, 20}));
}

}  // namespace
}  // namespace openr_host
