// Simulation: a System, which has the clock and the messages, with its robots, their simulated
// bodies and their Memory Sticks.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "openr/simulation/assemble_robot.h"
#include "runtime/config/address_config.h"
#include "runtime/core/load_stick.h"
#include "virtualrobot/model/robot_model.h"
#include "virtualrobot/virtual_robot.h"
#include "virtualrobot/worlds/world.h"

namespace openr_host {

class ConfiguredCost;
class CostModel;
class Network;
class PhysicsWorld;
class SharedFrame;
class System;

struct SimulationOptions {
  // The folder of the Memory Stick, in which OPEN-R/ lies.  "" is the default stick, which came
  // with openr and must not change.  So if objects may write, set this field to RunStick::folder(),
  // which is a copy of the default stick or the user's own stick.
  std::string stick;
  // The folders of further sticks.  The sticks are given to the robots in turn: robot 0 gets
  // `stick`, robot 1 gets the first further stick, and so on.  The robot after the last further
  // stick gets `stick` again.
  std::vector<std::string> more_sticks;
  std::string robot = "ers210";  // name of the robot model
  std::string world;             // the world file; "": a flat floor
  std::string body = "ode";      // kind of the robots' bodies: "ode" (with physics) or "ideal"
  int robots = 1;                // number of robots; several robots can only read their sticks
  // True: all robots are in one world; allowed only if `body` is "ode".
  bool together = false;
  uint64_t seed = 1;
  bool strict = false;
  bool find_leaks = false;  // value of --leaks; see SystemOptions::find_leaks
  // Sound files (WAV) for the first robot.  Without `speaker` its sound is discarded; without
  // `microphone` it hears silence.
  std::string speaker, microphone;  // paths of WAV files; "": none
  // The pictures that the cameras see, a value of --images; see OpenImages().  Only the first robot
  // sees the pictures of a folder; the other robots see their world.
  std::string images = kImagesOfWorld;
  std::string battery = "drain";  // battery of each robot; see ParseBattery()
  // True: objects may write to the stick.  Has no effect if there are several robots, because their
  // objects must never write to the sticks.
  bool writable_stick = true;
  bool measures_handlers = true;    // true: measures handler times and stack use for the report
  bool guard_regions = false;       // see SystemOptions::guard_regions
  std::string cost_file;            // name of a cost file; see LoadCostFile()
  std::shared_ptr<CostModel> cost;  // costs to use instead of cost_file; null: cost_file is used
  uint32_t log_level = 3;           // see SystemOptions::log_level
  bool host_network = true;         // false: the robots cannot reach other programs
  // The port of this computer for the first robot's remote control; 0: any free port; -1: the
  // robot's own port or, if that is taken, the next free port.
  int rc_port = -1;
  // Each pair names an address that the robots' programs use and the address that this computer
  // uses in its place.  These pairs have precedence over those in HOSTADDR.CFG of the stick.
  std::vector<AddressPair> addresses;
  std::function<void(std::string_view)> console;
  // A function that returns the StandIns of a robot: functions that LoadStick() calls for objects
  // in other processes, instead of loading their images (load_stick.h).  Only a distributed run
  // sets this field.
  std::function<StandIns(System*, int robot)> stand_ins;
  // A function that is called for each robot, with the robot's number and network.  It returns a
  // network that the robot uses instead; this network usually passes calls to the given network.
  // Recording, replay and ROS 2 use such a function.
  std::function<std::unique_ptr<Network>(int robot, std::unique_ptr<Network>)> network_filter;
};

// Returns whether the folder has the folder OPEN-R of a stick.
bool HoldsOpenR(const std::filesystem::path& folder);

// Returns "; did you mean FOLDER?" for the end of a message about `wanted`, a folder that is no
// stick.  FOLDER is the only stick directly in `wanted`, or the stick that has `wanted` as its
// OPEN-R.  Returns "" if there is none.
std::string StickNear(const std::filesystem::path& wanted);

// Returns the folder of the default stick if `wanted` (SimulationOptions::stick) is "", otherwise
// `wanted`.  Throws std::runtime_error if `wanted` holds no folder OPEN-R or cannot be read.
std::string StickFolder(const std::string& wanted);

class Simulation {
 public:
  // Makes a simulation that is ready for System::Boot().  Errors on the stick become findings of
  // the run; if the robot would not boot, loaded() returns false.  Throws std::runtime_error when
  // the model, the world or the stick cannot be used at all.
  explicit Simulation(const SimulationOptions& options);
  ~Simulation();
  Simulation(const Simulation&) = delete;
  Simulation& operator=(const Simulation&) = delete;

  System& system() { return *system_; }
  bool loaded() const { return loaded_; }
  const RobotModel& model() const { return model_; }
  const World& world() const { return world_; }
  // Returns whether all robots are in one world.
  bool is_together() const { return physics_ != nullptr; }
  const std::string& stick() const { return sticks_.front(); }
  // Returns the folder of the stick of robot `robot`.
  const std::string& StickOf(int robot) const {
    return sticks_[static_cast<size_t>(robot) % sticks_.size()];
  }
  const std::vector<VirtualRobot*>& robots() const { return robots_; }

  // Adds a warning that names the lines of the cost file that no handler of the run has matched.
  // Called at the end of the run.
  void ReportUnusedCosts();

  // Completes the files that devices have written, such as the WAV file of the speaker, at the end
  // of the run.  A file that cannot be completed becomes an error finding.
  void CloseFiles();

  // Returns the port of this computer on which the remote control of the robot number `robot`
  // listens; 0 while no object listens.
  uint16_t RcPort(int robot) const;

 private:
  void AddRobot(const SimulationOptions& options, int index);
  std::unique_ptr<Body> BodyOf(const std::string& kind, int robot) const;
  bool Load(int robot, const StandIns& stand_ins);
  void NoteLowBattery(const std::string& text);
  std::vector<AddressPair> AddressesOf(const SimulationOptions& options, MemoryStick* stick,
                                       int index);

  const RobotModel model_;
  const World world_;
  // The simulated world that all robots share; null if each robot has a world of its own.
  const std::shared_ptr<PhysicsWorld> physics_;
  // Ends each frame of 8 ms for all robots of the shared world together, because the robots push
  // each other; null if each robot has a world of its own.
  const std::shared_ptr<SharedFrame> shared_frame_;
  const std::vector<std::string> sticks_;
  // Processor times of handlers from the cost file; null: there is no cost file.
  const std::shared_ptr<ConfiguredCost> cost_;
  std::unique_ptr<System> system_;
  std::vector<VirtualRobot*> robots_;
  std::vector<AssembledRobot> parts_;  // parts of each robot; the index is the number of the robot
  bool loaded_ = true;
};

}  // namespace openr_host
