#include "openr/simulation/simulation.h"

#include <fmt/format.h>
#include <sys/statvfs.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "cli/input_file.h"
#include "cli/install_paths.h"
#include "openr/decode/decode_message.h"
#include "openr/simulation/cost_file.h"
#include "openr/simulation/network_setup.h"
#include "openr/simulation/pacer.h"
#include "runtime/base/wall_clock.h"
#include "runtime/core/configured_cost.h"
#include "runtime/core/load_stick.h"
#include "runtime/core/system.h"
#include "runtime/gateway/tcp_gateway.h"
#include "runtime/ipstack/ip_stack.h"
#include "runtime/stick/memory_stick.h"
#include "virtualrobot/body/body.h"
#include "virtualrobot/power/battery.h"

namespace openr_host {
namespace {

World WorldOf(const std::string& name) {
  if (name.empty()) return {};
  const std::string file = DataFile(name);
  RequireReadable(file, kWorldFile);
  return LoadWorld(file);
}

std::shared_ptr<ConfiguredCost> CostOf(const SimulationOptions& options) {
  if (options.cost != nullptr) return nullptr;
  const auto config = LoadCostFile(options.cost_file);
  return config ? std::make_shared<ConfiguredCost>(*config, options.seed) : nullptr;
}

std::unique_ptr<System> MakeSystem(const SimulationOptions& options,
                                   std::shared_ptr<CostModel> cost) {
  SystemOptions system_options;
  system_options.seed = options.seed;
  system_options.strict = options.strict;
  system_options.find_leaks = options.find_leaks;
  system_options.console = options.console;
  system_options.log_level = options.log_level;
  system_options.say = &DecodeHandled;
  if (options.measures_handlers) system_options.wall_clock_ns = &WallClockNs;
  system_options.measure_stacks = options.measures_handlers;
  system_options.guard_regions = options.guard_regions;
  system_options.cost = cost == nullptr ? options.cost : std::move(cost);
  return std::make_unique<System>(std::move(system_options));
}

std::vector<std::string> SticksOf(const SimulationOptions& options) {
  std::vector<std::string> sticks = {StickFolder(options.stick)};
  for (const std::string& stick : options.more_sticks) sticks.push_back(StickFolder(stick));
  return sticks;
}

// Returns whether nothing can be written to `folder`, because its file system is mounted read-only.
bool IsOnReadOnlyDisk(const std::string& folder) {
  struct statvfs disk {};
  return statvfs(folder.c_str(), &disk) == 0 && (disk.f_flag & ST_RDONLY) != 0;
}

// Returns the world that robots share (--together); null if each robot has a world of its own.
std::shared_ptr<PhysicsWorld> SharedWorldOf(const SimulationOptions& options, const World& world) {
  if (!options.together) return nullptr;
  if (options.body != "ode")
    throw std::runtime_error("robots in one world need the body with physics; use --body ode");
  return MakePhysicsWorld(world);
}

// Returns the options of a robot's devices.  Only the first robot gets the files for sound and
// pictures, because `options` names one file or folder of each kind.
VirtualRobotOptions DevicesOf(const SimulationOptions& options, bool is_first) {
  VirtualRobotOptions devices = DevicesWithBattery(options.battery);
  if (is_first || !IsImageFolder(options.images)) devices.camera = OpenImages(options.images);
  if (!is_first) return devices;
  if (!options.speaker.empty()) devices.speaker = OpenSpeakerFile(options.speaker);
  if (!options.microphone.empty())
    devices.microphone = OpenMicrophoneFile(options.microphone, AfterEnd::kSilence);
  return devices;
}

}  // namespace

// Looks for the folder OPEN-R with Locate(), because Locate() does not distinguish upper and lower
// case, as on a robot's Memory Stick.  So a folder "open-r" is found, too.
bool HoldsOpenR(const std::filesystem::path& folder) {
  std::error_code error;
  const MemoryStick::Location root = FolderStick(folder).Locate("/MS/OPEN-R");
  return root.exists && std::filesystem::is_directory(root.path, error);
}

std::string StickNear(const std::filesystem::path& wanted) {
  namespace fs = std::filesystem;
  std::error_code error;
  std::vector<fs::path> near;
  for (const auto& entry : fs::directory_iterator(wanted, error)) {
    if (entry.is_directory(error) && HoldsOpenR(entry.path())) near.push_back(entry.path());
  }
  const fs::path around = fs::weakly_canonical(wanted, error).parent_path();
  if (near.empty() && !around.empty() && HoldsOpenR(around)) near.push_back(around);
  return near.size() == 1 ? fmt::format("; did you mean {}?", near[0].string()) : "";
}

std::string StickFolder(const std::string& wanted) {
  if (wanted.empty()) return DefaultStick();
  if (const std::string why = FolderReadProblem(wanted, kStickKind); !why.empty())
    throw std::runtime_error(fmt::format("{}: {}", wanted, why));
  if (HoldsOpenR(wanted)) return wanted;
  const MemoryStick::Location root = FolderStick(wanted).Locate("/MS/OPEN-R");
  if (root.error != 0 && root.error != ENOENT) {
    throw std::runtime_error(
        fmt::format("{}: cannot be read: {}", wanted, std::strerror(root.error)));
  }
  throw std::runtime_error(
      fmt::format("{}: holds no folder OPEN-R; a stick is a folder like the root of a Memory "
                  "Stick{}",
                  wanted, StickNear(wanted)));
}

Simulation::Simulation(const SimulationOptions& options)
    : model_(LoadRobotModel(ModelFile(options.robot))),
      world_(WorldOf(options.world)),
      physics_(SharedWorldOf(options, world_)),
      shared_frame_(options.together ? std::make_shared<SharedFrame>() : nullptr),
      sticks_(SticksOf(options)),
      cost_(CostOf(options)),
      system_(MakeSystem(options, cost_)) {
  for (int i = 0; i < options.robots; ++i) AddRobot(options, i);
}

Simulation::~Simulation() = default;

std::unique_ptr<Body> Simulation::BodyOf(const std::string& kind, int robot) const {
  if (physics_ != nullptr) return MakeOdeBody(model_, physics_, StartOf(world_, robot));
  std::unique_ptr<Body> body = MakeBody(kind, model_, world_);
  if (body == nullptr)
    throw std::runtime_error(fmt::format("no body '{}'; there are: ode, ideal", kind));
  return body;
}

void Simulation::AddRobot(const SimulationOptions& options, int index) {
  auto stick = std::make_shared<FolderStick>(StickOf(index));
  const bool wants_to_write = options.writable_stick && options.robots == 1;
  const bool is_protected = wants_to_write && IsOnReadOnlyDisk(StickOf(index));
  stick->set_writable(wants_to_write && !is_protected);
  RobotEquipment parts;
  parts.ip_stack.addresses = AddressesOf(options, stick.get(), index);
  parts.stick = std::move(stick);
  parts.body = BodyOf(options.body, index);
  parts.devices = DevicesOf(options, index == 0);
  parts.devices.shared_frame = shared_frame_;
  parts.make_network = [&options, index, addresses = parts.ip_stack.addresses](int robot) {
    auto network = options.host_network
                       ? MakeHostNetwork(index == 0 ? options.rc_port : -1, addresses)
                       : MakeIsolatedNetwork();
    return options.network_filter ? options.network_filter(robot, std::move(network))
                                  : std::move(network);
  };
  if (index == 0) NoteLowBattery(options.battery);
  const int robot =
      parts_.emplace_back(AssembleRobot(system_.get(), model_, std::move(parts))).number;
  robots_.push_back(parts_.back().virtual_robot);
  const StandIns stand_ins =
      options.stand_ins ? options.stand_ins(system_.get(), robot) : StandIns();
  if (is_protected) {
    system_->AddFindingAboutRobot(
        robot, Severity::kNote,
        fmt::format("{}: the disk is mounted read-only, so the stick is write-protected: no object "
                    "can write to it, and a crash leaves no EMON.LOG there; give a copy with "
                    "--stick if objects are to write",
                    StickOf(index)));
  }
  if (!Load(robot, stand_ins)) loaded_ = false;
  // Sets load_again, the function for a second boot of the robot, only if all objects run in this
  // process.  Other processes keep the state from the first boot, so their objects cannot be loaded
  // again.
  if (options.stand_ins) return;
  system_->robot(robot).load_again = [this, robot] {
    AddSystemObjectsAgain(system_.get(), &parts_.at(static_cast<size_t>(robot)));
    return Load(robot, {});
  };
}

// Loads the objects on the Memory Stick of the robot `robot`.  Returns false if the robot would not
// boot.
bool Simulation::Load(int robot, const StandIns& stand_ins) {
  return LoadStick(system_.get(), robot, stand_ins, {GatewayImage(system_.get(), robot)});
}

// Adds a note to the report if the battery is almost empty at boot.  Users expect that such a
// battery ends the run, but objects hear only of a battery that becomes low during the run.
void Simulation::NoteLowBattery(const std::string& text) {
  Battery battery;
  ParseBattery(text, &battery);
  if (!battery.is_low_at_boot()) return;
  system_->AddFindingAbout(
      nullptr, Severity::kNote,
      fmt::format("--battery {}: objects shut a robot down before its battery is below {} %; this "
                  "one boots with the bit for low capacity set, which is no change that an object "
                  "hears of, so the battery does not end the run; give {}% or more if it should",
                  text, kLowCapacityPercent, kLowCapacityPercent));
}

// Returns the pairs of addresses from the command line, and those from the stick's HOSTADDR.CFG.
// The pairs from the command line have precedence.
std::vector<AddressPair> Simulation::AddressesOf(const SimulationOptions& options,
                                                 MemoryStick* stick, int index) {
  const auto text = stick->ReadFile(std::string("/MS/OPEN-R/MW/CONF/") + kAddressFile);
  if (!text) return options.addresses;
  const AddressConfig config = ParseAddressConfig(kAddressFile, *text, model_.design);
  for (const Diagnostic& diagnostic : config.diagnostics) {
    // Reports errors in HOSTADDR.CFG, a file of the stick, only for the first robot that has this
    // stick.  The robots with an index of sticks_.size() or more share the stick of an earlier
    // robot.
    if (static_cast<size_t>(index) < sticks_.size())
      system_->AddFindingAbout(nullptr, diagnostic.severity, RenderWithoutKind(diagnostic));
  }
  return MergeAddressPairs(options.addresses, config.pairs);
}

void Simulation::ReportUnusedCosts() {
  if (cost_ == nullptr) return;
  constexpr size_t kNamed = 10;
  const std::vector<FilePosition> unused = cost_->Unused();
  std::string lines;
  for (size_t i = 0; i < std::min(unused.size(), kNamed); ++i)
    lines += fmt::format("{}{} ({})", i == 0 ? "" : ", ", unused[i].line, unused[i].text);
  if (unused.empty()) return;
  if (unused.size() > kNamed) lines += fmt::format(" and {} more", unused.size() - kNamed);
  system_->AddFindingAbout(nullptr, Severity::kWarning,
                           fmt::format("{}: no handler that ran is meant by line {}; openr trace "
                                       "shows how objects and entries are called",
                                       unused[0].file, lines));
}

void Simulation::CloseFiles() {
  for (VirtualRobot* const robot : robots_) {
    const std::string problem = robot->CloseFiles();
    if (!problem.empty())
      system_->AddFindingAbout(nullptr, Severity::kError, "Speaker: " + problem);
  }
}

uint16_t Simulation::RcPort(int robot) const {
  return HostPortOfRemoteControl(*parts_.at(static_cast<size_t>(robot)).ip_stack);
}

}  // namespace openr_host
