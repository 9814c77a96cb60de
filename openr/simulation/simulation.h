// A simulation: robots with bodies and sticks in one System.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/config/address_config.h"
#include "runtime/core/load_stick.h"
#include "runtime/core/system.h"
#include "virtualrobot/model/robot_model.h"
#include "virtualrobot/virtual_robot.h"
#include "virtualrobot/world.h"

namespace openr_host {

class ConfiguredCost;
class IpStack;
class Network;

struct SimulationOptions {
  // Folder that holds OPEN-R/; "": the default stick, which must not be written to.  If objects may
  // write, this is the folder of a RunStick.
  std::string stick;
  std::string robot = "ers210";  // name of a model
  std::string world;             // a world file; "": a flat floor
  std::string body = "ode";      // "ode" or "ideal"
  int robots = 1;                // each has a world of its own; several share the stick, read-only
  uint64_t seed = 1;
  bool strict = false;
  // Files for the first robot.  "": its sound is discarded; it hears silence and sees the test
  // pattern.
  std::string speaker, microphone;  // WAV
  std::string images;               // folder of pictures for the camera
  std::string battery = "drain";    // of every robot; see ParseBattery()
  bool writable_stick = true;       // only with one robot
  bool measures = true;             // measures handler times and stacks for the report
  bool guard_regions = false;       // see SystemOptions
  std::string cost_file;            // see LoadCostFile()
  std::shared_ptr<CostModel> cost;  // used in place of cost_file; null: cost_file is used
  uint32_t log_level = 3;           // see SystemOptions
  bool host_network = true;         // false: a network in which the robots are alone
  // Port of the host for the first robot's remote control; 0: any free port; -1: the robot's own
  // port or, if that is taken, the next free one.
  int rc_port = -1;
  // Pairs of an address that programs have compiled in and the address on this host.  They come
  // before those of the stick's HOSTADDR.CFG.
  std::vector<AddressPair> addresses;
  std::function<void(std::string_view)> console;
  // Objects that are not images of the stick; see LoadStick().
  std::function<StandIns(System*, int robot)> stand_ins;
  // Replaces the network of a robot by one that is put between its IPStack and the given network.
  std::function<std::unique_ptr<Network>(int robot, std::unique_ptr<Network>)> network_filter;
};

// Returns the folder for the value `wanted` of SimulationOptions::stick.  Throws
// std::runtime_error.
std::string StickFolder(const std::string& wanted);

class Simulation {
 public:
  // Assembles everything up to System::Boot(), which the caller calls.  Faults of the stick are
  // findings, and `loaded()` returns false if the robot would not boot.  Throws std::runtime_error
  // when model, world or stick cannot be used at all.
  explicit Simulation(const SimulationOptions& options);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  System& system() { return *system_; }
  bool loaded() const { return loaded_; }
  const RobotModel& model() const { return model_; }
  const World& world() const { return world_; }
  const std::string& stick() const { return stick_; }
  const std::vector<VirtualRobot*>& robots() const { return robots_; }

  // At the end of the run, adds a warning that names the lines of the cost file that no handler
  // matched.
  void ReportUnusedCosts();

  // At the end of the run, completes the files that devices have written.  A file that cannot be
  // completed is an error finding.
  void CloseFiles();

  // Returns the port of the host for the remote control of `robot`; 0 while no object listens.
  uint16_t RcPort(int robot) const;

 private:
  void AddRobot(const SimulationOptions& options, int index);
  void NoteALowBattery(const std::string& text);
  std::vector<AddressPair> AddressesOf(const SimulationOptions& options, MemoryStick* stick,
                                       int index);

  const RobotModel model_;
  const World world_;
  const std::string stick_;
  const std::shared_ptr<ConfiguredCost> cost_;  // from the cost file; null: there is none
  std::unique_ptr<System> system_;
  std::vector<VirtualRobot*> robots_;
  std::vector<IpStack*> networks_;
  bool loaded_ = true;
};

}  // namespace openr_host
