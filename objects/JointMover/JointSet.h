//
// All joints of the robot, moved by the algorithm for manual commands: the movement of each joint,
// and whether its gain is on.
//

#ifndef JointSet_h_DEFINED
#define JointSet_h_DEFINED

#include "MoverPort.h"
#include "RobotDescription.h"
#include "Trajectory.h"

class JointSet {
public:
    // `port` must outlive the set.
    explicit JointSet(MoverPort* port);

    // Puts every joint at rest at its measured position, with the largest speed of its row in
    // RobotConstants and the default acceleration.  Gains are off.
    void Begin(const RobotConstants* robot);

    int NumJoints() const { return robot_->numJoints; }
    void EnableAllGains();

    // Set what MoverCommand asks for.  A value beyond a limit of the robot becomes the limit.
    void SetGoal(int joint, Sint32 urad);
    void SetSpeed(int joint, Sint32 cdeg);
    void SetAcceleration(int joint, Sint32 cdeg);

    // Puts the joint at rest at `urad`, because a motion has moved it there.
    void Place(int joint, Sint32 urad) { trajectory_[joint].Reset(urad); }
    void Halt(int joint) { trajectory_[joint].Halt(); }

    // Switches the gain off.  The joint becomes limp, and SetGoal() has no effect on it.
    void TurnOff(int joint);
    bool IsOff(int joint) const { return gain_[joint] == gainOFF; }

    // Switches the gain on again and moves the joint to `urad`.  The first vector commands the
    // joint to its measured position, and the gain is enabled when this vector has ended.
    // Otherwise the joint would jerk to its old set point (BBS 169, 642).
    void Wake(int joint, Sint32 urad);

    // Whether there is a vector to send: a joint moves, or a vector must be sent for its gain.
    bool IsBusy() const;
    bool IsMoving(int joint) const;

    // Advances all joints by one frame and writes their positions at its end.
    void Step(Sint32 urad[MAX_JOINTS]);
    Sint32 Position(int joint) const { return trajectory_[joint].Position(); }

    // Tell that command vector number `vector` was made, or has ended.  Numbers rise by one.
    void VectorMade(Sint32 vector);
    void VectorEnded(Sint32 vector);

private:
    enum Gain { gainOFF, gainON, gainWAITING };  // WAITING: until vector wakeVector_ has ended

    MoverPort* port_;
    const RobotConstants* robot_;
    Trajectory trajectory_[MAX_JOINTS];
    Gain gain_[MAX_JOINTS];
    Sint32 wakeVector_[MAX_JOINTS];  // -1: not made yet
    Sint32 wakeGoal_[MAX_JOINTS];
};

#endif  // JointSet_h_DEFINED
