//
// The states of JointMover (Hohl 2004, section 4.1.1 and figure 4.2).
//

#ifndef MoverState_h_DEFINED
#define MoverState_h_DEFINED

enum MoverState {
    moverFILLING,    // the first command vector holds what was measured
    moverGAINS,      // gains of all joints are enabled and set
    moverBROADBASE,  // on the way to the start-up postures, one after the other
    moverSLEEPING,
    moverCROUCHING,
    moverSTANDING,
    moverACCEPTING_COMMANDS,
    moverPREPARE_MTN,  // on the way to the first key frame of a motion
    moverMTN,          // playing it
    NUM_MOVER_STATES
};

// "accepting-commands" and so on; "unknown" for anything that is no state.
const char* MoverStateName(int state);

#endif  // MoverState_h_DEFINED
