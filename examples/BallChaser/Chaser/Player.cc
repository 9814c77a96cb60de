#include "Player.h"

#include "Maths.h"

static const double PICTURE_S = 0.04;
static const int SECOND = 25;  // pictures
static const int NEVER = 1000000;

// Lengths in mm, speeds in mm/s and rad/s.
static const double SLIP = 0.85;  // the way that the dog walks, of the way that it is told
static const double FORWARD = 220;
static const double SIDEWAYS = 110;
static const double SEARCH_TURN = 0.9;
static const double TURN_GAIN = 2;  // rad/s for each rad that the ball is beside the middle
static const double CIRCLE_RADIUS = 400;
static const double BEHIND_MARGIN = 0.06;  // rad

// The longest time around the ball, which is a whole circle; then the dog pushes it anywhere.
static const int CIRCLE_LONGEST = 25 * SECOND;
// The longest push without a look at the goal.
static const int PUSH_BLIND = 5 * SECOND;

// Where the head looks: a little down, so that both ball and goal are in the picture; or at the
// floor before the paws.
static const double TILT_AHEAD = -0.2;
static const double TILT_NEAR = -0.7;
static const double TILT_PAWS = -1.2;

// The axis about which the neck pans, in mm: before the dog's middle, and above a ball's middle.
static const double NECK_X = 75;
static const double NECK_ABOVE_BALL = 150;

Player::Player()
    : goal_(SKY_BLUE_GOAL), state_(SEARCH), numPictures_(0), searchSide_(1), circleSide_(1),
      ballX_(1000), ballY_(0), ballDistance_(1000), ballDirection_(0), ballAge_(NEVER),
      goalLeft_(0), goalRight_(0), goalAge_(NEVER)
{
    const WalkCommand still = {0, 0, 0, 0, 0};
    command_ = still;
}

void
Player::See(const Sight& sight)
{
    MoveMemory();
    Remember(sight);
    const State before = state_;
    ChooseState();
    numPictures_ = state_ == before ? numPictures_ + 1 : 0;
    if (state_ != SEARCH) searchSide_ = ballY_ < 0 ? -1 : 1;
    switch (state_) {
    case SEARCH:
        Search();
        break;
    case APPROACH:
        Approach();
        break;
    case CIRCLE:
        Circle();
        break;
    case PUSH:
        Push();
        break;
    }
}

// Moves what the player remembers as the dog has moved since the last picture: the other way.
void
Player::MoveMemory()
{
    const double turn = command_.turn * PICTURE_S;
    const double x = ballX_ - command_.forward * SLIP * PICTURE_S;
    const double y = ballY_ - command_.left * SLIP * PICTURE_S;
    ballX_ = x * Cos(turn) + y * Sin(turn);
    ballY_ = y * Cos(turn) - x * Sin(turn);
    goalLeft_ = WrapAngle(goalLeft_ - turn);
    goalRight_ = WrapAngle(goalRight_ - turn);
    ballAge_++;
    goalAge_++;
}

void
Player::Remember(const Sight& sight)
{
    if (sight.ball.isSeen) {
        ballX_ = sight.ball.x;
        ballY_ = sight.ball.y;
        ballAge_ = 0;
    }
    ballDistance_ = sqrt(ballX_ * ballX_ + ballY_ * ballY_);
    ballDirection_ = ArcTan2(ballY_, ballX_);
    const GoalSight& goal = sight.goal[goal_];
    if (goal.isSeen) {
        goalLeft_ = goal.left;
        goalRight_ = goal.right;
        goalAge_ = 0;
    }
    // When the goal was not seen for 2 s, takes it for opposite to our own, so that the dog circles
    // the shorter way.  goalAge_ stays, because this is too rough to push by.
    const GoalSight& own = sight.goal[goal_ == YELLOW_GOAL ? SKY_BLUE_GOAL : YELLOW_GOAL];
    if (own.isSeen && goalAge_ > 2 * SECOND) {
        goalLeft_ = WrapAngle(own.left + PI);
        goalRight_ = WrapAngle(own.right + PI);
    }
}

// Returns whether a ball that is pushed straight ahead would go into the goal, with `margin` rad
// to spare on both sides.
bool
Player::IsGoalBehindBall(double margin) const
{
    return goalAge_ < 2 * SECOND && WrapAngle(goalLeft_ - ballDirection_) > margin &&
           WrapAngle(ballDirection_ - goalRight_) > margin;
}

