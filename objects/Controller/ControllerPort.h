//
// The functions of the robot that ControllerCore needs.  Controller implements them with OPEN-R
// calls; the unit tests implement them with a simulated robot.
//

#ifndef ControllerPort_h_DEFINED
#define ControllerPort_h_DEFINED

#include <string>
#include <vector>

#include "Messages.h"

class ControllerPort {
public:
    virtual ~ControllerPort() {}

    // Returns whether the effector is ready for the next LED vector.
    virtual bool IsLedReady() = 0;

    // Returns whether OVirtualRobotComm is ready for the next ear vector.
    virtual bool IsEarReady() = 0;

    // Returns whether JointMover is ready for the next batch command (the buffer of joint
    // commands).
    virtual bool IsBatchMoverReady() = 0;

    // Sends a vector for all LEDs that lasts `frames` frames of 8 ms.  LED i is on when bit i of
    // `on` is set.
    virtual void SendLeds(Uint32 on, int frames) = 0;

    // Sends a vector for all ears.  Ear i is on when bit i of `on` is set.
    virtual void SendEars(Uint32 on) = 0;

    virtual void SendBatch(const BatchMoverCommand& batch) = 0;

    // Sends a command when JointMover is ready.  A newer command replaces a command that still
    // waits.
    virtual void SendMover(const MoverCommand& command) = 0;

    // Reads a file of the Memory Stick.  On failure, returns false and sets `error` to the reason.
    virtual bool ReadFile(const std::string& path, std::vector<Uint8>* bytes,
                          std::string* error) = 0;

    // Returns the remaining capacity of the battery in percent.
    virtual int BatteryCapacity() = 0;

    // Switches the reception of camera images on or off.
    virtual void EnableCamera(bool on) = 0;

    // Reports that the time step of the controller program is not a multiple of a frame (8 ms).
    virtual void TimeStepRounded(int askedMs, int usedMs) = 0;

    // Reports that the program asked for a device that the robot does not have.
    virtual void UnknownDevice(const char* locator) = 0;

    // Reports `text`, which describes a mistake of the controller program.
    virtual void Remark(const char* text) = 0;

    // Prints a text of the controller program on the robot's console.
    virtual void Print(const char* text) = 0;

    // Calls `body`, a program that may be an endless loop.  Such a program is suspended in
    // robot_step() and continued later.  Because this needs a second stack, `body` runs on the
    // second stack if there is one.  Returns when `body` has ended or has called SuspendLoop().
    virtual void RunLoop(void (*body)(void*), void* argument) = 0;

    // Suspends the program that RunLoop() has called, in the middle of its loop.  Called by this
    // program.  Returns true when ContinueLoop() continues the program.  Returns false at once when
    // there is no second stack.
    virtual bool SuspendLoop() = 0;

    // Continues the program that has called SuspendLoop().  Returns when the program has ended or
    // has called SuspendLoop() again.
    virtual void ContinueLoop() = 0;

    // Ends the program when SuspendLoop() has returned false, by ending the method of the object
    // that runs now.  Does not return.
    virtual void EndLoop() = 0;
};

#endif  // ControllerPort_h_DEFINED
