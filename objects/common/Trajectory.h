//
// Trajectory: the movement of one joint to its goal.  It gives one position per frame of 8 ms,
// within limits of speed and acceleration, and ends exactly at the goal.
//
// This is the "algorithm for manual commands" of Hohl 2004, section 4.1.1.  It is used for the
// start-up postures, for commands of the remote control and of controllers, and for the movement to
// the first key frame (posture) of a motion.  A new goal may be given at any time; the joint then
// continues with its present speed.
//
// Each frame takes the largest step after which the joint can still stop at the goal with its limit
// of acceleration.  So there is no stored plan that a new goal would make wrong.  Positions are in
// fixed point (2^-16 microradian) instead of floating point, so every compiler, word size and CPU
// computes the same frames.  Because no duration is computed, no duration can be rounded to zero
// frames (ers210.md 5, "Arithmetic trap").
//

#ifndef Trajectory_h_DEFINED
#define Trajectory_h_DEFINED

#include "FixedTypes.h"

class Trajectory {
public:
    Trajectory();

    // Puts the joint at rest at `urad` (10^-6 rad), which also becomes its goal.  The limits of
    // speed and acceleration stay.
    void Reset(Sint32 urad);

    // Sets the limit of speed, in 0.01 degree/s.  A joint that is faster slows down.  REQUIRES:
    // speedCdeg > 0.
    void SetSpeed(Sint32 speedCdeg);

    // Sets the limit of acceleration, in 0.01 degree/s^2.  While the joint moves, a lower limit is
    // used only after its next stop, because with the lower limit the joint could not stop at its
    // goal.  REQUIRES: accelerationCdeg > 0.
    void SetAcceleration(Sint32 accelerationCdeg);

    void SetGoal(Sint32 urad);

    // Moves the joint in a straight line to `urad`, whatever its limits of speed and acceleration
    // are.  The joint reaches `urad` after `frames` frames and rests there.  Another goal, or
    // Halt(), ends this movement; the joint then goes on with its present speed and within its
    // limits.  REQUIRES: frames > 0.
    void Track(Sint32 urad, int frames);

    // Stops the joint: sets its goal to the nearest position at which it can stop.
    void Halt();

    // Advances the joint by one frame and returns its position at the end of the frame, in urad.
    Sint32 Step();

    // Returns the joint's position at the end of the newest frame, in urad.
    Sint32 Position() const;

    Sint32 Goal() const { return goal_; }

    // Returns whether the joint moves or is not at its goal.
    bool IsMoving() const;

private:
    Sint64 LargestStep(Sint64 distance) const;
    Sint64 StoppingDistance(Sint64 speed) const;
    void Rest();

    Sint32 goal_;              // goal of the movement, in urad
    Sint64 position_;          // position of the joint, in 2^-16 urad
    Sint64 speed_;             // speed of the joint, in 2^-16 urad per frame
    Sint64 speedLimit_;        // limit of speed, in 2^-16 urad per frame, > 0
    Sint64 acceleration_;      // limit of acceleration, in 2^-16 urad per frame^2, > 0
    Sint64 nextAcceleration_;  // limit of acceleration after the next stop
    // Number of frames that are left of a movement by Track(), which ignores the limits of speed
    // and acceleration; 0 if there is no such movement.
    int trackFrames_;
};

#endif  // Trajectory_h_DEFINED
