//
// The motion of the whole dog: it computes the angles of all joints, frame by frame.
//
// The dog rises first, then walks as it is told.  When it has fallen over, it gets up again and
// walks on.
//

#ifndef Motion_h_DEFINED
#define Motion_h_DEFINED

#include "Gait.h"
#include "JointTable.h"
#include "WalkCommand.h"

class Motion {
public:
    Motion();

    // Begins to rise.  `now` has the present angles of the joints in rad.
    void Begin(const double now[NUM_JOINTS]);

    void SetCommand(const WalkCommand& command) { command_ = command; }

    // Takes note of the accelerations towards the front, the right and up, in m/s^2, once in every
    // 32 ms.  A dog that stands has about -9.8 up.
    void Feel(double front, double right, double up);

    // Advances by one frame and computes its angles, in rad.
    void Step(double angle[NUM_JOINTS]);

    bool IsWalking() const { return isWalking_; }

private:
    void BeginNextMove();
    void BeginGetUp();
    void StepMove();
    void StepWalk();
    void StepHead();

    Gait gait_;
    WalkCommand command_;
    double angle_[NUM_JOINTS];     // rad; of the last frame
    double from_[NUM_LEG_JOINTS];  // rad; angles of the legs at the beginning of the present move
    double to_[NUM_LEG_JOINTS];    // rad; angles of the legs at its end
    int numFrames_;                // length of the present move
    int frame_;                    // frames of the present move that are over
    int move_;                     // the present move of getting up; NUM_MOVES: the dog rises
    bool isOnNose_;                // how the dog lay when it began to get up
    bool isOnLeft_;
    bool isWalking_;  // whether the gait moves the legs
    double front_;    // smoothed accelerations, m/s^2
    double right_;
    double up_;
};

#endif  // Motion_h_DEFINED
