//
// The functions of the robot that MoverCore needs.  JointMover implements them with OPEN-R calls;
// the unit tests implement them with a simulated robot.
//

#ifndef MoverPort_h_DEFINED
#define MoverPort_h_DEFINED

#include "Messages.h"
#include "MoverState.h"

class MoverPort {
public:
    virtual ~MoverPort() {}

    // Returns the present angle of a joint in urad (10^-6 rad).
    virtual Sint32 Measure(int joint) = 0;

    // Enables the gain of a joint.  Sets the P, I and D gain to `gain`, and their shifts (powers of
    // 2 that scale the gains) to the values of the joint in RobotDescription.
    virtual void EnableGain(int joint, const Sint32 gain[3]) = 0;

    // Disables the gain of a joint, which becomes limp.
    virtual void DisableGain(int joint) = 0;

    // Switches the power of all motors on or off.
    virtual void SetMotorPower(bool on) = 0;

    // Tells the port that the state of MoverCore has changed to `state`.
    virtual void StateChanged(MoverState state) = 0;

    // Sends `message` to the observers of the subject SetValue.
    virtual void Report(const SetValueMessage& message) = 0;

    // Tells the port that the robot has reached its initial posture.  Called once.
    virtual void InitialPostureReached() = 0;
};

#endif  // MoverPort_h_DEFINED
