//
// All joints of the robot under the algorithm for manual commands: where each is on its
// way, and whether its gain is on.
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

    // Every joint at rest where it is measured, at the speed limit of its row in
    // RobotConstants and the default acceleration; gains are off.
    void Begin(const RobotConstants* robot);

    int NumJoints() const { return robot_->numJoints; }
    void EnableAllGains();

    // Values beyond the limits of the robot become the limit.
    void SetGoal(int joint, Sint32 urad);
    void SetSpeed(int joint, Sint32 cdeg);
    void SetAcceleration(int joint, Sint32 cdeg);

    // At rest at `urad` by other means (a motion has moved the joint).
    void Place(int joint, Sint32 urad) { trajectory_[joint].Reset(urad); }
    void Halt(int joint) { trajectory_[joint].Halt(); }

    // Gain off: the joint goes limp and position commands have no effect on it.
    void TurnOff(int joint);
    bool IsOff(int joint) const { return gain_[joint] == gainOFF; }

    // Gain on again, then to `urad`.  The joint must first be commanded to where it hangs,
    // or it would jerk to its old set point when the gain comes on (BBS 169, 642): the gain is
    // enabled when the first vector with that position has ended.
    void Wake(int joint, Sint32 urad);

    // Something is left to send: a joint moves or waits for its gain.
    bool IsBusy() const;
    bool IsMoving(int joint) const;

    // Positions at the end of the next frame.
    void Step(Sint32 urad[MAX_JOINTS]);
    Sint32 Position(int joint) const { return trajectory_[joint].Position(); }

    // Command vector number `vector` has been made, or has ended.  Numbers rise by one.
    void VectorMade(Sint32 vector);
    void VectorEnded(Sint32 vector);

private:
    enum Gain { gainOFF, gainON, gainWAITING };  // WAITING: for the end of wakeVector_

    MoverPort* port_;
    const RobotConstants* robot_;
    Trajectory trajectory_[MAX_JOINTS];
    Gain gain_[MAX_JOINTS];
    Sint32 wakeVector_[MAX_JOINTS];  // -1: not made yet
    Sint32 wakeGoal_[MAX_JOINTS];
};

#endif  // JointSet_h_DEFINED
