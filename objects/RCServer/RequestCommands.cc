//
// Answers the requests of the remote control that make the robot do something, such as moving a
// joint.
//

#include "RequestHandler.h"

#include <string.h>

#include "Angle.h"
#include "MoverState.h"
#include "TextFormat.h"

// Returns rcOK when JointMover accepts commands.  Otherwise writes the reason to error_ and returns
// rcerrorBUSY.  `duringMotion` says that the command is also accepted while a motion plays.
int
RequestHandler::Busy(bool duringMotion)
{
    if (state_ < moverACCEPTING_COMMANDS) {
        return Fail(rcerrorBUSY,
                    TextFormat("the robot is still on its way to its standing posture (%s)",
                               state_ < 0 ? "starting" : MoverStateName(state_)));
    }
    if (state_ != moverACCEPTING_COMMANDS && !duringMotion) {
        return Fail(rcerrorBUSY, TextFormat("a motion is being played (%s); stop it or wait",
                                            MoverStateName(state_)));
    }
    return rcOK;
}

// Returns rcOK while the motors have power.  Otherwise writes the reason to error_ and returns
// rcerrorBUSY.  Called for commands that have no effect without power.
int
RequestHandler::Limp()
{
    if (!motorsOff_) return rcOK;
    return Fail(rcerrorBUSY, "the motors are off; MOTOR_ON for all joints (255) switches them on");
}

int
RequestHandler::Post(const MoverCommand& command)
{
    if (port_->PostMover(command)) return rcOK;
    return Fail(rcerrorBUSY, "too many commands are waiting for JointMover; try again");
}

int
RequestHandler::CommandJoint(int command, RcReader* in, RcWriter* out)
{
    const int index = in->U8();
    const Sint32 asked = in->S32();
    if (!in->IsComplete()) return FailSize();
    if (index >= robot_->numJoints) return FailIndex("joint", index, robot_->numJoints);
    int busy = Busy(command != rcMOVE);
    if (busy == rcOK && command == rcMOVE) busy = Limp();
    if (busy != rcOK) return busy;

    const JointConstants& joint = robot_->joints[index];
    MoverCommand message;
    memset(&message, 0, sizeof(message));
    message.joint = index;
    Sint32 inForce;
    if (command == rcMOVE) {
        inForce = Clamp(asked, joint.minCdeg, joint.maxCdeg);
        message.kind = moverkindPOSITION;
        message.value = UradFromCdeg(inForce);
    } else if (command == rcSPEED) {
        inForce = Clamp(asked, joint.minSpeedCdeg, joint.maxSpeedCdeg);
        message.kind = moverkindSPEED;
        message.value = inForce;
    } else {
        inForce = Clamp(asked, robot_->minAccelerationCdeg, robot_->maxAccelerationCdeg);
        message.kind = moverkindACCELERATION;
        message.value = inForce;
    }
    const int status = Post(message);
    if (status != rcOK) return status;
    if (command == rcSPEED) speed_[index] = inForce;
    if (command == rcACCEL) acceleration_[index] = inForce;
    out->S32(inForce);
    return rcOK;
}

int
RequestHandler::TrackJoint(RcReader* in, RcWriter* out)
{
    const int index = in->U8();
    const Sint32 asked = in->S32();
    const int frames = in->U8();
    if (!in->IsComplete()) return FailSize();
    if (index >= robot_->numJoints) return FailIndex("joint", index, robot_->numJoints);
    if (frames < 1) return Fail(rcerrorBAD_VALUE, "0 frames, must be 1 or more");
    int status = Busy(false);
    if (status == rcOK) status = Limp();
    if (status != rcOK) return status;
    const Sint32 inForce =
        Clamp(asked, robot_->joints[index].minCdeg, robot_->joints[index].maxCdeg);
    MoverCommand message;
    memset(&message, 0, sizeof(message));
    message.kind = moverkindTRACK;
    message.joint = index;
    message.value = UradFromCdeg(inForce);
    message.frames = frames;
    status = Post(message);
    if (status == rcOK) out->S32(inForce);
    return status;
}

int
RequestHandler::CommandLight(int command, RcReader* in, RcWriter* out)
{
    const int index = in->U8();
    const int on = in->U8();
    if (!in->IsComplete()) return FailSize();
    const bool isLed = command == rcLED;
    const int count = isLed ? robot_->numLeds : robot_->numPlungers;
    if (index >= count) return FailIndex(isLed ? "LED" : "ear", index, count);
    if (on > 1)
        return Fail(rcerrorBAD_VALUE, TextFormat("state %d, must be 0 (off) or 1 (on)", on));
    LedEarState change;
    memset(&change, 0, sizeof(change));
    (isLed ? change.ledMask : change.earMask) = 1u << index;
    (isLed ? change.ledOn : change.earOn) = (Uint32)on << index;
    port_->PostLedEar(change);
    out->U8(on);
    return rcOK;
}

int
RequestHandler::PlayMotion(RcReader* in, RcWriter* out)
{
    RcPlayRequest request;
    if (!request.Read(in)) return FailSize();
    int status = Busy(false);
    if (status == rcOK) status = Limp();
    if (status != rcOK) return status;
    if (request.loops < 1) return Fail(rcerrorBAD_VALUE, "0 loops, must be 1 or more");
    MoverCommand command;
    memset(&command, 0, sizeof(command));
    command.kind = moverkindPLAY;
    command.loops = request.loops;
    command.keyFramesPerVector = request.keyFramesPerVector;
    RcPlayAnswer answer = { 0, 0, request.loops };
    status = LoadMotion(request.file, &command, &answer);
    if (status == rcOK) status = Post(command);
    if (status != rcOK) return status;
    // Changes state_ already here, because otherwise a client that asks for the state right after
    // this answer would conclude that the motion has ended.
    state_ = moverPREPARE_MTN;  // assumed until JointMover reports its new state
    answer.Write(out);
    return rcOK;
}

// Reads the motion, to answer with its length or with the reason why it cannot be played.
// JointMover reads it again to play it.
int
RequestHandler::LoadMotion(const std::string& file, MoverCommand* command, RcPlayAnswer* answer)
{
    std::string why;
    std::vector<Uint8> bytes;
    if (!MtnFileName(file.c_str(), command->file, &why)) return Fail(rcerrorNO_SUCH_FILE, why);
    if (!port_->ReadFile(std::string(MTN_DIRECTORY) + command->file, &bytes, &why)) {
        return Fail(rcerrorNO_SUCH_FILE, why);
    }
    if (!motion_.Read(bytes.empty() ? 0 : &bytes[0], bytes.size()) || !motion_.MapTo(robot_)) {
        return Fail(rcerrorBAD_FILE, std::string(command->file) + ": " + motion_.Error());
    }
    answer->durationMs = (Uint32)motion_.DurationMs();
    answer->keyFrames = (Uint16)motion_.NumKeyFrames();
    return rcOK;
}

int
RequestHandler::StopMotion(RcReader* in)
{
    if (!in->IsComplete()) return FailSize();
    int status = Busy(true);
    if (status != rcOK) return status;
    MoverCommand command;
    memset(&command, 0, sizeof(command));
    command.kind = moverkindSTOP;
    status = Post(command);
    // Takes the motion for ended as soon as the command "stop" is posted, and does not wait for the
    // report of JointMover.  So the next request of the client may already play a motion.
    if (status == rcOK) state_ = moverACCEPTING_COMMANDS;
    return status;
}
