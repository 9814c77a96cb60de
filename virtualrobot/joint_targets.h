// JointTargets: set points of joints that come from inputs such as "target LF_j1 12.5 in 32ms".
//
// While a joint has such a set point, its servo ignores the set points of the robot's objects.
// Programs that learn to move use this input, because it needs no object and is part of the
// recording of a run.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/core/inputs.h"

namespace openr_host {

class Hasher;
struct RobotParts;

class JointTargets {
 public:
  // `robot` must outlive this object.
  explicit JointTargets(RobotParts* robot) : robot_(*robot) {}

  // Adds the input `target` of this robot to its system.
  void AddVerbs();

  // Sets the set points of the frame of 8 ms that begins.  Called after the set points of the
  // objects.
  void DoFrame();

  // Gives a joint back to the objects of the robot.
  void Release(int joint) { ways_.erase(joint); }
  // Gives all joints back to the objects of the robot.
  void SwitchOff() { ways_.clear(); }

  void HashState(Hasher* hasher) const;

 private:
  // The way of a set point from its old value to its goal, in equal steps, one per frame.
  struct Way {
    int32_t from_urad = 0;
    int32_t goal_urad = 0;
    int64_t frames = 1;  // length of the way
    int64_t done = 0;    // frames of the way that are over
  };
  struct Goal {
    int joint;
    int32_t urad;
  };

  std::string Read(std::string_view rest, Inputs::Action* action);
  std::string ReadGoals(const std::vector<std::string_view>& words, std::vector<Goal>* goals);
  int JointNamed(std::string_view name);
  void Begin(const std::vector<Goal>& goals, int64_t frames);

  RobotParts& robot_;
  std::map<int, Way> ways_;                        // key: the joint
  std::map<std::string, int, std::less<>> known_;  // joints by the names that inputs have used
};

}  // namespace openr_host
