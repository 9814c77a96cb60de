//
// The joints of the ERS-210 that have a sensor, with names for people.
//

#ifndef JointTable_h_DEFINED
#define JointTable_h_DEFINED

const int NUM_JOINTS = 18;

struct JointName {
    const char* name;
    const char* locator;
};

extern const JointName JOINTS[NUM_JOINTS];

#endif  // JointTable_h_DEFINED
