#include "Trajectory.h"

#include "Angle.h"

static const Sint64 ONE_URAD = 65536;

// SPEED_SCALE_E6 / 10^6 converts a speed from 0.01 degree/s to 2^-16 urad per frame.
// ACCELERATION_SCALE_E6 / 10^6 converts an acceleration from 0.01 degree/s^2 to 2^-16 urad per
// frame^2.  A frame lasts 0.008 s, so 0.01 degree/s is 0.008 x 174.5 urad per frame, and 0.01
// degree/s^2 is 0.008 times as much per frame^2.  Both scales are rounded to the nearest integer.
static const Sint64 SPEED_SCALE_E6 = (URAD_PER_CDEG_E9 * ONE_URAD * 8 + 500000) / 1000000;
static const Sint64 ACCELERATION_SCALE_E6 = (SPEED_SCALE_E6 * 8 + 500) / 1000;
COMPILE_TIME_CHECK(SpeedScaleIsExact, SPEED_SCALE_E6 == 91505518287LL);
COMPILE_TIME_CHECK(AccelerationScaleIsExact, ACCELERATION_SCALE_E6 == 732044146LL);

Trajectory::Trajectory()
    : goal_(0), position_(0), speed_(0), speedLimit_(1), acceleration_(1), nextAcceleration_(1),
      trackFrames_(0)
{
}

void
Trajectory::Reset(Sint32 urad)
{
    goal_ = urad;
    Rest();
}

void
Trajectory::Rest()
{
    position_ = goal_ * ONE_URAD;
    speed_ = 0;
    acceleration_ = nextAcceleration_;
    trackFrames_ = 0;
}

void
Trajectory::SetSpeed(Sint32 speedCdeg)
{
    speedLimit_ = DivideRounded(speedCdeg * SPEED_SCALE_E6, 1000000);
}

void
Trajectory::SetAcceleration(Sint32 accelerationCdeg)
{
    nextAcceleration_ = DivideRounded(accelerationCdeg * ACCELERATION_SCALE_E6, 1000000);
    if (!IsMoving() || nextAcceleration_ > acceleration_) acceleration_ = nextAcceleration_;
}

void
Trajectory::SetGoal(Sint32 urad)
{
    goal_ = urad;
    trackFrames_ = 0;
}

void
Trajectory::Track(Sint32 urad, int frames)
{
    goal_ = urad;
    trackFrames_ = frames;
}

void
Trajectory::Halt()
{
    trackFrames_ = 0;
    if (!IsMoving()) return;
    const Sint64 ahead = speed_ >= 0 ? StoppingDistance(speed_) : -StoppingDistance(-speed_);
    goal_ = (Sint32)DivideRounded(position_ + ahead, ONE_URAD);
}

bool
Trajectory::IsMoving() const
{
    return speed_ != 0 || position_ != goal_ * ONE_URAD;
}

Sint32
Trajectory::Position() const
{
    return (Sint32)DivideRounded(position_, ONE_URAD);
}

// Returns the distance that the joint needs to stop if its speed in the present frame is `speed`
// and it brakes from the next frame on.  REQUIRES: speed >= 0.
Sint64
Trajectory::StoppingDistance(Sint64 speed) const
{
    const Sint64 n = speed / acceleration_;
    return n * speed - acceleration_ * n * (n + 1) / 2;
}

// Returns the whole part of the square root of `value`, by Newton's method.  The approximations
// begin above the root and fall to the root, so the search ends when they fall no more.
static Sint64
SquareRoot(Sint64 value)
{
    if (value < 2) return value;
    Sint64 root = value;
    Sint64 next = (root + 1) / 2;
    while (next < root) {
        root = next;
        next = (root + value / root) / 2;
    }
    return root;
}

// Returns the largest step s with s + StoppingDistance(s) <= distance.  A step is the distance that
// the joint moves in one frame.  While the joint brakes, each step is shorter than the step before
// by the acceleration a:
//
//   s + (s - a) + (s - 2 a) + ... + (s - n a)  =  (n + 1) s - a n (n + 1) / 2  =  distance
//
// If n is known, s follows: s = (distance + a n (n + 1) / 2) / (n + 1).  The number n of braking
// steps grows with the distance.  The joint brakes in exactly n steps, the last of them 0, if
// s = n a, which means distance = a n (n + 1) / 2.  So n is the largest whole number with
// a n (n + 1) / 2 <= distance.
// REQUIRES: distance >= 0.
Sint64
Trajectory::LargestStep(Sint64 distance) const
{
    // n is the largest number with n (n + 1) / 2 <= distance / acceleration_.  The division drops
    // the fraction, which changes nothing, because n (n + 1) / 2 is a whole number.
    const Sint64 n = (SquareRoot(8 * (distance / acceleration_) + 1) - 1) / 2;
    return (distance + acceleration_ * n * (n + 1) / 2) / (n + 1);
}

Sint32
Trajectory::Step()
{
    if (!IsMoving()) {
        acceleration_ = nextAcceleration_;
        trackFrames_ = 0;
        return goal_;
    }
    if (trackFrames_ > 0) {
        // Divides the remaining distance by the number of remaining frames, so that rounding errors
        // do not add up and the last frame ends at the goal.
        speed_ = DivideRounded(goal_ * ONE_URAD - position_, trackFrames_);
        position_ += speed_;
        if (--trackFrames_ == 0) Rest();
        return Position();
    }
    // Computes with a distance and a speed that are positive in the direction of the goal, so that
    // both directions share the code below.
    const Sint64 toGoal = goal_ * ONE_URAD - position_;
    const bool forward = toGoal >= 0;
    const Sint64 distance = forward ? toGoal : -toGoal;
    const Sint64 speed = forward ? speed_ : -speed_;

    Sint64 step = LargestStep(distance);
    if (step > speedLimit_) step = speedLimit_;
    if (step > speed + acceleration_) step = speed + acceleration_;
    // The joint slows down by acceleration_ at most.  So a joint that is too fast to stop at the
    // goal moves past the goal, and comes back later.
    if (step < speed - acceleration_) step = speed - acceleration_;
    position_ += forward ? step : -step;
    speed_ = forward ? step : -step;
    // Ends the movement if the joint has reached its goal and is slow enough to stop there.
    if (step == distance && step <= acceleration_) Rest();
    return Position();
}
