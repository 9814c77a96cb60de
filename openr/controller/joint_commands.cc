#include "openr/controller/joint_commands.h"

#include "Angle.h"

namespace openr_host {
namespace {

namespace remote = openr::remote;

RobotCommand LimitCommand(RcCommand command, int joint, Sint32 value, const std::string& what) {
  return {remote::Connection::JointCall(command, joint, value / 100.0), what};
}

}  // namespace

JointCommands::JointCommands(const RobotConstants* robot) : robot_(robot) {
  for (int j = 0; j < robot->numJoints; ++j) {
    SentCommand sent;
    // Begins with the limits of speed and acceleration that a robot has after its start, so that
    // the first change of a limit is noticed.
    sent.speed = robot->joints[j].maxSpeedCdeg;
    sent.acceleration = robot->defaultAccelerationCdeg;
    sent_.push_back(sent);
  }
}

std::vector<RobotCommand> JointCommands::Changes(const BatchMoverCommand& now, bool is_playing) {
  std::vector<RobotCommand> commands;
  // Sends positions first, then speeds, then accelerations, which is the order in Hohl 2004,
  // section 4.2 (docs/report.md).
  for (int j = 0; j < robot_->numJoints; ++j) {
    AddPosition(j, now.joint[j], is_playing, &commands);
  }
  for (int j = 0; j < robot_->numJoints; ++j) {
    Sint32& sent = sent_[static_cast<size_t>(j)].speed;
    if (now.joint[j].speed == sent) continue;
    sent = now.joint[j].speed;
    commands.push_back(
        LimitCommand(rcSPEED, j, sent, std::string("the speed of ") + robot_->joints[j].name));
  }
  for (int j = 0; j < robot_->numJoints; ++j) {
    Sint32& sent = sent_[static_cast<size_t>(j)].acceleration;
    if (now.joint[j].acceleration == sent) continue;
    sent = now.joint[j].acceleration;
    commands.push_back(LimitCommand(rcACCEL, j, sent,
                                    std::string("the acceleration of ") + robot_->joints[j].name));
  }
  return commands;
}

void JointCommands::AddPosition(int joint, const BatchJoint& now, bool is_playing,
                                std::vector<RobotCommand>* commands) {
  SentCommand& sent = sent_[static_cast<size_t>(joint)];
  const std::string name = robot_->joints[joint].name;
  const auto index = static_cast<uint8_t>(joint);
  if ((now.flags & batchMOTOR_OFF) != 0) {
    if (!sent.is_off) commands->push_back({{rcMOTOR_OFF, {index}}, "the motor of " + name});
    sent.is_off = true;
    return;
  }
  if ((now.flags & batchPOSITION_GIVEN) == 0 || is_playing) return;
  const Sint32 position = CdegFromUrad(now.position);
  if (!sent.is_off && sent.position == position) return;
  // Adds a request that switches the motor of the joint on, because MOVE does not switch it on
  // (docs/remote-control.md, MOTOR_ON).
  if (sent.is_off) commands->push_back({{rcMOTOR_ON, {index}}, "the motor of " + name});
  sent.is_off = false;
  sent.position = position;
  commands->push_back({remote::Connection::JointCall(rcMOVE, joint, position / 100.0),
                       "a position of " + name, joint});
}

}  // namespace openr_host
