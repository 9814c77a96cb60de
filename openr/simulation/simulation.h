// A run put together: robots with bodies and sticks in one System.
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
  // Folder that holds OPEN-R/; "": the default stick.  That is never to be written: a run whose
  // objects may write names the folder of its RunStick.
  std::string stick;
  std::string robot = "ers210";  // name of a model
  std::string world;             // a world file; "": a flat floor
  std::string body = "ode";      // "ode" or "ideal"
  int robots = 1;                // each with a world of its own; several share the stick, read-only
  uint64_t seed = 1;
  bool strict = false;
  // Files for the first robot; "": its sound goes nowhere, it hears silence and sees the test
  // pattern.
  std::string speaker, microphone;  // WAV
  std::string images;               // a folder of pictures for its camera
  std::string battery = "drain";    // of every robot; see ParseBattery()
  bool writable_stick = true;       // with one robot
  bool measures = true;             // handler times and stacks, for the report
  bool guard_regions = false;       // see SystemOptions
  std::string cost_file;            // see LoadCostFile()
  std::shared_ptr<CostModel> cost;  // instead; null: what cost_file says
  uint32_t log_level = 3;           // see SystemOptions
  bool host_network = true;         // false: a network without anybody else in it
  // Port of the host for the first robot's remote control; 0: any free one, -1: the robot's own
  // if it is free, else the next free one.
  int rc_port = -1;
  // Addresses that programs have compiled in, and where they are on this host; before those of the
  // stick's HOSTADDR.CFG.
  std::vector<AddressPair> addresses;
  std::function<void(std::string_view)> console;
  // Objects that are not images of the stick; see LoadStick().
  std::function<StandIns(System*, int robot)> stand_ins;
  // Puts something between a robot's IPStack and its network.
  std::function<std::unique_ptr<Network>(int robot, std::unique_ptr<Network>)> network_filter;
};

// The folder of the stick that is meant by SimulationOptions::stick.  Throws std::runtime_error.
std::string StickFolder(const std::string& wanted);

class Simulation {
 public:
  // Builds everything up to Boot(), which is left to the caller.  What is wrong on the stick is
  // a finding; `loaded()` is then false if the robot would not boot.  Throws std::runtime_error
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

  // At the end of the run: a warning that names the lines of the cost file that no handler fitted.
  void ReportUnusedCosts();

  // At the end of the run: files that devices wrote are complete; one that is not is an error
  // finding.
  void CloseFiles();

  // Port of the host where the remote control of `robot` is found; 0 while nobody listens.
  uint16_t RcPort(int robot) const;

 private:
  void AddRobot(const SimulationOptions& options, int index);
  void NoteALowBattery(const std::string& text);
  std::vector<AddressPair> AddressesOf(const SimulationOptions& options, MemoryStick* stick,
                                       int index);

  const RobotModel model_;
  const World world_;
  const std::string stick_;
  const std::shared_ptr<ConfiguredCost> cost_;  // of the cost file; null: there is none
  std::unique_ptr<System> system_;
  std::vector<VirtualRobot*> robots_;
  std::vector<IpStack*> networks_;
  bool loaded_ = true;
};

}  // namespace openr_host