// Returns the direction of the goal's middle.
double
Player::GoalDirection() const
{
    return WrapAngle(goalRight_ + WrapAngle(goalLeft_ - goalRight_) / 2);
}

void
Player::ChooseState()
{
    const bool isBallKnown = ballAge_ < SECOND;
    switch (state_) {
    case SEARCH:
        if (ballAge_ == 0) state_ = APPROACH;
        break;
    case APPROACH:
        if (!isBallKnown) {
            state_ = SEARCH;
        } else if (ballDistance_ < CIRCLE_RADIUS + 50) {
            state_ = CIRCLE;
        }
        break;
    case CIRCLE:
        if (!isBallKnown) {
            state_ = SEARCH;
        } else if (numPictures_ > CIRCLE_LONGEST ||
                   (ballAge_ < 5 && IsGoalBehindBall(BEHIND_MARGIN))) {
            state_ = PUSH;
        } else if (ballDistance_ > CIRCLE_RADIUS + 200) {
            state_ = APPROACH;
        }
        break;
    case PUSH:
        if (ballAge_ > 2 * SECOND) {
            state_ = SEARCH;
        } else if (ballAge_ == 0 && ballDistance_ > 250 && goalAge_ < SECOND &&
                   !IsGoalBehindBall(-0.2)) {
            state_ = APPROACH;
        } else if (goalAge_ > PUSH_BLIND && numPictures_ > PUSH_BLIND) {
            state_ = CIRCLE;
        }
        break;
    }
}

// First walks backward for 0.6 s and looks at the floor before the paws, because a ball that was
// lost is mostly too near to be seen.  Then turns towards the side where the ball was last, with the
// head down and ahead in turn.
void
Player::Search()
{
    const bool isDown = numPictures_ / 15 % 2 == 0;
    command_.forward = 0;
    command_.left = 0;
    command_.turn = searchSide_ * SEARCH_TURN;
    command_.headPan = 0;
    command_.headTilt = isDown ? TILT_NEAR : TILT_AHEAD;
    if (numPictures_ < 15) {
        command_.forward = -100;
        command_.turn = 0;
        command_.headTilt = TILT_PAWS;
    }
}

void
Player::Approach()
{
    const double speed = Limit(ballDistance_ - CIRCLE_RADIUS, 60, FORWARD);
    command_.forward = speed * Limit(Cos(ballDirection_), 0, 1);
    command_.left = 0;
    command_.turn = TURN_GAIN * ballDirection_;
    LookAt(ballX_, ballY_, TILT_PAWS);
}

// Walks sideways around the ball, to the side from which the goal comes behind it.  Without a goal
// in sight it goes on to one side, until it sees the goal.
void
Player::Circle()
{
    const double beside = WrapAngle(GoalDirection() - ballDirection_);
    double speed = SIDEWAYS;
    if (goalAge_ < SECOND) speed = Limit(400 * fabs(beside), 40, SIDEWAYS);
    if (goalAge_ < SECOND || numPictures_ == 0) circleSide_ = beside > 0 ? -1 : 1;
    command_.left = circleSide_ * speed;
    command_.forward = 1.5 * (ballDistance_ - CIRCLE_RADIUS);
    command_.turn = TURN_GAIN * ballDirection_ - command_.left * SLIP / CIRCLE_RADIUS;
    LookAt(ballX_, ballY_, TILT_AHEAD);
}

// Walks on, so that the ball stays before the chest and the dog turns to the goal.  Looks ahead,
// and now and then at the ball.
void
Player::Push()
{
    command_.forward = FORWARD;
    command_.left = Limit(1.5 * ballY_, -80, 80);
    command_.turn = goalAge_ < 5 * SECOND ? Limit(GoalDirection(), -0.4, 0.4) : 0;
    if (ballAge_ < SECOND) {
        LookAt(ballX_, ballY_, TILT_AHEAD - 0.1);
    } else {
        LookAt(ballX_, ballY_, TILT_PAWS);
    }
}

// Turns the head to a ball at the place x, y, but not farther down than `lowestTilt`.
void
Player::LookAt(double x, double y, double lowestTilt)
{
    const double ahead = x - NECK_X;
    command_.headTilt = Limit(-ArcTan2(NECK_ABOVE_BALL, ahead), lowestTilt, 0);
    command_.headPan = ArcTan2(y, sqrt(ahead * ahead + NECK_ABOVE_BALL * NECK_ABOVE_BALL));
}
