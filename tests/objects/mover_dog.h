// Dogs for tests of JointMover's logic: one at the start of the robot, one that stands.
#pragma once

#include <gtest/gtest.h>

#include <deque>
#include <map>
#include <string>
#include <vector>

#include "MoverCore.h"
#include "mtn_bytes.h"

namespace openr_host {

// A robot that follows its commands exactly, with the object's two regions in front of it.
class Dog : public MoverPort {
 public:
  explicit Dog(const char* design = "ERS-210") : Dog(FindRobot(design)) {}
  explicit Dog(const RobotConstants* constants) : robot(constants), core(this) {
    const PostureConstants* sleep = FindPosture(robot, "sleep");
    for (int j = 0; j < robot->numJoints; ++j) angle[j] = sleep->urad[j];
    core.Begin(robot);
  }

  Sint32 Measure(int joint) override { return angle[joint]; }
  void EnableGain(int joint, const Sint32 pid[3]) override {
    gain[joint] = true;
    gains[joint] = {pid[0], pid[1], pid[2]};
  }
  void DisableGain(int joint) override { gain[joint] = false; }
  void SetMotorPower(bool on) override { motor_power = on; }
  void StateChanged(MoverState state) override { said.push_back(MoverStateName(state)); }
  void Report(const SetValueMessage& message) override { reports.push_back(message); }
  void InitialPostureReached() override { ++times_standing; }

  // Keeps two vectors under way, as the object does, and plays the older one.
  // Returns false when nothing is left to send.
  bool PlayVector() {
    VectorPlan plan;
    while (under_way.size() < 2 && core.NextVector(&plan)) under_way.push_back(plan);
    if (under_way.empty()) return false;
    for (int f = 0; f < under_way[0].numFrames; ++f) PlayFrame(under_way[0].urad[f]);
    under_way.pop_front();
    core.VectorEnded();
    return true;
  }
  // Plays until nothing is left; at most `vectors`.
  void Play(int vectors = 20000) {
    while (vectors-- > 0 && PlayVector()) {
    }
  }
  void PlayUntil(MoverState state) {
    for (int i = 0; i < 20000 && core.State() != state; ++i) ASSERT_TRUE(PlayVector());
  }

  int Joint(const char* locator) const { return FindJoint(robot, locator); }
  void Move(const char* locator, int32_t urad) { Command(moverkindPOSITION, locator, urad); }
  void Command(int kind, const char* locator, int32_t value) {
    MoverCommand command = {kind, Joint(locator), value, {0}, 0, {}, {}};
    core.MoveJoint(command);
  }
  std::string Start(const MtnBytes& mtn, int loops = 1) {
    const std::vector<uint8_t> bytes = mtn.Bytes();
    MoverCommand command = {moverkindPLAY, 0, 0, {loops}, 0, "TEST.MTN", {}};
    std::string error;
    return core.Play(command, bytes.data(), bytes.size(), &error) ? "" : error;
  }
  // Returns the content of a controller's buffer before its first command.
  BatchMoverCommand Buffer() const {
    BatchMoverCommand batch = {};
    for (int j = 0; j < robot->numJoints; ++j) {
      batch.joint[j].speed = robot->joints[j].maxSpeedCdeg;
      batch.joint[j].acceleration = robot->defaultAccelerationCdeg;
    }
    return batch;
  }

  const RobotConstants* robot;
  MoverCore core;
  std::map<int, int32_t> angle;
  std::map<int, bool> gain;
  std::map<int, std::vector<int>> gains;  // P, I and D gain that were set last
  bool motor_power = true;
  std::vector<std::string> said;
  std::vector<SetValueMessage> reports;
  std::vector<std::map<int, int32_t>> frames;  // every frame played
  std::deque<VectorPlan> under_way;
  int times_standing = 0;

 private:
  void PlayFrame(const Sint32* urad) {
    for (int j = 0; j < robot->numJoints; ++j) {
      if (gain[j]) angle[j] = urad[j];
    }
    frames.push_back(std::map<int, int32_t>());
    for (int j = 0; j < robot->numJoints; ++j) frames.back()[j] = urad[j];
  }
};

class StandingDog : public Dog {
 public:
  explicit StandingDog(const char* design = "ERS-210") : Dog(design) {
    Play();
    said.clear();
    reports.clear();
    frames.clear();
  }
};

}  // namespace openr_host
