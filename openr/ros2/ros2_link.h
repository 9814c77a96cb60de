// Connects a run with ROS 2: publishes its clock and robots as topics, and takes commands for
// joints.  Publishing changes nothing in the run.  Commands enter a robot as those of a client of
// the remote control do, see joint_client.h.
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

// Returns "" or what is wrong with the name of a namespace: words with slashes between.
std::string WrongNamespace(const std::string& name);

// Messages to the user about one robot.  Each text is printed only once, and the number of texts is
// limited.
class Ros2Complaints {
 public:
  using Say = std::function<void(const std::string& line)>;
  static constexpr size_t kMax = 20;

  // `robot` is the namespace of the robot that the messages name.
  Ros2Complaints(std::string robot, Say say) : robot_(std::move(robot)), say_(std::move(say)) {}

  void Add(const std::string& what);
  // Prints at the end how many texts were left out.
  void SayHowManyMore() const;

 private:
  const std::string robot_;
  const Say say_;
  std::set<std::string> said_;
  uint64_t unsaid_count_ = 0;
};

class Ros2Link {
 public:
  using Say = Ros2Complaints::Say;  // prints a message

  // `space` is the robot's namespace; with several robots, their numbers are added to it.  The link
  // adds its clients to the networks in `options`, from which a simulation is made later.  The
  // commands also reach networks that `options` has already, so a recorder must have been added
  // before.  `bus` and this object must outlive the simulation.
  Ros2Link(Bus* bus, std::string space, SimulationOptions* options, Say say);
  Ros2Link(const Ros2Link&) = delete;
  Ros2Link& operator=(const Ros2Link&) = delete;

  // Begins publishing.  Called when the simulation has been made.
  void Begin(Simulation* simulation);
  // Publishes the state and passes commands on.  Called after each frame.
  void AfterFrame();
  // Ends the link.  Called when the run is over.
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
