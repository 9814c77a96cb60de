//
// The way of one joint to its goal: one position per 8 ms frame, inside a speed and an
// acceleration limit, ending exactly at the goal.
//
// This is the "algorithm for manual commands" of Hohl 2004, section 4.1.1: used for the
// start-up postures, for commands of the remote control and of controllers, and for the
// way to the first key frame of a motion.  A new goal may be given at any time; the
// joint goes on from the speed it has.
//
// Each frame takes the largest step from which the joint can still stop at the goal with
// the acceleration limit, so no plan is stored and none can go stale.  Fixed point
// (2^-16 micro-radian) instead of floating point: the same frames on every compiler,
// word size and CPU.  A duration is never computed, hence nothing is truncated to zero
// frames (ers210.md 5, "Arithmetic trap").
//

#ifndef Trajectory_h_DEFINED
#define Trajectory_h_DEFINED

#include "FixedTypes.h"

class Trajectory {
public:
    Trajectory();

    // At rest at `urad`, which is the goal, too.  Limits stay.
    void Reset(Sint32 urad);

    // 0.01 degree/s, > 0.  A limit below the speed the joint has slows it down.
    void SetSpeed(Sint32 speedCdeg);

    // 0.01 degree/s^2, > 0.  A lower limit given on the way counts from the next rest:
    // with it the joint could run past its goal, perhaps past its mechanical limit.
    void SetAcceleration(Sint32 accelerationCdeg);

    void SetGoal(Sint32 urad);

    // Makes the nearest place where the joint can stop its goal.
    void Halt();

    // Advances one frame and returns the position at its end, in urad.
    Sint32 Step();

    // The position at the end of the last frame, in urad.
    Sint32 Position() const;

    Sint32 Goal() const { return goal_; }

    // False at rest at the goal.
    bool IsMoving() const;

private:
    Sint64 LargestStep(Sint64 distance) const;
    Sint64 StoppingDistance(Sint64 speed) const;
    void Rest();

    Sint32 goal_;              // urad
    Sint64 position_;          // 2^-16 urad
    Sint64 speed_;             // 2^-16 urad per frame
    Sint64 speedLimit_;        // same unit, > 0
    Sint64 acceleration_;      // 2^-16 urad per frame^2, > 0
    Sint64 nextAcceleration_;  // in force from the next rest
};

#endif  // Trajectory_h_DEFINED
