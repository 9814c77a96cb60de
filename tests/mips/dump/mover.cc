// JointMover's logic: start-up, commands, a controller's buffer, motions, on a robot that follows.
#include <string.h>

#include <deque>

#include "MoverCore.h"
#include "dump.h"

namespace {

class Dog : public MoverPort {
 public:
  explicit Dog(const char* design) : robot(FindRobot(design)), core(this) {
    const PostureConstants* sleep = FindPosture(robot, "sleep");
    for (int j = 0; j < MAX_JOINTS; j++) {
      angle_[j] = j < robot->numJoints ? sleep->urad[j] + 5000 * j : 0;
      gain_[j] = false;
    }
    core.Begin(robot);
  }
  virtual Sint32 Measure(int joint) { return angle_[joint]; }
  virtual void EnableGain(int joint, const Sint32*) { gain_[joint] = true; }
  virtual void SetMotorPower(bool on) { printf("power %d\n", on ? 1 : 0); }
  virtual void DisableGain(int joint) { gain_[joint] = false; }
  virtual void StateChanged(MoverState state) { printf("state %s\n", MoverStateName(state)); }
  virtual void Report(const SetValueMessage& message) {
    PrintBytes("report", reinterpret_cast<const Uint8*>(&message), sizeof(message));
  }
  virtual void InitialPostureReached() { printf("stands\n"); }

  bool PlayVector() {
    VectorPlan plan;
    while (underWay_.size() < 2 && core.NextVector(&plan)) underWay_.push_back(plan);
    if (underWay_.empty()) return false;
    const VectorPlan& now = underWay_.front();
    printf("vector %d:", now.numFrames);
    for (int j = 0; j < robot->numJoints; j++) {
      for (int f = 0; f < now.numFrames; f++) printf(" %d", now.urad[f][j]);
      if (gain_[j]) angle_[j] = now.urad[now.numFrames - 1][j];
    }
    printf("\n");
    underWay_.pop_front();
    core.VectorEnded();
    return true;
  }
  void Play(int vectors) {
    while (vectors-- > 0 && PlayVector()) {
    }
  }

  const RobotConstants* robot;
  MoverCore core;

 private:
  Sint32 angle_[MAX_JOINTS];
  bool gain_[MAX_JOINTS];
  std::deque<VectorPlan> underWay_;
};

MoverCommand Command(int kind, int joint, Sint32 value) {
  MoverCommand command;
  memset(&command, 0, sizeof(command));
  command.kind = kind;
  command.joint = joint;
  command.value = value;
  command.loops = 2;
  strcpy(command.file, "TEST.MTN");
  return command;
}

void Live(const char* design, Uint32 seed) {
  Dog dog(design);
  dog.Play(400);
  Draw draw(seed);
  BatchMoverCommand batch;
  memset(&batch, 0, sizeof(batch));
  for (int j = 0; j < dog.robot->numJoints; j++) {
    batch.joint[j].speed = dog.robot->joints[j].maxSpeedCdeg;
    batch.joint[j].acceleration = dog.robot->defaultAccelerationCdeg;
  }
  for (int round = 0; round < 30; round++) {
    const int joint = draw.Between(0, dog.robot->numJoints - 1);
    const JointConstants& constants = dog.robot->joints[joint];
    dog.core.MoveJoint(Command(moverkindSPEED, joint, draw.Between(1, constants.maxSpeedCdeg)));
    dog.core.MoveJoint(Command(moverkindACCELERATION, joint, draw.Between(100, 100000)));
    dog.core.MoveJoint(Command(moverkindPOSITION, joint,
                               draw.Between(constants.minUrad - 9, constants.maxUrad + 9)));
    if (round % 3 == 1) {
      batch.joint[joint].position = draw.Between(constants.minUrad, constants.maxUrad);
      batch.joint[joint].flags = draw.Between(0, 3);
      dog.core.Batch(batch);
    }
    dog.Play(draw.Between(1, 40));
    if (round % 5 == 4) {
      dog.Play(1000);
      const int joints = draw.Between(1, 15);
      const int keyFrames = draw.Between(1, 9);
      const std::vector<Uint8> motion = MakeMotion(joints, keyFrames, &draw);
      std::string error;
      const bool good =
          dog.core.Play(Command(moverkindPLAY, 0, 0), &motion[0], motion.size(), &error);
      printf("play %d %s\n", good ? 1 : 0, error.c_str());
      dog.Play(draw.Between(1, 60));
      if (round % 2 == 0) dog.core.Stop();
      dog.Play(1000);
    }
  }
}

}  // namespace

void DumpMover() {
  Live("ERS-210", 8);
  Live("ERS-7", 9);
}
