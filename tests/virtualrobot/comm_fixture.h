// A robot on a body that follows exactly, with one object that moves it and one that
// watches its sensors.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>

#include "runtime/core/system.h"
#include "tests/runtime/core/probe.h"
#include "tests/virtualrobot/follow_body.h"
#include "virtualrobot/virtual_robot.h"

namespace openr_host {
inline constexpr char kPan[] = "PRM:/r1/c1/c2-Joint2:j2";
inline constexpr char kEyeLed[] = "PRM:/r1/c1/c2/c3/l1-LED2:l1";
inline constexpr char kTilt[] = "PRM:/r1/c1-Joint2:j1";
inline constexpr char kSpeaker[] = "PRM:/r1/c1/c2/c3/s1-Speaker:S1";
inline constexpr char kMic[] = "PRM:/r1/c1/c2/c3/m1-Mic:M1";
inline constexpr char kCamera[] = "PRM:/r1/c1/c2/c3/i1-FbkImageSensor:F1";
inline constexpr char kEar[] = "PRM:/r1/c1/c2/c3/e1-Joint3:j5";

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
  explicit VirtualRobotCommTest(VirtualRobotOptions options = {}, const char* name = "ers210",
                                SystemOptions system_options = {})
      : model(LoadRobotModel(std::string(OPENR_MODEL_DIR) + "/" + name + ".json")),
        system(std::move(system_options)) {
    dog = system.AddRobot(model.design, nullptr);
    auto made = std::make_unique<FollowBody>(model);
    body = made.get();
    robot = AddVirtualRobot(&system, dog, model, std::move(made), std::move(options));
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
  double& Angle(const char* locator) {
    return body->mutable_state()
        .joints[static_cast<size_t>(model.FindJointByLocator(locator))]
        .angle_rad;
  }
  // Findings whose text contains `part`.
  int CountFindings(const std::string& part) const {
    int count = 0;
    for (const Finding& finding : system.findings().all())
      count += finding.text.find(part) != std::string::npos;
    return count;
  }
  // All of them, for messages of tests.
  std::string Findings() const {
    std::string text;
    for (const Finding& finding : system.findings().all())
      text += finding.object + ": " + finding.text + "\n";
    return text;
  }

  RobotModel model;
  System system;
  int dog = 0;
  FollowBody* body;
  VirtualRobot* robot;
  Mover* mover;
  Watcher* watcher;
};

}  // namespace openr_host
