//
// The legs of the ERS-210, and the postures of this example.
//

#ifndef LegTable_h_DEFINED
#define LegTable_h_DEFINED

#include <Types.h>

const int NUM_LEG_JOINTS = 12;

struct LegJoint {
    const char* locator;
    word gain[3];  // the standard gains P, I and D (Model Information ERS-210, 2.3)
};

// The joints of the left fore, left hind, right fore and right hind leg; for each leg J1 (swing),
// J2 (spread) and J3 (knee).
extern const LegJoint LEG_JOINTS[NUM_LEG_JOINTS];

struct Posture {
    const char* name;
    double degrees[NUM_LEG_JOINTS];  // in the order of LEG_JOINTS
    int numVectors;                  // duration of the movement to this posture, in vectors of 128
                                     // ms
};

const int NUM_POSTURES = 3;
extern const Posture POSTURES[NUM_POSTURES];

#endif  // LegTable_h_DEFINED
