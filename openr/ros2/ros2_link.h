// A run seen by ROS 2: its clock and robots as topics, commands for their joints back.
//
// It looks and never touches: what it tells changes nothing in the run.  Commands enter as a client
// of the remote control does, see joint_client.h.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "distribution/bus.h"
#include "distribution/ros2/topics.h"
#include "openr/ros2/joint_client.h"
#include "openr/ros2/robot_topics.h"
#include "openr/simulation/simulation.h"

namespace openr_host {

// "" or what is wrong with a name of a namespace: words with slashes between.
std::string WrongNamespace(const std::string& name);

// What people are told about one robot: each text once, and not more than they would read.
class Ros2Complaints {
 public:
  using Say = std::function<void(const std::string& line)>;
  static constexpr size_t kMax = 20;

  // `robot` is its namespace.
  Ros2Complaints(std::string robot, Say say) : robot_(std::move(robot)), say_(std::move(say)) {}

  void Add(const std::string& what);
  // At the end: how many there were that were not said.
  void SayHowManyMore() const;

 private:
  const std::string robot_;
  const Say say_;
  std::set<std::string> said_;
  uint64_t unsaid_count_ = 0;
};

class Ros2Link {
 public:
  using Say = Ros2Complaints::Say;  // for people

  // `space` is the robot's namespace, with its number after it if there are several.  Puts itself
  // into the network of the robots of a simulation that is still to be made of `options`; inside
  // of what is there, so that a recorder hears it.  `bus` and this outlive the simulation.
  Ros2Link(Bus* bus, std::string space, SimulationOptions* options, Say say);
  Ros2Link(const Ros2Link&) = delete;
  Ros2Link& operator=(const Ros2Link&) = delete;

  // When the simulation is there.
  void Begin(Simulation* simulation);
  // After each frame.
  void AfterFrame();
  // The run is over.
  void End();

 private:
  struct Robot {
    std::string space;
    VirtualRobot* robot = nullptr;
    JointClient* client = nullptr;
    std::unique_ptr<RobotTopics> topics;
    std::unique_ptr<Ros2JointCommands> commands;
    std::unique_ptr<Ros2Complaints> complaints;
    int frames_waiting = 0;
  };

  void TakeCommands(Robot* robot);

  Bus* const bus_;
  const std::string space_;
  const Say say_;
  Ros2Clock clock_;
  Simulation* simulation_ = nullptr;
  std::vector<Robot> robots_;
};

}  // namespace openr_host
