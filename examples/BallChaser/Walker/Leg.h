//
// A leg of the ERS-210 and its inverse kinematics: from the place of the paw to three angles.
//

#ifndef Leg_h_DEFINED
#define Leg_h_DEFINED

// A place in the dog's own frame, in millimetres: x forward, y to the left, z up.  The origin lies
// in the middle between the four shoulders.
struct Place {
    double x;
    double y;
    double z;
};

const int NUM_LEGS = 4;
const int JOINTS_PER_LEG = 3;  // J1 swings the leg, J2 spreads it, J3 bends the knee
const int NUM_LEG_JOINTS = NUM_LEGS * JOINTS_PER_LEG;

// The order of the legs in all tables.
enum LegName { LEFT_FORE, LEFT_HIND, RIGHT_FORE, RIGHT_HIND };

inline bool
IsFore(int leg)
{
    return leg == LEFT_FORE || leg == RIGHT_FORE;
}

inline bool
IsLeft(int leg)
{
    return leg == LEFT_FORE || leg == LEFT_HIND;
}

// Computes the angles of J1, J2 and J3, in radians, that bring the centre of the paw to `paw`.  A
// place that the leg cannot reach gives the nearest angles within the limits of the joints.
void FindLegAngles(int leg, const Place& paw, double angle[JOINTS_PER_LEG]);

#endif  // Leg_h_DEFINED
