#include "Motion.h"

#include "Maths.h"

static const int RISE_FRAMES = 190;    // 1.5 s
static const double FALLEN_UP = -4.9;  // m/s^2; the dog leans by more than 60 degrees
static const double FEEL_PART = 0.06;  // weight of a new acceleration

// Speeds of the head, in rad a frame: 150 and 100 degrees/s.
static const double PAN_STEP = 150 * 0.008 * PI / 180;
static const double TILT_STEP = 100 * 0.008 * PI / 180;
static const double PAN_MAX = 85 * PI / 180;
static const double TILT_MIN = -75 * PI / 180;
static const double TILT_MAX = 40 * PI / 180;
static const double MOUTH_CLOSED = -3 * PI / 180;

// A posture on the way from lying to standing.
struct Move {
    double degrees[NUM_LEG_JOINTS];
    int numFrames;
};
static const int NUM_MOVES = 2;

// The moves of a dog that lies on its right side; mirrored, they are for the left side.  A search
// on the simulated dog found them: hundreds of random moves were tried, and the best ones changed
// until they worked from every position of the legs.
static const Move FROM_SIDE[NUM_MOVES] = {
    {{45, 69, -23, -45, 40, 2, -117, 38, 101, 110, 77, 105}, 75},
    {{72, 89, 113, -18, 63, 49, 63, 13, 107, 75, 58, 133}, 71}};

// The moves of a dog that stands on its nose.
static const Move FROM_NOSE[NUM_MOVES] = {
    {{109, 28, 38, 110, 37, 86, -113, 36, 100, -79, 44, -25}, 64},
    {{-106, 79, 82, -41, 76, 121, 56, 2, 10, -114, 44, 55}, 52}};
static const double ON_NOSE_FRONT = 7;  // m/s^2

Motion::Motion()
    : numFrames_(0), frame_(0), move_(NUM_MOVES), isOnNose_(false), isOnLeft_(false),
      isWalking_(false), front_(0), right_(0), up_(-9.8)
{
    const WalkCommand still = {0, 0, 0, 0, 0};
    command_ = still;
    for (int j = 0; j < NUM_JOINTS; j++) angle_[j] = 0;
    for (int j = 0; j < NUM_LEG_JOINTS; j++) from_[j] = to_[j] = 0;
}

void
Motion::Begin(const double now[NUM_JOINTS])
{
    for (int j = 0; j < NUM_JOINTS; j++) angle_[j] = now[j];
    move_ = NUM_MOVES;
    BeginNextMove();
}

void
Motion::Feel(double front, double right, double up)
{
    front_ += (front - front_) * FEEL_PART;
    right_ += (right - right_) * FEEL_PART;
    up_ += (up - up_) * FEEL_PART;
    if (!isWalking_ || up_ < FALLEN_UP) return;
    isWalking_ = false;
    move_ = 0;
    BeginNextMove();
}

void
Motion::Step(double angle[NUM_JOINTS])
{
    if (isWalking_) {
        StepWalk();
    } else {
        StepMove();
    }
    StepHead();
    for (int j = 0; j < NUM_JOINTS; j++) angle[j] = angle_[j];
}

// Begins the next move of getting up; after the last of them, the move to the first posture of the
// gait.
void
Motion::BeginNextMove()
{
    frame_ = 0;
    for (int j = 0; j < NUM_LEG_JOINTS; j++) from_[j] = angle_[j];
    if (move_ < NUM_MOVES) {
        BeginGetUp();
        return;
    }
    numFrames_ = RISE_FRAMES;
    gait_.Reset();
    for (int leg = 0; leg < NUM_LEGS; leg++) {
        FindLegAngles(leg, gait_.Paw(leg), to_ + leg * JOINTS_PER_LEG);
    }
}

void
Motion::BeginGetUp()
{
    if (move_ == 0) {
        isOnNose_ = front_ > ON_NOSE_FRONT;
        isOnLeft_ = right_ < 0;
    }
    const Move& move = isOnNose_ ? FROM_NOSE[move_] : FROM_SIDE[move_];
    numFrames_ = move.numFrames;
    for (int j = 0; j < NUM_LEG_JOINTS; j++) {
        const int from = isOnLeft_ ? (j + NUM_LEG_JOINTS / 2) % NUM_LEG_JOINTS : j;
        to_[j] = Rad(move.degrees[from]);
    }
}

// Goes on with the present move along a smooth curve, slow at both ends, so that the legs do not
// jerk.
void
Motion::StepMove()
{
    frame_++;
    const double t = (double)frame_ / numFrames_;
    const double part = t * t * (3 - 2 * t);
    for (int j = 0; j < NUM_LEG_JOINTS; j++) {
        angle_[j] = from_[j] + (to_[j] - from_[j]) * part;
    }
    if (frame_ < numFrames_) return;
    if (move_ == NUM_MOVES) {
        isWalking_ = true;
    } else {
        move_++;
        BeginNextMove();
    }
}

void
Motion::StepWalk()
{
    gait_.SetSpeed(command_.forward, command_.left, command_.turn);
    gait_.Step();
    for (int leg = 0; leg < NUM_LEGS; leg++) {
        FindLegAngles(leg, gait_.Paw(leg), angle_ + leg * JOINTS_PER_LEG);
    }
}

// Brings the head nearer to where it is to look; ahead while the dog gets up.
void
Motion::StepHead()
{
    const double pan = isWalking_ ? Limit(command_.headPan, -PAN_MAX, PAN_MAX) : 0;
    const double tilt = isWalking_ ? Limit(command_.headTilt, TILT_MIN, TILT_MAX) : 0;
    angle_[NECK_PAN] += Limit(pan - angle_[NECK_PAN], -PAN_STEP, PAN_STEP);
    angle_[NECK_TILT] += Limit(tilt - angle_[NECK_TILT], -TILT_STEP, TILT_STEP);
    angle_[NECK_ROLL] += Limit(-angle_[NECK_ROLL], -TILT_STEP, TILT_STEP);
    angle_[MOUTH] += Limit(MOUTH_CLOSED - angle_[MOUTH], -TILT_STEP, TILT_STEP);
}
