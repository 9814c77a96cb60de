#include "openr/simulation.h"

#include <fmt/format.h>

#include <filesystem>
#include <stdexcept>
#include <utility>

#include "openr/install_paths.h"
#include "openr/network_setup.h"
#include "openr/pacing.h"
#include "runtime/stick/memory_stick.h"
#include "virtualrobot/body.h"

namespace openr_host {
namespace {

std::string StickFolder(const std::string& wanted) {
  if (wanted.empty()) return DefaultStick();
  std::error_code error;
  if (std::filesystem::is_directory(wanted + "/OPEN-R", error)) return wanted;
  throw std::runtime_error(
      fmt::format("{}: holds no folder OPEN-R; a stick is a folder like the root of a Memory "
                  "Stick",
                  wanted));
}

std::unique_ptr<System> MakeSystem(const SimulationOptions& options) {
  SystemOptions system_options;
  system_options.seed = options.seed;
  system_options.strict = options.strict;
  system_options.console = options.console;
  system_options.log_level = options.log_level;
  system_options.wall_clock_ns = &WallClockNs;
  return std::make_unique<System>(std::move(system_options));
}

std::unique_ptr<Body> MakeBody(const std::string& kind, const RobotModel& model,
                               const World& world) {
  if (kind == "ode") return MakeOdeBody(model, world);
  if (kind == "ideal") return MakeIdealBody(model, world);
  throw std::runtime_error(fmt::format("no body '{}'; there are: ode, ideal", kind));
}

}  // namespace

Simulation::Simulation(const SimulationOptions& options)
    : model_(LoadRobotModel(ModelFile(options.robot))),
      world_(options.world.empty() ? World() : LoadWorld(options.world)),
      stick_(StickFolder(options.stick)),
      system_(MakeSystem(options)) {
  for (int i = 0; i < options.robots; ++i) AddRobot(options, i);
}

Simulation::~Simulation() = default;

void Simulation::AddRobot(const SimulationOptions& options, int index) {
  auto stick = std::make_shared<FolderStick>(stick_);
  stick->set_writable(options.robots == 1);
  const int robot = system_->AddRobot(model_.design, std::move(stick));
  robots_.push_back(
      AddVirtualRobot(system_.get(), robot, model_, MakeBody(options.body, model_, world_)));
  networks_.push_back(options.host_network
                          ? AddHostNetwork(system_.get(), robot, index == 0 ? options.rc_port : -1)
                          : AddLonelyNetwork(system_.get(), robot));
  if (!system_->LoadStick(robot)) loaded_ = false;
}

uint16_t Simulation::RcPort(int robot) const {
  return HostPortOfRemoteControl(*networks_.at(static_cast<size_t>(robot)));
}

}  // namespace openr_host
