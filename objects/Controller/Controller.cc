#include "Controller.h"

#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>

#include <stdlib.h>
#include <string.h>

#include "ControllerApi.h"
#include "ControllerMain.h"
#include "LoopStack.h"
#include "StickFile.h"
#include "TextFormat.h"

static const char STEP_IS_NOT_FOR_THE_ROBOT[] =
    "robot_step() does not work on the robot, whose methods must return; put the loop's body into "
    "a function that returns the time step, and call robot_run() with it";

Controller::Controller()
    : robot_(0), roundedMs_(0), hasStepped_(false), isCameraOn_(false), isStopped_(true), core_(this)
{
    memset(&sensors_, 0, sizeof(sensors_));
    for (int i = 0; i < NUM_REGIONS; i++) ledRegion_[i] = earRegion_[i] = 0;
}

// ---- Boot and end of the object ------------------------------------------------------

OStatus
Controller::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;
    // Gives the observer a buffer for reports of JointMover, so that no report is lost: JointMover
    // sends reports without waiting for Controller.
    observer[obsSetValue]->SetBufCtrlParam(0, 1, MAX_NUM_DATA);

    char design[orobotdesignNAME_MAX + 1] = "";
    OPENR::GetRobotDesign(design);
    robot_ = FindRobot(design);
    if (robot_ == 0) {
        OSYSLOG1((osyslogERROR, "Controller: robot design '%s' is not in RobotConstants", design));
        return oFAIL;
    }
    isStopped_ = false;
    core_.Begin(robot_);
    SetControllerCore(&core_);
    const OStatus status = OpenLights();
    return status == oSUCCESS ? sensorReader_.Open(robot_) : status;
}

OStatus
Controller::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    // Does not assert ready if DoInit does not know the robot, so that no message comes.  This test
    // is needed because the system calls DoStart even if DoInit has failed.
    if (isStopped_) return oFAIL;
    ASSERT_READY_TO_ALL_OBSERVER;
    observer[obsImage]->DeassertReady();  // refuses images until camera_enable() asserts ready
    OSYSLOG1((osyslogINFO, "state: waiting"));
    return oSUCCESS;
}

