//
// The states of JointMover (Hohl 2004, section 4.1.1 and figure 4.2).
//

#ifndef MoverState_h_DEFINED
#define MoverState_h_DEFINED

enum MoverState {
    moverFILLING,    // the first command vector has the measured positions
    moverGAINS,      // gains of all joints are enabled and set
    moverBROADBASE,  // moves to the first start-up posture
    moverSLEEPING,   // moves to the second start-up posture
    moverCROUCHING,  // moves to the third start-up posture
    moverSTANDING,   // moves to the last start-up posture
    moverACCEPTING_COMMANDS,
    moverPREPARE_MTN,  // moves to the first key frame (posture) of a motion
    moverMTN,          // plays the motion
    NUM_MOVER_STATES
};

// Returns the name of a state, such as "accepting-commands"; "unknown" for other numbers.
const char* MoverStateName(int state);

#endif  // MoverState_h_DEFINED
