//
// The eyes: they find the ball and the goals in a picture of layer C.
//
// This part of BallEyes knows nothing of OPEN-R, so that it can be tested with pictures in memory.
//

#ifndef Eyes_h_DEFINED
#define Eyes_h_DEFINED

#include "Blob.h"
#include "Look.h"
#include "Sight.h"

// The bits of the colours in a pixel: those of the channels 0 to 3 of the colour detection.
enum ColourBit { ORANGE = 0x01, SKY_BLUE = 0x02, PINK = 0x04, YELLOW = 0x08 };

class Eyes {
public:
    // Looks at a picture that was taken while the neck had these angles, in rad.  `pixels` has
    // width * height bytes, row by row.
    Sight See(const byte* pixels, int width, int height, double tilt, double pan);

private:
    BallSight FindBall(const Look& look);
    GoalSight FindGoal(ColourBit colour, const Look& look);
    bool IsOnBeacon(const Blob& blob) const;

    BlobFinder finder_;
    const byte* pixels_;  // the present picture
    int width_;
    int height_;
};

#endif  // Eyes_h_DEFINED
