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

    // EnableGain() enables the gain of a joint and sets its six values; DisableGain() disables it.
    virtual void EnableGain(int joint) = 0;
    virtual void DisableGain(int joint) = 0;

    // Called when the state has changed.
    virtual void StateChanged(MoverState state) = 0;

    // Sends the message to the observers of SetValue.
    virtual void Report(const SetValueMessage& message) = 0;

    // Called once, when the robot has reached its initial posture.
    virtual void InitialPostureReached() = 0;
};

#endif  // MoverPort_h_DEFINED
