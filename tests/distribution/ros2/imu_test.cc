// The data on /imu while the dog moves, compared with the motion of its body.
#include <Eigen/Geometry>
#include <chrono>
#include <future>

#include "openr/ros2/joint_client.h"
#include "openr/ros2/robot_topics.h"
#include "openr/simulation/simulation.h"
#include "runtime/core/system.h"
#include "tests/distribution/ros2/ros2_run.h"

namespace openr_host {
namespace {

using Eigen::Vector3d;

constexpr int64_t kFrame_us = 8000;
constexpr double kTop_m_s2 = 19;  // the accelerometer measures up to 2 g

Vector3d AccelerationOf(const json& imu) {
  const json& values = imu["acceleration"];
  return Vector3d(values[0].get<double>(), values[1].get<double>(), values[2].get<double>());
}

class Ros2ImuTest : public testing::Test {
 protected:
  Ros2ImuTest() : domain_(NewDomain()), peer_(domain_), bus_(OptionsOf(domain_)) {
    SimulationOptions options;
    options.host_network = false;
    options.console = [](std::string_view) {};
    options.network_filter = [this](int, std::unique_ptr<Network> inner) {
      auto client = std::make_unique<JointClient>(std::move(inner), [](const std::string&) {});
      client_ = client.get();
      return client;
    };
    simulation_ = std::make_unique<Simulation>(options);
    system().Boot();
    system().RunUntil(15'000'000);  // the dog stands by then
    topics_ = std::make_unique<RobotTopics>(&bus_, "aibo", simulation_->robots()[0]);
  }
  static BusOptions OptionsOf(const std::string& domain) {
    BusOptions options;
    options.run = "imu";
    options.domain = std::stoi(domain);
    return options;
  }
  System& system() { return simulation_->system(); }
  const BodyState& body() const { return simulation_->robots()[0]->body().state(); }

  // Bent knees: of one side, of the other side, of the fore legs, of the hind legs.
  void Rock(int64_t turn) {
    constexpr const char* kBent[][2] = {
        {"LF_j3", "LH_j3"}, {"RF_j3", "RH_j3"}, {"LF_j3", "RF_j3"}, {"LH_j3", "RH_j3"}};
    const RobotModel& model = simulation_->model();
    std::map<int, JointTarget> targets;
    for (const char* const leg : {"LF_j3", "LH_j3", "RF_j3", "RH_j3"})
      targets[model.FindJoint(leg)] = {0.3, 0};
    for (const char* const leg : kBent[turn % 4]) targets[model.FindJoint(leg)] = {1.2, 0};
    client_->SetTargets(targets);
  }

  // Runs one frame and keeps what an accelerometer in the body measures: the change of its velocity
  // and the force against gravity.
  void Step() {
    const Vector3d before_W = body().v_WB;
    system().RunUntil(system().now_us() + kFrame_us);
    const Vector3d pull_W = (body().v_WB - before_W) / kFrame_s + Vector3d(0, 0, kGravity_m_s2);
    felt_[system().now_us()] = body().X_WB.linear().transpose() * pull_W;
    EXPECT_EQ(topics_->Publish(system().now_us()), "");
  }

  const std::string domain_;
  const Ros2Peer peer_;
  Bus bus_;
  JointClient* client_ = nullptr;
  std::unique_ptr<Simulation> simulation_;
  std::unique_ptr<RobotTopics> topics_;
  std::map<int64_t, Vector3d> felt_;
};

TEST_F(Ros2ImuTest, ARockingDogFeelsWhatItsBodyDoes) {
  constexpr int kTurnFrames = 30;
  auto reading = std::async(std::launch::async,
                            [this] { return peer_.Read("sensor_msgs/Imu", "rt/aibo/imu", 400); });
  for (int64_t frame = 0; reading.wait_for(std::chrono::seconds(0)) != std::future_status::ready;
       ++frame) {
    if (frame % kTurnFrames == 0) Rock(frame / kTurnFrames);
    Step();
    usleep(1000);  // slow enough for a reader to receive every sample
  }
  Vector3d least = Vector3d::Constant(100), most = -least;
  for (const json& sample : reading.get()) {
    const Vector3d said = AccelerationOf(sample);
    const int64_t stamp_us = sample["stamp_us"];
    ASSERT_TRUE(felt_.contains(stamp_us));
    const Vector3d felt = felt_[stamp_us].cwiseMin(kTop_m_s2).cwiseMax(-kTop_m_s2);
    EXPECT_LT((said.cwiseMin(kTop_m_s2).cwiseMax(-kTop_m_s2) - felt).norm(), 0.05)
        << stamp_us << ": " << said.transpose() << " and " << felt.transpose();
    least = least.cwiseMin(said);
    most = most.cwiseMax(said);
  }
  const Vector3d range = most - least;
  EXPECT_GT(range.minCoeff(), 0.1) << "it moves: " << range.transpose();
}

// The lower side measures a part of gravity: x is forward, y left.
TEST_F(Ros2ImuTest, ADogThatLeansTellsToWhichSide) {
  struct Lean {
    int axis;
    double sign;
  };
  const Lean leans[] = {{1, -1}, {1, 1}, {0, -1}, {0, 1}};
  Vector3d level;
  for (int turn = -1; turn < 4; ++turn) {
    SCOPED_TRACE(turn);
    if (turn >= 0) Rock(turn);
    for (int i = 0; i < 250; ++i) Step();
    auto reading = std::async(std::launch::async,
                              [this] { return peer_.ReadOne("sensor_msgs/Imu", "rt/aibo/imu"); });
    while (reading.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
      Step();
      usleep(1000);
    }
    const Vector3d felt = AccelerationOf(reading.get());
    if (turn < 0) {
      level = felt;
      continue;
    }
    const Vector3d change = felt - level;
    const auto [axis, sign] = leans[turn];
    EXPECT_GT(sign * change[axis], 0.5) << change.transpose();
    EXPECT_LT(std::abs(change[1 - axis]), 0.5 * std::abs(change[axis])) << change.transpose();
  }
}

}  // namespace
}  // namespace openr_host
