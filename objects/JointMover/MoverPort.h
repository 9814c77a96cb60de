//
// The functions of the robot that MoverCore needs.  JointMover implements them with OPEN-R calls,
// tests with a robot of their own.
//

#ifndef MoverPort_h_DEFINED
#define MoverPort_h_DEFINED

#include "Messages.h"
#include "MoverState.h"

class MoverPort {
public:
    virtual ~MoverPort() {}

    // Returns the present angle of a joint, urad.
    virtual Sint32 Measure(int joint) = 0;

    // Enables the gain of a joint and sets its six values; disables it.
    virtual void EnableGain(int joint) = 0;
    virtual void DisableGain(int joint) = 0;

    // Tells the new state.
    virtual void StateChanged(MoverState state) = 0;

    // Sends the message on SetValue.
    virtual void Report(const SetValueMessage& message) = 0;

    // Tells that the robot has reached its initial posture.  Called once.
    virtual void InitialPostureReached() = 0;
};

#endif  // MoverPort_h_DEFINED
