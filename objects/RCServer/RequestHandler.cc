#include "RequestHandler.h"

#include <string.h>

#include "Angle.h"
#include "ImageFile.h"
#include "MoverState.h"
#include "TextFormat.h"

RequestHandler::RequestHandler(RequestPort* port)
    : port_(port),
      robot_(0),
      state_(-1),
      motorsOff_(false),
      version_(RC_VERSION),
      isInBatch_(false),
      client_(0),
      tag_(0),
      endsRun_(false)
{
    memset(&sensors_, 0, sizeof(sensors_));
    sensors_.frame = NO_SENSOR_FRAME;
    memset(&report_, 0, sizeof(report_));
    report_.keyFrame = -1;
    memset(speed_, 0, sizeof(speed_));
    memset(acceleration_, 0, sizeof(acceleration_));
}

std::string
RequestHandler::Begin(const RobotConstants* robot, const std::string& stickRoot)
{
    robot_ = robot;
    store_.SetRoot(stickRoot);
    log_.Begin(robot);
    std::string kept = store_.PutBack();
    for (int i = 0; i < MAX_CLIENTS; i++) {
        upload_[i].SetPlace(i);
        const std::string path = upload_[i].RemoveLeftovers(store_);
        if (!path.empty()) kept = path;
    }
    for (int j = 0; j < robot->numJoints; j++) {
        speed_[j] = robot->joints[j].maxSpeedCdeg;
        acceleration_[j] = robot->defaultAccelerationCdeg;
    }
    return kept;
}

void
RequestHandler::SetMover(const SetValueMessage& message)
{
    state_ = message.state;
    report_ = message;
    log_.Add(message, sensors_);
    for (int i = 0; i < MAX_CLIENTS; i++) streams_[i].NewValues(rcstreamSET_VALUES, sensors_.frame);
    motorsOff_ = message.motorsOff != 0;
}

// Records that JointMover accepts commands, because JointMover has asserted ready.  JointMover is
// ready only when the robot stands, and from then on it accepts commands.  Usually a report of
// JointMover has told this before.  But JointMover reports its state only when the state changes,
// so an RCServer that has replaced another RCServer gets no report.  Such an RCServer learns the
// state from the ready event.
void
RequestHandler::MoverIsReady()
{
    if (state_ < 0) state_ = moverACCEPTING_COMMANDS;
}

// ---- Answers -------------------------------------------------------------------------

// Begins an answer: leaves room for the header, then writes frame number and status.  PutHeader()
// writes the header later, when the size is known.
void
RequestHandler::BeginAnswer(RcWriter* out, int status)
{
    for (int i = 0; i < RC_HEADER_SIZE; i++) out->U8(0);
    out->U32(sensors_.frame);
    out->U16(status);
    out->U16(0);
}

void
RequestHandler::Answer(int client, const RcFramer& request, RcWriter* out)
{
    client_ = client;
    endsRun_ = false;
    AnswerOne(request.Header(), request.Payload(), out);
}

// Writes the answer to one request, which is a packet or a part of a batch.  When `out` has no room
// for the answer, writes an error answer; if its text does not fit either, the text is cut off.
void
RequestHandler::AnswerOne(const RcHeader& request, const Uint8* payload, RcWriter* out)
{
    RcReader in(payload, request.size - RC_HEADER_SIZE);
    // Uses version 1 for the answer to a request whose version is not served, because every client
    // knows version 1.
    const bool isServed = request.version == RC_VERSION || request.version == RC_VERSION_FILES;
    const int version = isServed ? request.version : RC_VERSION;
    version_ = version;
    tag_ = request.tag;
    error_ = "";
    BeginAnswer(out, rcOK);
    int status;
    if (isServed) {
        status = Handle(request.command, &in, out);
    } else {
        status = Fail(rcerrorVERSION,
                      TextFormat("protocol version %d is not served, only %d and %d",
                                 request.version, RC_VERSION, RC_VERSION_FILES));
    }
    // Reports the request as failed, because its answer has no room.  The request has changed
    // nothing: the answer to a request that changes something always has room.
    if (out->HasOverflowed()) status = Fail(rcerrorTOO_LONG, "the answer has no room");
    if (status != rcOK) {
        out->Truncate(0);
        BeginAnswer(out, status);
        const size_t room = (size_t)(out->Room() - 1);
        if (error_.size() > room) error_.resize(room);
        out->String(error_);
    }
    out->PutHeader(request.command, request.tag, version);
}

