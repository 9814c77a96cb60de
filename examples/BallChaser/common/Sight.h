//
// The things that BallEyes has seen in one picture.  BallEyes sends them to Chaser.
//
// Places are on the floor, in mm from the dog's middle: x forward, y to the left.  Directions are
// in rad from straight ahead, positive to the left.
//

#ifndef Sight_h_DEFINED
#define Sight_h_DEFINED

#include <Types.h>

enum Goal { SKY_BLUE_GOAL, YELLOW_GOAL, NUM_GOALS };

struct BallSight {
    slongword isSeen;   // 0 or 1; without a ball the other fields mean nothing
    slongword padding;  // 0; without this field the compiler would leave 4 bytes of a message unset
    double x;
    double y;
};

struct GoalSight {
    slongword isSeen;
    slongword padding;
    double left;   // direction of the left end of what is seen of the goal
    double right;  // direction of its right end
};

struct Sight {
    BallSight ball;
    GoalSight goal[NUM_GOALS];
};

#endif  // Sight_h_DEFINED
