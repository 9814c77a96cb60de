#include "Gait.h"

#include "Maths.h"

static const double FRAME_S = 0.008;
static const int HALF_STEP = 22;  // frames in which one pair of legs swings
static const double HALF_STEP_S = HALF_STEP * FRAME_S;

static const double FORWARD_MAX = 250;  // mm/s
static const double LEFT_MAX = 120;     // mm/s
static const double TURN_MAX = 2;       // rad/s
static const double SPEED_UP = 400;     // mm/s in a second
static const double TURN_SPEED_UP = 7;  // rad/s in a second
static const double CLOSE = 3;          // mm; a paw so near to its middle place may stay there

// The middle places of the left paws.  Those of the right paws are their mirror images.
static const Place FORE_MIDDLE = {108, 80, -85};
static const Place HIND_MIDDLE = {-66, 64, -88};
static const double FORE_LIFT = 15;  // mm
static const double HIND_LIFT = 18;

static Place
MiddleOf(int leg)
{
    Place middle = IsFore(leg) ? FORE_MIDDLE : HIND_MIDDLE;
    if (!IsLeft(leg)) middle.y = -middle.y;
    return middle;
}

// Returns `value`, brought nearer to `wanted` by at most `step`.
static double
Approach(double value, double wanted, double step)
{
    return value + Limit(wanted - value, -step, step);
}

static bool
IsClose(double a, double b)
{
    return a - b < CLOSE && b - a < CLOSE;
}

Gait::Gait()
{
    SetSpeed(0, 0, 0);
    Reset();
}

void
Gait::Reset()
{
    forward_ = 0;
    left_ = 0;
    turn_ = 0;
    frame_ = 0;
    swinging_ = 0;
    for (int leg = 0; leg < NUM_LEGS; leg++) {
        paw_[leg] = MiddleOf(leg);
        lifted_[leg] = paw_[leg];
    }
}

void
Gait::SetSpeed(double forward, double left, double turn)
{
    wantedForward_ = Limit(forward, -FORWARD_MAX, FORWARD_MAX);
    wantedLeft_ = Limit(left, -LEFT_MAX, LEFT_MAX);
    wantedTurn_ = Limit(turn, -TURN_MAX, TURN_MAX);
}

void
Gait::Step()
{
    ApproachSpeed();
    if (frame_ == 0) {
        if (HasArrived()) return;
        for (int leg = 0; leg < NUM_LEGS; leg++) lifted_[leg] = paw_[leg];
    }
    frame_++;
    for (int leg = 0; leg < NUM_LEGS; leg++) {
        const int pair = IsFore(leg) == IsLeft(leg) ? 0 : 1;
        if (pair == swinging_) {
            SwingPaw(leg);
        } else {
            StandPaw(leg);
        }
    }
    if (frame_ == HALF_STEP) {
        frame_ = 0;
        swinging_ = 1 - swinging_;
    }
}

// Returns whether the dog is to stand still and all paws are where they belong then.
bool
Gait::HasArrived() const
{
    if (wantedForward_ != 0 || wantedLeft_ != 0 || wantedTurn_ != 0) return false;
    for (int leg = 0; leg < NUM_LEGS; leg++) {
        const Place middle = MiddleOf(leg);
        if (!IsClose(paw_[leg].x, middle.x) || !IsClose(paw_[leg].y, middle.y)) return false;
    }
    return true;
}

void
Gait::ApproachSpeed()
{
    forward_ = Approach(forward_, wantedForward_, SPEED_UP * FRAME_S);
    left_ = Approach(left_, wantedLeft_, SPEED_UP * FRAME_S);
    turn_ = Approach(turn_, wantedTurn_, TURN_SPEED_UP * FRAME_S);
}

void
Gait::StandPaw(int leg)
{
    Place& paw = paw_[leg];
    const double x = paw.x;
    const double y = paw.y;
    paw.x -= (forward_ - turn_ * y) * FRAME_S;
    paw.y -= (left_ + turn_ * x) * FRAME_S;
    paw.z = MiddleOf(leg).z;
}

void
Gait::SwingPaw(int leg)
{
    const Place middle = MiddleOf(leg);
    const Place& from = lifted_[leg];
    const double toX = middle.x + (forward_ - turn_ * middle.y) * HALF_STEP_S / 2;
    const double toY = middle.y + (left_ + turn_ * middle.x) * HALF_STEP_S / 2;
    const double part = (double)frame_ / HALF_STEP;
    const double smooth = part * part * (3 - 2 * part);
    const double lift = IsFore(leg) ? FORE_LIFT : HIND_LIFT;
    paw_[leg].x = from.x + (toX - from.x) * smooth;
    paw_[leg].y = from.y + (toY - from.y) * smooth;
    paw_[leg].z = middle.z + lift * Sin(PI * part);
}