void
RequestHandler::EndClient(int client)
{
    upload_[client].Abort();
    streams_[client].Clear();
    EndPicture(client);
}

void
RequestHandler::AnswerBroken(const std::string& error, RcWriter* out)
{
    BeginAnswer(out, rcerrorBAD_PACKET);
    out->String(error);
    out->PutHeader(0, 0);
}

void
RequestHandler::AnswerNoPlace(const RcFramer* request, int places, int seconds, RcWriter* out)
{
    BeginAnswer(out, rcerrorBUSY);
    out->String(TextFormat("all %d places are taken, and none of these clients has been silent for "
                           "%d s; end one of them, or try again",
                           places, seconds));
    if (request != 0) {
        out->PutHeader(request->Header().command, request->Header().tag,
                       request->Header().version == RC_VERSION_FILES ? RC_VERSION_FILES
                                                                     : RC_VERSION);
    } else {
        out->PutHeader(0, 0);
    }
}

int
RequestHandler::Fail(int status, const std::string& why)
{
    error_ = why;
    return status;
}

int
RequestHandler::FailSize()
{
    return Fail(rcerrorMALFORMED, "the payload is too short or too long for this command");
}

int
RequestHandler::FailIndex(const char* what, int index, int count)
{
    return Fail(rcerrorNO_SUCH_DEVICE, TextFormat("%s %d: the %s has %d, counted from 0", what,
                                                  index, robot_->design, count));
}

// Handles the commands of version 1 of the remote control's protocol, which version 2 has as well.
int
RequestHandler::HandleVersion1(int command, RcReader* in, RcWriter* out)
{
    switch (command) {
    case rcINFO:
        return TellInfo(in, out);
    case rcDESCRIBE:
        return Describe(in, out);
    case rcGET:
        return GetJoint(in, out);
    case rcMOVE:
    case rcSPEED:
    case rcACCEL:
        return CommandJoint(command, in, out);
    case rcLED:
    case rcEAR:
        return CommandLight(command, in, out);
    case rcSENSORS:
        return TellSensors(in, out);
    case rcMTN_PLAY:
        return PlayMotion(in, out);
    case rcMTN_STOP:
        return StopMotion(in);
    case rcMTN_LIST:
    case rcUPLOAD_BEGIN:
    case rcUPLOAD_DATA:
    case rcUPLOAD_END:
    case rcDELETE:
    case rcLOG:
    case rcREBOOT:
    case rcSHUTDOWN:
        // Refuses the commands that version 1 of the protocol only reserves, although version 2 has
        // them, because clients of version 1 must get the answers that they always got.
        return Fail(rcerrorNOT_IMPLEMENTED,
                    TextFormat("command %02x is reserved in protocol version %d", command,
                               version_));
    default:
        return Fail(rcerrorUNKNOWN_COMMAND, TextFormat("command %02x is unknown", command));
    }
}

// ---- Devices -------------------------------------------------------------------------

int
RequestHandler::NumDevices(int kind) const
{
    switch (kind) {
    case rcdeviceJOINT:
        return robot_->numJoints;
    case rcdeviceLED:
        return robot_->numLeds;
    case rcdeviceEAR:
        return robot_->numPlungers;
    case rcdeviceBINARY:
        return CountSensors(robot_, sensorBINARY);
    case rcdeviceOTHER:
        return CountSensors(robot_, sensorOTHER);
    default:
        return 0;
    }
}

const SensorConstants*
RequestHandler::FindInGroup(SensorGroup group, int index) const
{
    for (int i = 0; i < robot_->numSensors; i++) {
        if (robot_->sensors[i].group == group && index-- == 0) return &robot_->sensors[i];
    }
    return 0;
}

