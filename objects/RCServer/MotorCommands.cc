//
// Answers the requests of the remote control for motors and power: MOTOR_OFF, MOTOR_ON, GAINS,
// POWER.
//

#include "RequestHandler.h"

#include <string.h>

#include "MoverState.h"
#include "TextFormat.h"

int
RequestHandler::SwitchMotor(int command, RcReader* in)
{
    const int joint = in->U8();
    if (!in->IsComplete()) return FailSize();
    const bool all = joint == RC_ALL_JOINTS;
    if (!all && joint >= robot_->numJoints) return FailIndex("joint", joint, robot_->numJoints);
    int status = Busy(true);
    if (status == rcOK && !all && command == rcMOTOR_ON) status = Limp();
    if (status != rcOK) return status;
    MoverCommand message;
    memset(&message, 0, sizeof(message));
    message.kind = command == rcMOTOR_ON ? moverkindMOTOR_ON : moverkindMOTOR_OFF;
    message.joint = all ? MOVER_ALL_JOINTS : joint;
    status = Post(message);
    if (status != rcOK || !all) return status;
    // Assumes that JointMover will carry the command out, until JointMover reports its state.
    motorsOff_ = command == rcMOTOR_OFF;
    if (motorsOff_) state_ = moverACCEPTING_COMMANDS;
    return rcOK;
}

// Answers with the gains of a joint.  If the request has new gains, asks JointMover to set them,
// and answers with the new gains although JointMover sets them a moment later.
int
RequestHandler::SetOrTellGains(RcReader* in, RcWriter* out)
{
    const int joint = in->U8();
    const bool sets = in->RestSize() > 0;
    if (in->HasFailed() || (sets && in->RestSize() != 6)) return FailSize();
    if (joint >= robot_->numJoints) return FailIndex("joint", joint, robot_->numJoints);
    Uint16 inForce[6];
    RcGains gains;
    gains.isOn = port_->ReadGains(joint, inForce) ? 1 : 0;
    for (int i = 0; i < 3; i++) {
        gains.gain[i] = inForce[i];
        gains.shift[i] = inForce[i + 3];
    }
    if (sets) {
        const int status = SetGains(joint, in, &gains);
        if (status != rcOK) return status;
    }
    gains.Write(out);
    return rcOK;
}

int
RequestHandler::SetGains(int joint, RcReader* in, RcGains* gains)
{
    const int status = Busy(true);
    if (status != rcOK) return status;
    MoverCommand message;
    memset(&message, 0, sizeof(message));
    message.kind = moverkindGAINS;
    message.joint = joint;
    for (int i = 0; i < 3; i++) {
        gains->gain[i] = in->U16();
        // Answers with the constant shifts of the robot.  A request cannot change shifts, because
        // the ERS-7 has one register of shifts for all joints.
        gains->shift[i] = robot_->joints[joint].gain[i + 3];
        message.gain[i] = gains->gain[i];
        if (gains->gain[i] <= RC_MAX_GAIN) continue;
        return Fail(rcerrorBAD_VALUE, TextFormat("%c gain %d, must be 0 to %d", "PID"[i],
                                                 gains->gain[i], RC_MAX_GAIN));
    }
    return Post(message);
}

int
RequestHandler::TellPower(RcReader* in, RcWriter* out)
{
    if (!in->IsComplete()) return FailSize();
    RcPower power;
    memset(&power, 0, sizeof(power));
    if (!port_->ReadPower(&power)) {
        return Fail(rcerrorBUSY, "the robot does not tell its power status now; try again");
    }
    power.Write(out);
    return rcOK;
}
