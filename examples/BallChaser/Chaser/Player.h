//
// The player: it decides how to walk and where to look, picture by picture.
//
//   SEARCH     turns around until it sees the ball
//   APPROACH   walks to the ball
//   CIRCLE     walks around the ball until the goal is behind the ball
//   PUSH       walks on through the ball, towards the goal
//
// The player remembers where ball and goal were, and how it has moved since, so that it may look away.
//

#ifndef Player_h_DEFINED
#define Player_h_DEFINED

#include "Sight.h"
#include "WalkCommand.h"

class Player {
public:
    enum State { SEARCH, APPROACH, CIRCLE, PUSH };

    Player();

    void SetGoal(Goal goal) { goal_ = goal; }

    // Takes in what was seen in a picture, and decides.
    void See(const Sight& sight);

    const WalkCommand& Command() const { return command_; }
    State GetState() const { return state_; }

private:
    void Remember(const Sight& sight);
    void MoveMemory();
    void ChooseState();
    bool IsGoalBehindBall(double margin) const;
    void Search();
    void Approach();
    void Circle();
    void Push();
    double GoalDirection() const;
    void LookAt(double x, double y, double lowestTilt);

    Goal goal_;
    State state_;
    int numPictures_;    // pictures seen in the present state
    double searchSide_;  // side to which it turns while it searches: 1 left, -1 right
    double circleSide_;  // side to which it goes around the ball
    WalkCommand command_;

    double ballX_;  // mm
    double ballY_;
    double ballDistance_;
    double ballDirection_;  // rad
    int ballAge_;           // pictures since the ball was seen last
    double goalLeft_;       // rad; the directions of the goal's ends
    double goalRight_;
    int goalAge_;
};

#endif  // Player_h_DEFINED
