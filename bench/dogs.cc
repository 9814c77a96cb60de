#include "bench/dogs.h"

#include <stdexcept>

#include "runtime/core/system.h"
#include "virtualrobot/ode/ode_body.h"
#include "virtualrobot/ode/ode_reference.h"

namespace openr_host {

SimulationOptions OfDogs(const std::string& stick, const std::string& body, int robots) {
  SimulationOptions options;
  options.stick = stick;
  options.body = body;
  options.robots = robots;
  options.writable_stick = false;
  options.host_network = false;
  options.console = [](std::string_view) {};
  return options;
}

void StandUp(System* system) {
  system->Boot();
  const Object* const mover = system->FindObject(system->robot_count() - 1, "JointMover");
  if (mover == nullptr ||
      !system->RunUntil([&] { return mover->statistics().state() == "accepting-commands"; },
                        20'000'000))
    throw std::runtime_error("bench: the dogs do not stand up");
  system->RunFor(1'000'000);
}

Dogs::Dogs(const SimulationOptions& options) : simulation_(options) {
  StandUp(&simulation_.system());
}

void Dogs::Run(int64_t frames) { simulation_.system().RunFor(frames * kFrameUs); }

StandingDog::StandingDog(const std::string& stick) : simulation_(OfDogs(stick, "ode", 1)) {
  StandUp(&simulation_.system());
  VirtualRobot& robot = *simulation_.robots()[0];
  const BodyState& state = robot.body().state();
  X_WB_ = state.X_WB;
  for (const JointState& joint : state.joints) angles_rad_.push_back(joint.angle_rad);
  for (const JointDevice& joint : robot.devices().joints) {
    const GainWords& g = joint.gains;
    const PidGains gains{g[0], g[1], g[2], g[3], g[4], g[5]};
    commands_.push_back({joint.target_urad * 1e-6, true, gains});
  }
}

std::unique_ptr<OdeBody> StandingDog::MakeBody() const {
  RestingPose pose;
  pose.X_WB = X_WB_;
  pose.paws.resize(model().paws.size(), true);
  return std::make_unique<OdeBody>(model(), World(), pose, angles_rad_);
}

BareBodies::BareBodies(const std::string& stick, int count) : dog_(stick) {
  for (int i = 0; i < count; ++i) bodies_.push_back(dog_.MakeBody());
}

BareBodies::~BareBodies() = default;

void BareBodies::Run(int64_t frames) {
  for (; frames > 0; --frames) {
    for (const auto& body : bodies_) body->Advance(dog_.commands());
  }
}

OdeWorlds::OdeWorlds(const std::string& stick, int count) : dog_(stick) {
  for (int i = 0; i < count; ++i) {
    worlds_.push_back(
        std::make_unique<OdeReference>(dog_.model(), World(), dog_.X_WB(), dog_.angles_rad()));
  }
}

OdeWorlds::~OdeWorlds() = default;

void OdeWorlds::Run(int64_t frames) {
  for (; frames > 0; --frames) {
    for (const auto& world : worlds_) world->Advance(dog_.commands());
  }
}

}  // namespace openr_host
