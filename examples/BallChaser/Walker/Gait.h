//
// The gait: a trot, in which two paws that lie crosswise stand while the other two swing.
//
// A paw that stands moves as the floor does, seen from the dog: against the dog's motion.  A paw
// that swings is lifted and brought so far ahead that its next way on the floor lies half before
// and half behind its middle place.
//
// The numbers in Gait.cc were found by trying some thousands on the simulated dog.  The dog then
// walks as fast as it is told, within a fifth, and sways by less than two degrees.
//

#ifndef Gait_h_DEFINED
#define Gait_h_DEFINED

#include "Leg.h"

class Gait {
public:
    Gait();

    // Puts all paws to their middle places, for a dog that begins to walk.
    void Reset();

    // Sets the speeds for the next frames, in mm/s and rad/s.  The gait takes them over gradually
    // and keeps within what the legs can do.
    void SetSpeed(double forward, double left, double turn);

    // Advances by one frame of 8 ms.
    void Step();

    const Place& Paw(int leg) const { return paw_[leg]; }

private:
    bool HasArrived() const;
    void ApproachSpeed();
    void StandPaw(int leg);
    void SwingPaw(int leg);

    double wantedForward_;
    double wantedLeft_;
    double wantedTurn_;
    double forward_;
    double left_;
    double turn_;
    int frame_;               // number of the frame within the present half step; 0 before it
    int swinging_;            // the pair of legs that swings
    Place paw_[NUM_LEGS];     // where the paws are
    Place lifted_[NUM_LEGS];  // where each paw was at the beginning of the half step
};

#endif  // Gait_h_DEFINED
