//
// What the control loop asks of the robot.  Controller answers with OPEN-R calls, tests with a
// robot of their own.
//

#ifndef ControllerPort_h_DEFINED
#define ControllerPort_h_DEFINED

#include <string>
#include <vector>

#include "Messages.h"

class ControllerPort {
public:
    virtual ~ControllerPort() {}

    // Whether the other side would take something now.
    virtual bool IsLedReady() = 0;
    virtual bool IsEarReady() = 0;
    virtual bool IsBatchMoverReady() = 0;

    // All LEDs, bit i on or off, for so many 8 ms frames.
    virtual void SendLeds(Uint32 on, int frames) = 0;

    // All ears.
    virtual void SendEars(Uint32 on) = 0;

    virtual void SendBatch(const BatchMoverCommand& batch) = 0;

    // Goes out when JointMover is ready; a newer one replaces one that waits.
    virtual void SendMover(const MoverCommand& command) = 0;

    // A file of the Memory Stick, or false and why not.
    virtual bool ReadFile(const std::string& path, std::vector<Uint8>* bytes,
                          std::string* error) = 0;

    // Remaining battery capacity, %.
    virtual int BatteryCapacity() = 0;

    // Whether images shall come, by ReceiveCameraImage().
    virtual void EnableCamera(bool on) = 0;

    // The controller's time step is no multiple of a frame.
    virtual void TimeStepRounded(int askedMs, int usedMs) = 0;

    // The controller asks for a device that the robot has not.
    virtual void UnknownDevice(const char* locator) = 0;

    // Something the controller does that it would better not.
    virtual void Remark(const char* text) = 0;

    // What the controller says to whoever watches.
    virtual void Print(const char* text) = 0;

    // A controller that is an endless loop is left in the middle, in robot_step(), and continued
    // there; that takes a stack of its own.  RunLoop() calls `body` on it, if there is one, and
    // returns when body has ended or is in LeaveLoop(); ContinueLoop() goes on there and returns
    // likewise.  LeaveLoop() returns false at once when there is no such stack.
    virtual void RunLoop(void (*body)(void*), void* argument) = 0;
    virtual bool LeaveLoop() = 0;
    virtual void ContinueLoop() = 0;

    // The loop could not be left: ends it by ending the method that runs.  Does not return.
    virtual void EndLoop() = 0;
};

#endif  // ControllerPort_h_DEFINED
