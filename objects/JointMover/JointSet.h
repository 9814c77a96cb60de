//
// JointSet: all joints of the robot, moved by the algorithm for commands of single joints
// (Trajectory.h).  The set stores the movement of each joint, and whether the gain of the joint is
// on.  A joint without gain is limp: its motor does not hold it.
//

#ifndef JointSet_h_DEFINED
#define JointSet_h_DEFINED

#include "MoverPort.h"
#include "RobotDescription.h"
#include "Trajectory.h"

class JointSet {
public:
    // Makes a set of joints.  `port` must outlive the set.
    explicit JointSet(MoverPort* port);

    // Puts every joint at rest at its measured position.  The limits of each joint become the
    // highest speed that `robot` has for this joint, and the default acceleration.  The gains of
    // all joints count as off, and motor power as on.
    void Begin(const RobotConstants* robot);

    int NumJoints() const { return robot_->numJoints; }
    void EnableAllGains();

    // Sets the goal of a joint, in urad (10^-6 rad).  A goal beyond a limit of the robot becomes
    // the limit.
    void SetGoal(int joint, Sint32 urad);
    // Sets the limit of speed of a joint, in 0.01 degree/s.  A value beyond a limit of the robot
    // becomes that limit.
    void SetSpeed(int joint, Sint32 cdeg);
    // Sets the limit of acceleration of a joint, in 0.01 degree/s^2.  A value beyond a limit of the
    // robot becomes that limit.
    void SetAcceleration(int joint, Sint32 cdeg);

    // Moves the joint to `urad` in `frames` frames, whatever its limits of speed and acceleration
    // are.  A position beyond the joint's range becomes the end of this range.
    void Track(int joint, Sint32 urad, int frames);

    // Puts the joint at rest at `urad`, because a motion has moved the joint to this position.
    void Place(int joint, Sint32 urad) { trajectory_[joint].Reset(urad); }
    // Stops the joint at the nearest position at which it can stop.  A joint that waits for its
    // gain stays where it is.
    void Halt(int joint);

    // Switches the gain of the joint off.  The joint becomes limp, and SetGoal() does not move it.
    void TurnOff(int joint);
    bool IsOff(int joint) const { return gain_[joint] == gainOFF; }

    // Switches the gain of the joint on again and moves the joint to `urad`.  The next vector
    // commands the joint to its measured position, and the gain is enabled when this vector has
    // ended.  Otherwise the joint would jerk to its old set point (BBS 169, 642).
    //
    // Wake() has no effect while motor power is off.
    void Wake(int joint, Sint32 urad);

    // Switches the gains of all joints off, and then motor power.
    void SwitchPowerOff();

    // Switches motor power on, and leaves the gains of all joints off.
    void SwitchPowerOn();
    bool HasPower() const { return hasPower_; }

    // Sets the P, I and D gain of the joint.  While the joint is off, the gains are only stored;
    // they are used when the joint is switched on.
    void SetGain(int joint, const Sint32 gain[3]);

    // Returns whether there is a command vector to send.  This is so if a joint moves, or if the
    // gain of a joint is to be switched on together with the next vector.
    bool IsBusy() const;
    // Returns whether the joint is not held at its goal yet, because it moves or waits for its
    // gain.
    bool IsMoving(int joint) const;
    // Returns whether the gain of the joint is to be switched on at the end of a command vector.
    bool IsWaiting(int joint) const { return gain_[joint] == gainWAITING; }

    // Advances all joints by one frame of 8 ms, and writes their positions at the end of the frame
    // to `urad`.
    void Step(Sint32 urad[MAX_JOINTS]);
    Sint32 Position(int joint) const { return trajectory_[joint].Position(); }

    // Records that command vector number `vector` was made, so that the gains of joints that are to
    // be switched on are enabled at the end of this vector.  The number of each vector is 1 more
    // than the number of the vector before.
    void VectorMade(Sint32 vector);

    // Switches on the gains of the joints that have waited for the end of command vector number
    // `vector`, and lets these joints move.
    void VectorEnded(Sint32 vector);

private:
    // The states of a joint's gain.  gainWAITING means that the gain is off until vector number
    // wakeVector_ has ended.
    enum Gain { gainOFF, gainON, gainWAITING };

    MoverPort* port_;
    const RobotConstants* robot_;
    Trajectory trajectory_[MAX_JOINTS];
    Gain gain_[MAX_JOINTS];
    Sint32 pid_[MAX_JOINTS][3];  // P, I and D gain of each joint
    bool hasPower_;
    // For each joint that waits for its gain (gainWAITING): the number of the command vector at
    // whose end the gain is enabled; -1 while this vector is not made yet.  Not used for other
    // joints.
    Sint32 wakeVector_[MAX_JOINTS];
    Sint32 wakeGoal_[MAX_JOINTS];
};

#endif  // JointSet_h_DEFINED
