//
// The command of Chaser to Walker: how the dog is to walk, and where it is to look.
//

#ifndef WalkCommand_h_DEFINED
#define WalkCommand_h_DEFINED

struct WalkCommand {
    double forward;   // mm/s
    double left;      // mm/s
    double turn;      // rad/s, counterclockwise seen from above
    double headPan;   // rad, positive to the left
    double headTilt;  // rad, positive up
};

#endif  // WalkCommand_h_DEFINED
