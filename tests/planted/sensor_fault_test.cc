// A fault that shows when a sensor breaks: a program that trusts its sensor.
#include <OPENR/ODataFormats.h>
#include <gtest/gtest.h>

#include "openr/explore/fault_line.h"
#include "tests/planted/planted.h"
#include "virtualrobot/virtual_robot.h"

namespace openr_host::sensor_fault_test {
namespace {

// Fault: divides by the distance, which a broken sensor reads as 0.
class Nose : public Actor {
 public:
  Nose() {
    sensor_ =
        AddObserver("Nose.Sensor.OSensorFrameVectorData.O", [this](const ONotifyEvent& event) {
          auto* const vector = static_cast<const OSensorFrameVectorData*>(event.Data(0));
          constexpr int kDistance = 5;  // element of the ERS-210's sensor vectors
          if (const_cast<OSensorFrameVectorData*>(vector)->GetData(kDistance)->frame[0].value == 0)
            Say("divides by 0");
          sensor_->AssertReady();
        });
  }
  OStatus DoStart(const OSystemEvent&) override { return sensor_->AssertReady(); }

 private:
  OObserver* sensor_;
};

struct NosedDog {
  RobotModel model = LoadRobotModel(std::string(OPENR_MODEL_DIR) + "/ers210.json");
  System system;
};

PreparedRun NoseScene() {
  const auto dog = std::make_shared<NosedDog>();
  dog->system.AddRobot(dog->model.design, nullptr);
  PreparedRun prepared;
  prepared.robots.push_back(
      AddVirtualRobot(&dog->system, 0, dog->model, MakeIdealBody(dog->model, World())));
  dog->system.AddObject<Nose>(0, "nose");
  Wire(&dog->system, "OVirtualRobotComm.Sensor.OSensorFrameVectorData.S",
       "Nose.Sensor.OSensorFrameVectorData.O");
  prepared.system = &dog->system;
  prepared.owner = dog;
  return prepared;
}

TEST(PlantedSensorFaultTest, ABrokenSensorIsDrawnFromASeedAndShortenedToOneFault) {
  ExplorePlan plan = PlanOf(&NoseScene, {"always objects.nose.state != divides by 0"});
  EXPECT_EQ(InDefaultOrder(plan).property, "");
  EXPECT_EQ(InRandomOrders(plan).property, "");  // no seed breaks sensors unasked
  plan.run.vary.faults = 20;
  const Broken broken = InRandomOrders(plan);
  ASSERT_EQ(broken.deviations, 1u) << broken.failure.dump(1);
  EXPECT_EQ(broken.failure["deviations"][0]["kind"], "fault");
  EXPECT_THAT(broken.failure["deviations"][0]["line"].get<std::string>(),
              ::testing::StartsWith("break distance dead for "));
}

TEST(FaultLineTest, EveryFaultThatASeedCanDrawIsAnInputOfItsRobot) {
  for (const char* const name : {"/ers210.json", "/ers220.json", "/ers7.json"}) {
    const RobotModel model = LoadRobotModel(std::string(OPENR_MODEL_DIR) + name);
    System system;
    system.AddRobot(model.design, nullptr);
    AddVirtualRobot(&system, 0, model, MakeIdealBody(model, World()));
    for (int64_t number = 0; number < 500; ++number) {
      const std::string line = FaultLine(model, number);
      EXPECT_EQ(system.inputs().Check(0, line), "") << line;
    }
  }
}

}  // namespace
}  // namespace openr_host::sensor_fault_test