int
RequestHandler::TellInfo(RcReader* in, RcWriter* out)
{
    if (!in->IsComplete()) return FailSize();
    RcInfo info;
    info.numJoints = (Uint8)robot_->numJoints;
    info.numLeds = (Uint8)robot_->numLeds;
    info.numEars = (Uint8)robot_->numPlungers;
    info.numBinary = (Uint8)NumDevices(rcdeviceBINARY);
    info.numOther = (Uint8)NumDevices(rcdeviceOTHER);
    // Counts the two miscellaneous values that WriteSensors() writes: remaining capacity and
    // temperature of the battery.
    info.numMisc = 2;
    info.state = (Uint8)state_;
    info.design = robot_->design;
    info.software = "openr-host RCServer";
    info.hasFiles = version_ >= RC_VERSION_FILES;
    info.processor = (Uint8)OwnProcessor();
    info.largestMotion = RC_MAX_MOTION;
    info.largestImage = RC_MAX_IMAGE;
    info.Write(out);
    return rcOK;
}

int
RequestHandler::Describe(RcReader* in, RcWriter* out)
{
    const int kind = in->U8();
    const int index = in->U8();
    if (!in->IsComplete()) return FailSize();
    if (kind >= NUM_RC_DEVICES)
        return Fail(rcerrorNO_SUCH_DEVICE, TextFormat("device kind %d is unknown", kind));
    RcDescription description;
    if (!DescribeDevice(kind, index, &description))
        return FailIndex("device", index, NumDevices(kind));
    description.Write(out);
    return rcOK;
}

bool
RequestHandler::DescribeDevice(int kind, int index, RcDescription* description) const
{
    if (index >= NumDevices(kind)) return false;
    if (kind == rcdeviceJOINT) {
        const JointConstants& joint = robot_->joints[index];
        description->name = joint.name;
        description->title = joint.title;
        description->locator = joint.locator;
        const Sint32 values[NUM_RC_JOINT_VALUES] = {
            joint.minCdeg,
            joint.maxCdeg,
            joint.minSpeedCdeg,
            joint.maxSpeedCdeg,
            robot_->minAccelerationCdeg,
            robot_->maxAccelerationCdeg,
            robot_->defaultAccelerationCdeg,
        };
        description->values.assign(values, values + NUM_RC_JOINT_VALUES);
    } else if (kind == rcdeviceLED) {
        description->title = robot_->leds[index].title;
        description->locator = robot_->leds[index].locator;
    } else if (kind == rcdeviceEAR) {
        description->title = robot_->plungers[index].title;
        description->locator = robot_->plungers[index].locator;
    } else {
        const SensorConstants* sensor =
            FindInGroup(kind == rcdeviceBINARY ? sensorBINARY : sensorOTHER, index);
        description->title = sensor->title;
        description->locator = sensor->locator;
        description->values.push_back(sensor->kind);
    }
    if (description->name.empty()) description->name = description->title;
    return true;
}

// ---- Sensor values -------------------------------------------------------------------

int
RequestHandler::GetJoint(RcReader* in, RcWriter* out)
{
    const int joint = in->U8();
    if (!in->IsComplete()) return FailSize();
    if (joint >= robot_->numJoints) return FailIndex("joint", joint, robot_->numJoints);
    const RcJointState state = { CdegFromUrad(sensors_.joint[joint]), speed_[joint],
                                 acceleration_[joint] };
    state.Write(out);
    return rcOK;
}

int
RequestHandler::TellSensors(RcReader* in, RcWriter* out)
{
    if (!in->IsComplete()) return FailSize();
    WriteSensors(out);
    return rcOK;
}

void
RequestHandler::WriteSensors(RcWriter* out)
{
    RcSensors answer;
    answer.state = (Uint8)state_;
    for (int j = 0; j < robot_->numJoints; j++)
        answer.joints.push_back(CdegFromUrad(sensors_.joint[j]));
    for (int i = 0; i < robot_->numSensors; i++) {
        (robot_->sensors[i].group == sensorBINARY ? answer.binary : answer.other)
            .push_back(sensors_.sensor[i]);
    }
    Sint32 capacity = 0;
    Sint32 temperature = 0;
    port_->ReadBattery(&capacity, &temperature);
    answer.misc.push_back(capacity);
    answer.misc.push_back(temperature);
    answer.keyFrame.push_back(report_.keyFrame);
    answer.Write(out);
}
