#include "Eyes.h"

#include "Maths.h"

static const double BALL_RADIUS = 43;  // mm
static const int FEWEST_BALL_PIXELS = 3;
static const int FEWEST_GOAL_COLUMNS = 12;

Sight
Eyes::See(const byte* pixels, int width, int height, double tilt, double pan)
{
    pixels_ = pixels;
    width_ = width;
    height_ = height;
    const Look look(tilt, pan, width, height);
    Sight sight;
    sight.ball = FindBall(look);
    sight.goal[SKY_BLUE_GOAL] = FindGoal(SKY_BLUE, look);
    sight.goal[YELLOW_GOAL] = FindGoal(YELLOW, look);
    return sight;
}

BallSight
Eyes::FindBall(const Look& look)
{
    BallSight ball = {0, 0, 0, 0};
    const Blob blob = finder_.FindLargest(pixels_, width_, height_, ORANGE);
    if (blob.numPixels < FEWEST_BALL_PIXELS) return ball;
    ball.isSeen = look.FindPlace(look.RayOf(blob.x, blob.y), BALL_RADIUS, &ball.x, &ball.y);
    return ball;
}

// Finds the ends of a goal.  Two beacons have its colour, too, but they are narrow or have pink
// beside it.  While a beacon is the largest blob of the colour, no goal is seen.
GoalSight
Eyes::FindGoal(ColourBit colour, const Look& look)
{
    GoalSight goal = {0, 0, 0, 0};
    const Blob blob = finder_.FindLargest(pixels_, width_, height_, colour);
    if (blob.right - blob.left + 1 < FEWEST_GOAL_COLUMNS || IsOnBeacon(blob)) return goal;
    const Ray left = look.RayOf(blob.left, blob.y);
    const Ray right = look.RayOf(blob.right + 1, blob.y);
    goal.isSeen = 1;
    goal.left = ArcTan2(left.y, left.x);
    goal.right = ArcTan2(right.y, right.x);
    return goal;
}

// Returns whether there is pink right above or below the blob.
bool
Eyes::IsOnBeacon(const Blob& blob) const
{
    const int x = (int)blob.x;
    int numPink = 0;
    for (int d = 1; d <= 3; d++) {
        const int above = blob.top - d;
        const int below = blob.bottom + d;
        if (above >= 0 && (pixels_[above * width_ + x] & PINK)) numPink++;
        if (below < height_ - 1 && (pixels_[below * width_ + x] & PINK)) numPink++;
    }
    return numPink >= 2;
}
