// A fault that shows after 24 days: the number of the robot's frames begins anew.
#include <OPENR/ODataFormats.h>
#include <gtest/gtest.h>

#include "tests/planted/planted.h"
#include "virtualrobot/virtual_robot.h"

namespace openr_host::frame_test {
namespace {

// Fault: a vector is old unless its number is greater than that of the last one.
class Counter : public Actor {
 public:
  Counter() {
    sensor_ =
        AddObserver("Counter.Sensor.OSensorFrameVectorData.O", [this](const ONotifyEvent& event) {
          auto* const vector = static_cast<const OSensorFrameVectorData*>(event.Data(0));
          const longword number =
              const_cast<OSensorFrameVectorData*>(vector)->GetInfo(0)->frameNumber;
          if (number > last_) {
            Say("counting");
          } else if (has_last_) {
            Say("ignores old values");
          }
          last_ = number;
          has_last_ = true;
          sensor_->AssertReady();
        });
  }
  OStatus DoStart(const OSystemEvent&) override { return sensor_->AssertReady(); }

 private:
  OObserver* sensor_;
  longword last_ = 0;
  bool has_last_ = false;
};

struct Dog {
  RobotModel model = LoadRobotModel(std::string(OPENR_MODEL_DIR) + "/ers210.json");
  System system;
};

PreparedRun CountingScene() {
  const auto dog = std::make_shared<Dog>();
  dog->system.AddRobot(dog->model.design, nullptr);
  PreparedRun prepared;
  prepared.robots.push_back(
      AddVirtualRobot(&dog->system, 0, dog->model, MakeIdealBody(dog->model, World())));
  dog->system.AddObject<Counter>(0, "counter");
  Wire(&dog->system, "OVirtualRobotComm.Sensor.OSensorFrameVectorData.S",
       "Counter.Sensor.OSensorFrameVectorData.O");
  prepared.system = &dog->system;
  prepared.owner = dog;
  return prepared;
}

TEST(PlantedFrameTest, TheWrapOfTheFrameCounterIsMissedByDefaultAndFoundByExploring) {
  ExplorePlan plan = PlanOf(&CountingScene, {"always objects.counter.state != ignores old values"});
  EXPECT_EQ(InDefaultOrder(plan).property, "");
  const Broken broken = InRandomOrders(plan);
  ASSERT_EQ(broken.deviations, 1u) << broken.failure.dump(1);
  EXPECT_EQ(broken.failure["deviations"][0]["kind"], "frame");
  plan.run.vary.frames = false;
  EXPECT_EQ(InRandomOrders(plan).property, "");
}

}  // namespace
}  // namespace openr_host::frame_test
