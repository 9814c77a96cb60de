//
// The joints that Walker moves: those of the legs, the neck and the mouth.
//

#ifndef JointTable_h_DEFINED
#define JointTable_h_DEFINED

#include <Types.h>

#include "Leg.h"

// The joints of the legs come first, leg by leg in the order of LegName.
enum HeadJoint { NECK_TILT = NUM_LEG_JOINTS, NECK_PAN, NECK_ROLL, MOUTH, NUM_JOINTS };

struct Joint {
    const char* locator;
    word gain[3];  // the standard gains P, I and D (Model Information ERS-210, 2.3)
};

extern const Joint JOINTS[NUM_JOINTS];

#endif  // JointTable_h_DEFINED
