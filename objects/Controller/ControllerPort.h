//
// The functions of the robot that ControllerCore needs.  Controller implements them with OPEN-R
// calls, tests with a robot of their own.
//

#ifndef ControllerPort_h_DEFINED
#define ControllerPort_h_DEFINED

#include <string>
#include <vector>

#include "Messages.h"

class ControllerPort {
public:
    virtual ~ControllerPort() {}

    // Whether the receiver of these vectors or messages is ready.
    virtual bool IsLedReady() = 0;
    virtual bool IsEarReady() = 0;
    virtual bool IsBatchMoverReady() = 0;

    // Sends a vector for all LEDs that lasts `frames` of 8 ms.  Bit i of `on` is LED i.
    virtual void SendLeds(Uint32 on, int frames) = 0;

    // Sends a vector for all ears.  Bit i of `on` is ear i.
    virtual void SendEars(Uint32 on) = 0;

    virtual void SendBatch(const BatchMoverCommand& batch) = 0;

    // Sends a command when JointMover is ready.  A newer command replaces one that waits.
    virtual void SendMover(const MoverCommand& command) = 0;

    // Reads a file of the Memory Stick.  Returns false with a reason in `error` on failure.
    virtual bool ReadFile(const std::string& path, std::vector<Uint8>* bytes,
                          std::string* error) = 0;

    // Returns the remaining battery capacity, %.
    virtual int BatteryCapacity() = 0;

    // Switches the reception of images on or off.
    virtual void EnableCamera(bool on) = 0;

    // Reports that the controller's time step is not a multiple of a frame.
    virtual void TimeStepRounded(int askedMs, int usedMs) = 0;

    // Reports that the controller asked for a device that the robot does not have.
    virtual void UnknownDevice(const char* locator) = 0;

    // Reports a mistake of the controller.
    virtual void Remark(const char* text) = 0;

    // Prints a text of the controller on the console.
    virtual void Print(const char* text) = 0;

    // Run a controller that is an endless loop.  Such a controller is left in robot_step() and
    // continued there later, which needs a stack of its own.  RunLoop() calls `body`, on that stack
    // if there is one, and returns when `body` has ended or has called LeaveLoop().  ContinueLoop()
    // continues after LeaveLoop() and returns in the same cases.  LeaveLoop() returns false at once
    // when there is no such stack.
    virtual void RunLoop(void (*body)(void*), void* argument) = 0;
    virtual bool LeaveLoop() = 0;
    virtual void ContinueLoop() = 0;

    // Ends the controller, after LeaveLoop() has failed, by ending the method of the object that
    // runs.  Does not return.
    virtual void EndLoop() = 0;
};

#endif  // ControllerPort_h_DEFINED
