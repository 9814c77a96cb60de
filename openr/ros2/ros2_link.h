// Ros2Link connects a run with ROS 2: publishes its clock and the sensors of its robots, and takes
// commands for joints.  Publishing changes nothing in the run.  Commands enter a robot through the
// remote control (joint_client.h).
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

// Returns "" if `name` can be a namespace of ROS 2: words with "/" between them, such as
// "lab/aibo".  Otherwise returns an error text.
std::string WrongNamespace(const std::string& name);

// Prints messages about problems of one robot with ROS 2. Prints the same text only once, because a
// problem may come again with each frame.  Prints at most kMax different texts.
class Ros2Problems {
 public:
  using Say = std::function<void(const std::string& line)>;
  static constexpr size_t kMax = 20;

  // Makes a Ros2Problems for the robot with the namespace `robot` in ROS 2; each message to the
  // user begins with this namespace.
  Ros2Problems(std::string robot, Say say) : robot_(std::move(robot)), say_(std::move(say)) {}

  void Add(const std::string& what);
  // Prints how many messages to the user were left out because kMax messages had been printed.
  // Called at the end of the run.
  void PrintLeftOutCount() const;

 private:
  const std::string robot_;
  const Say say_;
  std::set<std::string> said_;
  uint64_t unsaid_count_ = 0;
};

class Ros2Link {
 public:
  using Say = Ros2Problems::Say;  // type of a function that prints a message

  // Changes `options`, from which the simulation is made later.  The network of each robot gets a
  // JointClient, which sends the robot the commands of ROS 2.  A recorder must have been put into
  // `options` before, because otherwise the recorder does not see these commands.  `space` is the
  // namespace of the robot's topics; with several robots, the namespace of each is `space` followed
  // by the robot's number.  `bus` and this Ros2Link must outlive the simulation.
  Ros2Link(Bus* bus, std::string space, SimulationOptions* options, Say say);
  Ros2Link(const Ros2Link&) = delete;
  Ros2Link& operator=(const Ros2Link&) = delete;

  // Begins to publish the clock and the sensors.  Called when the simulation has been made.
  void Begin(Simulation* simulation);
  // Publishes clock and sensors, and passes to the robots the commands and inputs that ROS 2 has
  // sent.  Called after each frame of 8 ms.
  void AfterFrame();
  // Prints for each robot how many messages Ros2Problems has left out.  Called when the run is
  // over.
  void End();

 private:
  struct Robot {
    std::string space;
    VirtualRobot* robot = nullptr;
    JointClient* client = nullptr;
    std::unique_ptr<RobotTopics> topics;
    std::unique_ptr<Ros2JointCommands> commands;
    std::unique_ptr<Ros2Texts> inputs;
    std::unique_ptr<Ros2Problems> problems;
    int frames_waiting = 0;
  };

  void ApplyCommands(Robot* robot);
  void ApplyInputs(Robot* robot);

  Bus* const bus_;
  const std::string space_;
  const Say say_;
  Ros2Clock clock_;
  Simulation* simulation_ = nullptr;
  std::vector<Robot> robots_;
};

}  // namespace openr_host
