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
  // `robot` must outlive the JointTargets.
  explicit JointTargets(RobotParts* robot) : robot_(*robot) {}

  // Adds the kind of input named "target" to the System of this robot.  With such an input people
  // and scripts set the set point of a joint.
  void AddInputs();

  // Moves the set points of all joints that an input has taken over (movements_), for the frame of
  // 8 ms that begins.  Called after the set points of the objects' command vectors have been set,
  // so that the set points of inputs replace them.
  void DoFrame();

  // Gives a joint back to the objects of the robot: their set points move the joint again.
  void Release(int joint) { movements_.erase(joint); }
  // Gives all joints back to the objects of the robot, because the robot is switched off.
  void SwitchOff() { movements_.clear(); }

  void HashState(Hasher* hasher) const;

 private:
  // The movement of a set point from its old value to its goal, in equal steps, one step per frame.
  struct Movement {
    int32_t from_urad = 0;
    int32_t goal_urad = 0;
    int64_t frames = 1;  // number of frames in which the set point moves to its goal
    int64_t done = 0;    // number of frames of the movement that are over
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
  int64_t frame_begin_us_ = -1;  // virtual time of the last call of DoFrame(); -1 before the first
  std::map<int, Movement> movements_;  // the key is the index of the joint
  // The indices of joints that were looked up already; the key is the name of the joint in an
  // input.
  std::map<std::string, int, std::less<>> known_;
};

}  // namespace openr_host
