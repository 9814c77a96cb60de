#include "RCServer.h"

#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>
#include <OPENR/ObjcommMessages.h>
#include <OPENR/core_macro.h>

#include <string.h>

#include "StickFile.h"

// Time between the answer to a request for shutdown or reboot and the shutdown: a quarter of a
// second, in frames of 8 ms.
static const Uint32 END_FRAMES = 32;

RCServer::RCServer()
    : handler_(this),
      retryFrame_(0),
      runEnd_(runGOES_ON),
      isShutdownDue_(false),
      endFrame_(0),
      isStopped_(true)
{
    memset(&sensors_, 0, sizeof(sensors_));
    memset(&ledEar_, 0, sizeof(ledEar_));
    for (int i = 0; i < NUM_CLIENTS; i++) {
        client_[i].state = clientCLOSED;
        client_[i].receiveData = 0;
        client_[i].sendData = 0;
        client_[i].isReceiving = false;
        client_[i].isSending = false;
        client_[i].lastFrame = 0;
    }
}

// ---- Boot and end of the object ------------------------------------------------------

OStatus
RCServer::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;
    // Gives the observer a buffer for reports of JointMover, so that no report is lost: JointMover
    // sends reports without waiting for RCServer.
    observer[obsSetValue]->SetBufCtrlParam(0, 1, MAX_NUM_DATA);

    char design[orobotdesignNAME_MAX + 1] = "";
    OPENR::GetRobotDesign(design);
    const RobotConstants* robot = FindRobot(design);
    if (robot == 0) {
        OSYSLOG1((osyslogERROR, "RCServer: robot design '%s' is not in RobotConstants", design));
        return oFAIL;
    }
    isStopped_ = false;
    const std::string kept = handler_.Begin(robot);
    if (!kept.empty()) {
        OSYSLOG1((osyslogERROR, "RCServer: what uploads have left cannot be removed or renamed: %s",
                  kept.c_str()));
    }
    return sensorReader_.Open(robot);
}

OStatus
RCServer::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    // Does not assert ready if DoInit does not know the robot, so that no message comes.  This test
    // is needed because the system calls DoStart even if DoInit has failed.
    if (isStopped_) return oFAIL;
    ASSERT_READY_TO_ALL_OBSERVER;
    observer[obsImage]->DeassertReady();  // refuses images until WantImage() asserts ready
    ipstack_ = antStackRef("IPStack");
    for (int i = 0; i < RC_PLACES; i++) {
        if (NewBuffer(i) != oSUCCESS) return oFAIL;
    }
    for (int i = 0; i < RC_PLACES; i++) Listen(i);
    OSYSLOG1((osyslogINFO, "state: listening"));
    return oSUCCESS;
}

