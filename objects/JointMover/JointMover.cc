#include "JointMover.h"

#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>

#include <string.h>

#include "StickFile.h"

JointMover::JointMover()
    : robot_(0), numUnderWay_(0), numReports_(0), isStopped_(true), isUp_(false), core_(this)
{
    for (int j = 0; j < MAX_JOINTS; j++) joint_[j] = oprimitiveID_UNDEF;
    for (int i = 0; i < NUM_REGIONS; i++) region_[i] = 0;
    memset(&nextVector_, 0, sizeof(nextVector_));
}

// ---- Boot and end of the object ------------------------------------------------------

OStatus
JointMover::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;

    char design[orobotdesignNAME_MAX + 1] = "";
    OPENR::GetRobotDesign(design);
    robot_ = FindRobot(design);
    if (robot_ == 0) {
        OSYSLOG1((osyslogERROR, "JointMover: robot design '%s' is not in RobotConstants", design));
        return oFAIL;
    }
    if (OpenJoints() != oSUCCESS || NewRegions() != oSUCCESS) return oFAIL;
    OPENR::SetMotorPower(opowerON);
    isStopped_ = false;
    return oSUCCESS;
}

OStatus
JointMover::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    if (robot_ == 0) return oFAIL;  // the system calls DoStart even if DoInit has failed
    core_.Begin(robot_);
    // If the effector is not ready yet, SendVectors() sends nothing, and the effector's first ready
    // event makes JointMover send vectors.  SendVectors() also sends nothing if DoInit has failed.
    SendVectors();
    SendReports();
    return oSUCCESS;
}

