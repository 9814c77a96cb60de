//
// Controller runs a controller program on the robot.  Such a program is written in the style of the
// simulator Webots (Hohl 2004, section 5.3).
//
//   Controller.Led, Controller.Ear -> OVirtualRobotComm.Effector
//   Controller.BatchMover          -> JointMover: the buffer of joint commands
//   Controller.Mover               -> JointMover: motions
//   Controller.MainExecution       <- message that the robot stands; then the program starts
//   Controller.LedEar              <- LEDs and ears of the remote control
//   Controller.SetValue            <- key frames (postures) that a motion has reached
//   Controller.Sensor              <- sensor values
//   Controller.Image               <- images of the camera, if the program wants them
//
// ControllerCore has the control loop; this class connects the loop with OPEN-R.
//

#ifndef Controller_h_DEFINED
#define Controller_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OSubject.h>
#include <OPENR/OObserver.h>
#include <OPENR/ODataFormats.h>

#include "ControllerCore.h"
#include "SensorReader.h"
#include "def.h"

class Controller : public OObject, private ControllerPort {
public:
    Controller();
    virtual ~Controller() {}

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void ReadyLed(const OReadyEvent& event);
    void ReadyEar(const OReadyEvent& event);
    void ReadyBatchMover(const OReadyEvent& event);
    void NotifyMainExecution(const ONotifyEvent& event);
    void NotifyLedEar(const ONotifyEvent& event);
    void NotifySetValue(const ONotifyEvent& event);
    void NotifySensor(const ONotifyEvent& event);
    void NotifyImage(const ONotifyEvent& event);

private:
    // Number of regions for the command vectors of the LEDs, and the same number for the ears: one
    // vector is played while the other waits until the effector is ready.
    static const int NUM_REGIONS = 2;

    // The functions of ControllerPort, which ControllerCore calls.
    virtual bool IsLedReady();
    virtual bool IsEarReady();
    virtual bool IsBatchMoverReady();
    virtual void SendLeds(Uint32 on, int frames);
    virtual void SendEars(Uint32 on);
    virtual void SendBatch(const BatchMoverCommand& batch);
    virtual void SendMover(const MoverCommand& command);
    virtual bool ReadFile(const std::string& path, std::vector<Uint8>* bytes, std::string* error);
    virtual int BatteryCapacity();
    virtual void EnableCamera(bool on);
    virtual void TimeStepRounded(int askedMs, int usedMs);
    virtual void UnknownDevice(const char* locator);
    virtual void Remark(const char* text);
    virtual void Print(const char* text);
    virtual void RunLoop(void (*body)(void*), void* argument);
    virtual bool SuspendLoop();
    virtual void ContinueLoop();
    virtual void EndLoop();

    OStatus OpenLights();
    OStatus NewRegions(int numElements, RCRegion** regions);
    OCommandVectorData* BeginVector(RCRegion** regions, int numElements, RCRegion** region);
    void FinishVector(int sbj, RCRegion* region);

    const RobotConstants* robot_;
    OPrimitiveID led_[MAX_LEDS];
    OPrimitiveID ear_[MAX_PLUNGERS];
    RCRegion* ledRegion_[NUM_REGIONS];
    RCRegion* earRegion_[NUM_REGIONS];
    SensorReader sensorReader_;
    SensorValues sensors_;
    // The last time step, in ms, for which TimeStepRounded() has reported the rounding, so that it
    // is not reported again.
    int roundedMs_;
    bool hasStepped_;
    bool isCameraOn_;
    bool isStopped_;  // true before DoInit has found the robot, and from DoStop on
    ControllerCore core_;
};

#endif  // Controller_h_DEFINED
