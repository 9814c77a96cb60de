#include "MoverState.h"

const char*
MoverStateName(int state)
{
    static const char* const NAMES[NUM_MOVER_STATES] = {
        "filling",   "gains",    "broadbase",          "sleeping",
        "crouching", "standing", "accepting-commands", "prepare-mtn",
        "mtn"
    };
    return state >= 0 && state < NUM_MOVER_STATES ? NAMES[state] : "unknown";
}
