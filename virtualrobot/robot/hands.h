// The hands of a person: they press the robot's sensors, turn its joints, push it, lift it and set
// it down, change its battery and put it on its charging station.
//
// Each action of a hand is an input (runtime/core/inputs.h), such as "press chin for 300ms" or
// "push 5 0 0".  docs/inputs.md describes the inputs.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "runtime/core/inputs.h"

namespace openr_host {

class Hasher;
struct RobotParts;

class Hands {
 public:
  // `robot` must outlive the hands.
  explicit Hands(RobotParts* robot) : robot_(*robot) {}

  // Adds the inputs for hands, such as "press" and "push", to the System of this robot, so that
  // people and scripts can use them.
  void AddInputs();

  // Does what the hands do during the frame of 8 ms that ends now.  Called before the body moves
  // and its sensors are sampled.
  void DoFrame();

  bool is_holding() const { return grip_.has_value(); }
  // Returns whether the input `press` presses sensor `sensor`, or the input `set` sets its value.
  bool IsTouched(int sensor) const { return touches_.contains(sensor); }

  void HashState(Hasher* hasher) const;

 private:
  struct Push {
    int part;  // index of the pushed part in RobotModel::bodies
    Eigen::Vector3d force_B;
    int64_t frames_left;
  };

  // A person's hand that turns a joint against its servo (input `turn`).
  struct Turn {
    double angle_rad = 0;  // the angle to which the hand moves the joint now
    double goal_rad = 0;   // the angle at which the hand stops
    // Number of frames for which the person's hand goes on turning the joint.  nullopt: the hand
    // goes on until an input releases the joint.
    std::optional<int64_t> frames;
  };

  // A person's hand that holds the robot by its trunk, to lift it or to set it down.
  struct Grip {
    Eigen::Isometry3d X_WB;  // the pose to which the hand moves the robot's base
    double goal_z_m = 0;     // the height at which the hand stops
    bool sets_down = false;  // true: the hand lets go when the robot stands or lies on something
  };

  // The next functions read the words after the kind of an input ("press", "set", ...), as
  // Inputs::Kind::read does.  Each returns "" or the error.
  std::string ReadPress(std::string_view rest, Inputs::Action* action);
  std::string ReadSet(std::string_view rest, Inputs::Action* action);
  std::string ReadRelease(std::string_view rest, Inputs::Action* action);
  std::string ReadTurn(std::string_view rest, Inputs::Action* action);
  std::string ReadPush(std::string_view rest, Inputs::Action* action);
  std::string ReadLift(std::string_view rest, Inputs::Action* action);
  std::string ReadPut(std::string_view rest, Inputs::Action* action);
  std::string NoMovableThingText(std::string_view rest) const;
  std::string ReadBattery(std::string_view rest, Inputs::Action* action);
  std::string ReadCharger(std::string_view rest, Inputs::Action* action);

  // Writes the indices of the sensors that `name` names to `sensors`.  Returns "" or the error.
  std::string FindSensors(const std::string& name, std::vector<int>* sensors) const;
  void Touch(int sensor, int32_t value, std::optional<int64_t> frames);
  void Release(int sensor);
  void ReleaseJoint(int joint);
  void MoveJoints();
  void HoldTrunk();
  void LetGo();
  void MoveGrip();

  RobotParts& robot_;
  // The sensors that a hand touches, each with the number of frames for which the hand goes on.
  // nullopt: the hand goes on until an input releases the sensor.
  std::map<int, std::optional<int64_t>> touches_;
  std::vector<Push> pushes_;
  std::map<int, Turn> turns_;  // the key is the index of the joint
  std::optional<Grip> grip_;
};

}  // namespace openr_host