OStatus
RCServer::DoStop(const OSystemEvent&)
{
    for (int i = 0; i < NUM_CLIENTS; i++) {
        if (client_[i].state == clientLISTENING || client_[i].state == clientOPEN) Close(i);
    }
    isStopped_ = true;
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
RCServer::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

// ---- Messages from and to other objects ----------------------------------------------

void
RCServer::NotifySensor(const ONotifyEvent& event)
{
    OSensorFrameVectorData* vector = (OSensorFrameVectorData*)event.Data(event.NumOfData() - 1);
    sensorReader_.Read(vector, &sensors_);
    handler_.SetSensors(sensors_);
    observer[event.ObsIndex()]->AssertReady(event.SenderID());
    // Does the work that depends on time in this handler, because OPEN-R gives objects no timers.
    // A sensor vector comes every 32 ms, so the sensor vectors serve as a clock.
    RetryListening(sensors_.frame);
    PlaceWaiting(sensors_.frame);
    SendEvents();
    ShutDownWhenDue(sensors_.frame);
}

void
RCServer::NotifySetValue(const ONotifyEvent& event)
{
    for (int i = 0; i < event.NumOfData(); i++) {
        handler_.SetMover(*(const SetValueMessage*)event.Data(i));
        SendEvents();  // sends packets after each message, because a client wants every key frame
    }
    observer[event.ObsIndex()]->AssertReady(event.SenderID());
}

// Stores the layer that a client has asked for, from the newest camera image.  Does not assert
// ready again, so that the camera sends no more images.
void
RCServer::NotifyImage(const ONotifyEvent& event)
{
    const int layer = handler_.WantedLayer();
    if (layer < 0) return;  // ignores an image that was sent before the client left
    OFbkImageVectorData* vector = (OFbkImageVectorData*)event.Data(event.NumOfData() - 1);
    const OFbkImageInfo* info = vector->GetInfo(layer);
    CameraLayer image;
    image.frame = (Uint32)info->frameNumber;
    image.width = (Uint16)info->width;
    image.height = (Uint16)info->height;
    image.bytes = vector->GetData(layer);
    image.size = (Uint32)info->dataSize;
    handler_.SetPicture(image);
}

void
RCServer::ReadyMover(const OReadyEvent& event)
{
    if (!event.IsAssert()) return;
    handler_.MoverIsReady();
    SendMover();
}

// Sends waiting commands to JointMover in one notification, at most MAX_NUM_DATA of them.  The
// other commands are sent at JointMover's next ready event.
void
RCServer::SendMover()
{
    if (isStopped_ || mover_.IsEmpty() || !subject[sbjMover]->IsReady()) return;
    for (int i = 0; i < MAX_NUM_DATA && !mover_.IsEmpty(); i++) {
        const MoverCommand command = mover_.Pop();
        subject[sbjMover]->SetData(&command, sizeof(command));
    }
    subject[sbjMover]->NotifyObservers();
}

void
RCServer::ReadyLedEar(const OReadyEvent& event)
{
    if (event.IsAssert()) SendLedEar();
}

void
RCServer::SendLedEar()
{
    if (isStopped_ || (ledEar_.ledMask | ledEar_.earMask) == 0) return;
    if (!subject[sbjLedEar]->IsReady()) return;
    subject[sbjLedEar]->SetData(&ledEar_, sizeof(ledEar_));
    subject[sbjLedEar]->NotifyObservers();
    memset(&ledEar_, 0, sizeof(ledEar_));
}

// ---- Implementation of RequestPort ---------------------------------------------------

bool
RCServer::PostMover(const MoverCommand& command)
{
    if (!mover_.Push(command)) return false;
    SendMover();
    return true;
}

void
RCServer::PostLedEar(const LedEarState& change)
{
    ledEar_.ledMask |= change.ledMask;
    ledEar_.ledOn = (ledEar_.ledOn & ~change.ledMask) | change.ledOn;
    ledEar_.earMask |= change.earMask;
    ledEar_.earOn = (ledEar_.earOn & ~change.earMask) | change.earOn;
    SendLedEar();
}

bool
RCServer::ReadFile(const std::string& path, std::vector<Uint8>* bytes, std::string* error)
{
    return ReadStickFile(path, bytes, error);
}

void
RCServer::WantImage(bool wanted)
{
    if (isStopped_) return;
    if (wanted) {
        observer[obsImage]->AssertReady();
    } else {
        observer[obsImage]->DeassertReady();
    }
}

void
RCServer::EndRun(bool reboot)
{
    // The first request decides between shutdown and reboot; later requests are ignored.
    if (runEnd_ == runGOES_ON) runEnd_ = reboot ? runREBOOT : runSHUTDOWN;
}

// Shuts the robot down a moment after the answer was handed to the network, because the network
// needs this time to bring the answer to the client.
void
RCServer::ShutDownWhenDue(Uint32 frame)
{
    if (!isShutdownDue_ || frame - endFrame_ < END_FRAMES) return;
    isShutdownDue_ = false;
    ShutDownRobot();
}

// Shuts the robot down as PowerMonitor does.  The boot condition says what boots the robot again:
// after a shutdown the pause button, and after a reboot a timer of 0 s (robot.md 15.3).
void
RCServer::ShutDownRobot()
{
    OSYSLOG1((osyslogINFO, "RCServer: a client %s the robot",
              runEnd_ == runREBOOT ? "reboots" : "shuts down"));
    OStatus status = OPENR::SetMotorPower(opowerOFF);
    if (status != oSUCCESS) {
        OSYSLOG1((osyslogERROR, "RCServer: cannot switch motor power off, status %u",
                  (unsigned)status));
    }
    status = runEnd_ == runREBOOT
                 ? OPENR::Shutdown(OBootCondition(obcbBOOT_TIMER, 0, obcbttRELATIVE))
                 : OPENR::Shutdown(OBootCondition(obcbPAUSE_SW));
    if (status != oSUCCESS) {
        OSYSLOG1((osyslogERROR, "RCServer: shutdown failed, status %u", (unsigned)status));
    }
}

// Converts the temperature of the battery to 0.01 degree Celsius.  `temperature` is in 0.1 kelvin,
// from 0 to 5000.  Takes 273 kelvin, and not 273.15, as 0 degrees, because in Hohl 2004, table 3.6,
// the highest temperature is 227.00 degrees, which is 500 kelvin less 273.
static Sint32
CentiCelsius(word temperature)
{
    return (Sint32)temperature * 10 - 27300;
}

void
RCServer::ReadBattery(Sint32* capacity, Sint32* temperature)
{
    OPowerStatus power;
    if (OPENR::GetPowerStatus(&power) != oSUCCESS) return;
    *capacity = power.remainingCapacity;
    *temperature = CentiCelsius(power.temperature);
}

bool
RCServer::ReadPower(RcPower* power)
{
    OPowerStatus status;
    if (OPENR::GetPowerStatus(&status) != oSUCCESS) return false;
    power->robotStatus = (Uint32)status.robotStatus;
    power->batteryStatus = status.batteryStatus;
    power->capacity = status.remainingCapacity;
    power->fullCapacity = status.fullyChargedCapacity;
    power->voltage = status.voltage;
    power->current = status.current;
    power->temperature = CentiCelsius(status.temperature);
    return true;
}

bool
RCServer::ReadGains(int joint, Uint16 gains[6])
{
    memset(gains, 0, 6 * sizeof(gains[0]));
    return OPENR::GetJointGain(sensorReader_.Joint(joint), &gains[0], &gains[1], &gains[2],
                               &gains[3], &gains[4], &gains[5]) == oSUCCESS;
}