// Stops the object.  Leaves the joints where they are: if the pause button stops the robot, the
// button has cut motor power already, so no joint would move (BBS 421).
OStatus
JointMover::DoStop(const OSystemEvent&)
{
    isStopped_ = true;
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
JointMover::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

OStatus
JointMover::OpenJoints()
{
    for (int j = 0; j < robot_->numJoints; j++) {
        const OStatus status = OPENR::OpenPrimitive(robot_->joints[j].locator, &joint_[j]);
        if (status == oSUCCESS) continue;
        OSYSLOG1((osyslogERROR, "JointMover: cannot open %s of the %s, status %u",
                  robot_->joints[j].locator, robot_->design, (unsigned)status));
        return status;
    }
    return oSUCCESS;
}

OStatus
JointMover::NewRegions()
{
    for (int i = 0; i < NUM_REGIONS; i++) {
        MemoryRegionID id;
        OCommandVectorData* vector;
        const OStatus status = OPENR::NewCommandVectorData(robot_->numJoints, &id, &vector);
        if (status != oSUCCESS) {
            OSYSLOG1((osyslogERROR, "JointMover: no memory for command vectors, status %u",
                      (unsigned)status));
            return status;
        }
        region_[i] = new RCRegion(vector->vectorInfo.memRegionID, vector->vectorInfo.offset,
                                  (void*)vector, vector->vectorInfo.totalSize);
    }
    return oSUCCESS;
}

// ---- Command vectors -----------------------------------------------------------------

// Handles the ready event that the effector sends at the end of each command vector.  The region of
// that vector is free then, so the next vector can be made in it.
void
JointMover::ReadyMove(const OReadyEvent& event)
{
    if (!event.IsAssert() || isStopped_) return;
    const int numBusy = NumBusyRegions();
    for (; numUnderWay_ > numBusy; numUnderWay_--) core_.VectorEnded();
    SendVectors();
    SendReports();
}

// Sends two command vectors at first, and then one vector for each vector that has ended.  Sends no
// vector while the effector is not ready, because a new vector would then replace the vector that
// waits (measured).
void
JointMover::SendVectors()
{
    if (isStopped_ || !subject[sbjMove]->IsReady()) return;
    int numSet = 0;
    for (RCRegion* region = FindFreeRegion(); region != 0; region = FindFreeRegion()) {
        if (!core_.NextVector(&nextVector_)) break;
        FillRegion(region);
        subject[sbjMove]->SetData(region);
        numSet++;
    }
    if (numSet == 0) return;
    subject[sbjMove]->NotifyObservers();
    numUnderWay_ += numSet;
}

// Returns the number of regions that the effector still uses.  JointMover itself has one reference
// to each region, so a region with more references is in use.
int
JointMover::NumBusyRegions() const
{
    int numBusy = 0;
    for (int i = 0; i < NUM_REGIONS; i++) {
        if (region_[i]->NumberOfReference() > 1) numBusy++;
    }
    return numBusy;
}

RCRegion*
JointMover::FindFreeRegion()
{
    for (int i = 0; i < NUM_REGIONS; i++) {
        if (region_[i]->NumberOfReference() == 1) return region_[i];
    }
    return 0;
}

void
JointMover::FillRegion(RCRegion* region)
{
    OCommandVectorData* vector = (OCommandVectorData*)region->Base();
    // Sets every field of every vector, because regions are used again and keep the frames of an
    // earlier vector.
    vector->SetNumData(robot_->numJoints);
    for (int j = 0; j < robot_->numJoints; j++) {
        vector->GetInfo(j)->Set(odataJOINT_COMMAND2, joint_[j], nextVector_.numFrames);
        OJointCommandValue2* value = (OJointCommandValue2*)vector->GetData(j)->value;
        for (int f = 0; f < nextVector_.numFrames; f++) {
            value[f].value = nextVector_.urad[f][j];
            value[f].padding = 0;
        }
    }
}

// Handles the ready event of Controller.  If the robot stands already, a new Controller has
// replaced another one.  Then tells the new Controller at once that the robot stands, so that its
// program begins.  During the start of the robot, the robot does not stand yet, so nothing is told
// here.
void
JointMover::ReadyMainExecution(const OReadyEvent& event)
{
    if (event.IsAssert() && isUp_ && subject[sbjMainExecution]->IsReady()) TellMainExecution();
}

void
JointMover::TellMainExecution()
{
    MainExecutionMessage message = { moverACCEPTING_COMMANDS };
    subject[sbjMainExecution]->SetData(&message, sizeof(message));
    subject[sbjMainExecution]->NotifyObservers();
}

// ---- Commands ------------------------------------------------------------------------

void
JointMover::NotifyMover(const ONotifyEvent& event)
{
    for (int i = 0; i < event.NumOfData(); i++) {
        MoverCommand command;
        memcpy(&command, event.Data(i), sizeof(command));
        // Ends the name here, because the message of another object may lack the zero behind its
        // name.
        command.file[MTN_NAME_SIZE - 1] = '\0';
        switch (command.kind) {
        case moverkindPLAY:
            Play(command);
            break;
        case moverkindSTOP:
            core_.Stop();
            break;
        default:
            core_.CarryOut(command);
            break;
        }
    }
    observer[event.ObsIndex()]->AssertReady(event.SenderID());
    // Sends vectors after a command, too, and not only after ready events of the effector, because
    // no ready event comes while no vector is under way.
    SendVectors();
    SendReports();
}

void
JointMover::NotifyBatchMover(const ONotifyEvent& event)
{
    for (int i = 0; i < event.NumOfData(); i++) {
        core_.Batch(*(const BatchMoverCommand*)event.Data(i));
    }
    observer[event.ObsIndex()]->AssertReady(event.SenderID());
    SendVectors();
    SendReports();
}

// Plays the motion that `command` names.  If the motion is refused, reports it as over, because
// other objects may wait for its end.
void
JointMover::Play(const MoverCommand& command)
{
    std::vector<Uint8> bytes;
    std::string error;
    const std::string file(command.file);
    if (ReadStickFile(MTN_DIRECTORY + file, &bytes, &error)) {
        if (core_.Play(command, bytes.empty() ? 0 : &bytes[0], bytes.size(), &error)) return;
        error = file + ": " + error;
    }
    OSYSLOG1((osyslogERROR, "JointMover: motion not played: %s", error.c_str()));
    core_.ReportRefusal(command);
}

// ---- Implementation of MoverPort -----------------------------------------------------

Sint32
JointMover::Measure(int joint)
{
    OJointValue value;
    const OStatus status = OPENR::GetJointValue(joint_[joint], &value);
    if (status == oSUCCESS) return value.value;
    OSYSLOG1((osyslogERROR, "JointMover: cannot read %s, status %u", robot_->joints[joint].name,
              (unsigned)status));
    return 0;
}

void
JointMover::EnableGain(int joint, const Sint32 gain[3])
{
    const Uint16* shift = robot_->joints[joint].gain + 3;
    OStatus status = OPENR::EnableJointGain(joint_[joint]);
    if (status == oSUCCESS) {
        status = OPENR::SetJointGain(joint_[joint], (word)gain[0], (word)gain[1], (word)gain[2],
                                     shift[0], shift[1], shift[2]);
    }
    if (status == oSUCCESS) return;
    OSYSLOG1((osyslogERROR, "JointMover: no gain on %s, status %u", robot_->joints[joint].name,
              (unsigned)status));
}

void
JointMover::DisableGain(int joint)
{
    OPENR::DisableJointGain(joint_[joint]);
}

void
JointMover::SetMotorPower(bool on)
{
    const OStatus status = OPENR::SetMotorPower(on ? opowerON : opowerOFF);
    if (status == oSUCCESS) return;
    OSYSLOG1((osyslogERROR, "JointMover: cannot switch motor power %s, status %u",
              on ? "on" : "off", (unsigned)status));
}

void
JointMover::StateChanged(MoverState state)
{
    OSYSLOG1((osyslogINFO, "state: %s", MoverStateName(state)));
}

// Adds `message`, a report of the state of JointMover, to the reports of the present handler.
// SendReports() sends these reports together, because a second call of NotifyObservers() would
// replace the reports of the first call.
void
JointMover::Report(const SetValueMessage& message)
{
    subject[sbjSetValue]->SetData(&message, sizeof(message));
    numReports_++;
}

void
JointMover::SendReports()
{
    if (numReports_ > 0 && !isStopped_) subject[sbjSetValue]->NotifyObservers();
    numReports_ = 0;
}

void
JointMover::InitialPostureReached()
{
    isUp_ = true;
    TellMainExecution();
    observer[obsMover]->AssertReady();
    observer[obsBatchMover]->AssertReady();
}
