//
// What JointMover's logic asks of the robot.  JointMover answers with OPEN-R calls, tests
// with a robot of their own.
//

#ifndef MoverPort_h_DEFINED
#define MoverPort_h_DEFINED

#include "Messages.h"
#include "MoverState.h"

class MoverPort {
public:
    virtual ~MoverPort() {}

    // The angle of a joint now, urad.
    virtual Sint32 Measure(int joint) = 0;

    // Enables the gain of a joint and sets its six values; switches it off.
    virtual void EnableGain(int joint) = 0;
    virtual void DisableGain(int joint) = 0;

    // Says the new state.
    virtual void StateChanged(MoverState state) = 0;

    // Goes out on SetValue.
    virtual void Report(const SetValueMessage& message) = 0;

    // The robot has reached its initial posture; called once.
    virtual void InitialPostureReached() = 0;
};

#endif  // MoverPort_h_DEFINED