OStatus
Controller::DoStop(const OSystemEvent&)
{
    core_.Die();
    isStopped_ = true;
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Controller::DoDestroy(const OSystemEvent&)
{
    SetControllerCore(0);
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

OStatus
Controller::OpenLights()
{
    for (int i = 0; i < robot_->numLeds; i++) {
        const OStatus status = OPENR::OpenPrimitive(robot_->leds[i].locator, &led_[i]);
        if (status != oSUCCESS) return status;
    }
    for (int i = 0; i < robot_->numPlungers; i++) {
        const OStatus status = OPENR::OpenPrimitive(robot_->plungers[i].locator, &ear_[i]);
        if (status != oSUCCESS) return status;
    }
    const OStatus status = NewRegions(robot_->numLeds, ledRegion_);
    if (status != oSUCCESS || robot_->numPlungers == 0) return status;
    return NewRegions(robot_->numPlungers, earRegion_);
}

OStatus
Controller::NewRegions(int numElements, RCRegion** regions)
{
    for (int i = 0; i < NUM_REGIONS; i++) {
        MemoryRegionID id;
        OCommandVectorData* vector;
        const OStatus status = OPENR::NewCommandVectorData(numElements, &id, &vector);
        if (status != oSUCCESS) return status;
        regions[i] = new RCRegion(vector->vectorInfo.memRegionID, vector->vectorInfo.offset,
                                  (void*)vector, vector->vectorInfo.totalSize);
    }
    return oSUCCESS;
}

// ---- Events from other objects -------------------------------------------------------

void
Controller::ReadyLed(const OReadyEvent& event)
{
    if (event.IsAssert() && !isStopped_) core_.LedReady();
}

void
Controller::ReadyEar(const OReadyEvent& event)
{
    if (event.IsAssert() && !isStopped_) core_.EarReady();
}

void
Controller::ReadyBatchMover(const OReadyEvent& event)
{
    if (event.IsAssert() && !isStopped_) core_.BatchMoverReady();
}

void
Controller::NotifyMainExecution(const ONotifyEvent&)
{
    if (isStopped_) return;
    OSYSLOG1((osyslogINFO, "state: running"));
    core_.Execute(CallControllerMain);
}

void
Controller::NotifyLedEar(const ONotifyEvent& event)
{
    for (int i = 0; i < event.NumOfData(); i++) {
        core_.RemoteLights(*(const LedEarState*)event.Data(i));
    }
    observer[event.ObsIndex()]->AssertReady(event.SenderID());
}

void
Controller::NotifySetValue(const ONotifyEvent& event)
{
    for (int i = 0; i < event.NumOfData(); i++) {
        const SetValueMessage& message = *(const SetValueMessage*)event.Data(i);
        SetMotionValues(message);
        if (message.earMask != 0) core_.MotionEars(message.earMask, message.earOn);
    }
    observer[event.ObsIndex()]->AssertReady(event.SenderID());
}

void
Controller::NotifySensor(const ONotifyEvent& event)
{
    OSensorFrameVectorData* vector = (OSensorFrameVectorData*)event.Data(event.NumOfData() - 1);
    sensorReader_.Read(vector, &sensors_);
    core_.SetSensors(sensors_);
    observer[event.ObsIndex()]->AssertReady(event.SenderID());
}

// ---- Implementation of ControllerPort ------------------------------------------------

bool
Controller::IsLedReady()
{
    return subject[sbjLed]->IsReady() != 0;
}

bool
Controller::IsEarReady()
{
    return subject[sbjEar]->IsReady() != 0;
}

bool
Controller::IsBatchMoverReady()
{
    return subject[sbjBatchMover]->IsReady() != 0;
}

// Finds a region that no observer uses now, and returns the command vector in it.  The caller fills
// the elements of this vector.  Returns 0 when all regions are in use.
OCommandVectorData*
Controller::BeginVector(RCRegion** regions, int numElements, RCRegion** region)
{
    for (int i = 0; i < NUM_REGIONS; i++) {
        if (regions[i] == 0 || regions[i]->NumberOfReference() != 1) continue;
        *region = regions[i];
        OCommandVectorData* vector = (OCommandVectorData*)regions[i]->Base();
        vector->SetNumData(numElements);
        return vector;
    }
    return 0;
}

void
Controller::FinishVector(int sbj, RCRegion* region)
{
    subject[sbj]->SetData(region);
    subject[sbj]->NotifyObservers();
}

static void
FillLed(OCommandData* data, int kind, bool on, int frames)
{
    if (kind == ledLED3) {
        OLEDCommandValue3* value = (OLEDCommandValue3*)data->value;
        value->intensity = on ? 255 : 0;
        value->mode = oled3_MODE_A;
        value->period = (word)frames;
        value->reserved = 0;
    } else {
        OLEDCommandValue2* value = (OLEDCommandValue2*)data->value;
        value->led = on ? oledON : oledOFF;
        value->period = (word)frames;
        value->reserved = 0;
    }
}

void
Controller::SendLeds(Uint32 on, int frames)
{
    RCRegion* region = 0;
    OCommandVectorData* vector = BeginVector(ledRegion_, robot_->numLeds, &region);
    if (vector == 0) {
        OSYSLOG1((osyslogERROR, "Controller: both LED vectors are under way"));
        return;
    }
    for (int i = 0; i < robot_->numLeds; i++) {
        const int kind = robot_->leds[i].kind;
        vector->GetInfo(i)->Set(kind == ledLED3 ? odataLED_COMMAND3 : odataLED_COMMAND2, led_[i],
                                1);
        FillLed(vector->GetData(i), kind, (on >> i & 1) != 0, frames);
    }
    FinishVector(sbjLed, region);
}

// Sends a vector with one value for each ear (plunger): STATE1 (on) if the bit of the ear in `on`
// is set, and STATE0 (off) otherwise (see "plungers" in virtualrobot/model/ers210.json).  The value
// holds for 128 ms, because an ear reaches its position in this time (Hohl 2004, 5.3.4, in
// docs/report.md).  A longer time would heat the coil of the ear without need.
void
Controller::SendEars(Uint32 on)
{
    RCRegion* region = 0;
    OCommandVectorData* vector = BeginVector(earRegion_, robot_->numPlungers, &region);
    if (vector == 0) return;
    for (int i = 0; i < robot_->numPlungers; i++) {
        const bool isJoint4 = robot_->plungers[i].kind == plungerJOINT4;
        vector->GetInfo(i)->Set(isJoint4 ? odataJOINT_COMMAND4 : odataJOINT_COMMAND3, ear_[i], 1);
        if (isJoint4) {
            OJointCommandValue4* value = (OJointCommandValue4*)vector->GetData(i)->value;
            value->value = (on >> i & 1) != 0 ? ojoint4_STATE1 : ojoint4_STATE0;
            // 16 frames of 8 ms, the time in which an ear reaches its position.
            value->period = 16;
            value->reserved = 0;
        } else {
            OJointCommandValue3* value = (OJointCommandValue3*)vector->GetData(i)->value;
            value->value = (on >> i & 1) != 0 ? ojoint3_STATE1 : ojoint3_STATE0;
            value->reserved = 0;
            value->padding = 0;
        }
    }
    FinishVector(sbjEar, region);
}

void
Controller::SendBatch(const BatchMoverCommand& batch)
{
    subject[sbjBatchMover]->SetData(&batch, sizeof(batch));
    subject[sbjBatchMover]->NotifyObservers();
}

void
Controller::SendMover(const MoverCommand& command)
{
    subject[sbjMover]->SetData(&command, sizeof(command));
    subject[sbjMover]->NotifyObservers();
}

bool
Controller::ReadFile(const std::string& path, std::vector<Uint8>* bytes, std::string* error)
{
    return ReadStickFile(path, bytes, error);
}

int
Controller::BatteryCapacity()
{
    OPowerStatus power;
    return OPENR::GetPowerStatus(&power) == oSUCCESS ? power.remainingCapacity : 0;
}

// Reports that a time step was rounded to a multiple of 8 ms.  Does not report the same time step
// again, because the program may ask for it in every iteration of its loop.
void
Controller::TimeStepRounded(int askedMs, int usedMs)
{
    if (askedMs == roundedMs_) return;
    roundedMs_ = askedMs;
    Remark(TextFormat("a time step of %d ms is no multiple of 8; %d ms are used", askedMs, usedMs)
               .c_str());
}

void
Controller::UnknownDevice(const char* locator)
{
    const std::string text =
        TextFormat("robot_get_device: there is no device '%.80s'; what it is told goes nowhere, and "
                   "it reads 0",
                   locator);
    OSYSLOG1((osyslogWARNING, "Controller: %s", text.c_str()));
    const std::vector<const char*> known = core_.Devices().Locators();
    TellRunnerOfName(text.c_str(), locator, &known[0], (int)known.size());
}

void
Controller::Remark(const char* text)
{
    OSYSLOG1((osyslogWARNING, "Controller: %s", text));
    TellRunner(text);
}

void
Controller::Print(const char* text)
{
    OSYSPRINT(("%s", text));
}

void
Controller::RunLoop(void (*body)(void*), void* argument)
{
    LoopStackRun(body, argument);
}

// Suspends main() by LoopStackLeave(), and returns the result of LoopStackLeave().  The first call
// also reports that robot_step() does not work on the robot.  Later calls do not report this again,
// because a program calls robot_step() many times a second.
bool
Controller::SuspendLoop()
{
    if (!hasStepped_) TellRunner(STEP_IS_NOT_FOR_THE_ROBOT);
    hasStepped_ = true;
    return LoopStackLeave();
}

void
Controller::ContinueLoop()
{
    LoopStackContinue();
}

// Ends main() of the program by exit().  On the robot, exit() ends only the running method, so the
// object goes on without main() (Programmer's Guide, appendix A.2).
void
Controller::EndLoop()
{
    OSYSLOG1((osyslogERROR, "Controller: %s; main() ends here", STEP_IS_NOT_FOR_THE_ROBOT));
    exit(1);
}
