//
// Splits a motion into command vectors: the play-back algorithm of Hohl 2004, section 4.1.2 and
// table 4.2.
//
// The robot is at key frame 0 when play-back begins.  The gap between two key frames, with
// interpolation count n, lasts (n + 1) x 16 ms.  It is played in 2 (n + 1) frames of 8 ms on a
// straight line.  The last frame of a gap is the next key frame itself, so key frames are reached
// exactly.  Each further loop begins with the first gap again; there is no movement back to key
// frame 0.  Speed limits are ignored.
//
// A vector has as many whole gaps as fit, but no more than the number asked for.  So it ends at a
// key frame, where positions are measured.  The last vector of a loop may be short.  Only a gap
// that is longer than a vector is split.
//

#ifndef MtnPlayer_h_DEFINED
#define MtnPlayer_h_DEFINED

#include "FixedTypes.h"
#include "MtnFile.h"

// Frames of a command vector (ocommandMAX_FRAMES, Level 2 Reference Guide 4.2.1).
const int MAX_VECTOR_FRAMES = 16;

// Two key frames without interpolation make a vector of 32 ms, which is the period of the sensor
// vectors.  Two vectors are in the effector at any time, so a stop acts within 64 ms.
const int DEFAULT_KEYFRAMES_PER_VECTOR = 2;

class MtnPlayer {
public:
    MtnPlayer();

    // Begins at key frame 0.  `motion` must exist until the end.  REQUIRES: loops >= 1.  The number
    // of key frames per vector is rounded down to an even number from 2 to 8.
    void Start(const MtnFile* motion, int loops, int keyFramesPerVector);

    // Ends play-back at the present frame.
    void Stop() { motion_ = 0; }

    // Whether there is a frame left to play.
    bool IsPlaying() const { return motion_ != 0; }

    // How many frames the next vector has: 1 to MAX_VECTOR_FRAMES; 0 when there is none.
    int FramesOfNextVector() const;

    // Advances one frame.  REQUIRES: IsPlaying().
    void NextFrame();

    // Position of the file's joint `j` in the frame to which NextFrame() advanced, urad.
    Sint32 Position(int j) const;

    // The key frame reached last; 0 before the first.
    int KeyFrame() const { return keyFrame_; }

private:
    int FramesOfGap(int gap) const { return 2 * (motion_->Interpolation(gap) + 1); }
    void EndLoop();

    const MtnFile* motion_;  // 0: not playing
    const MtnFile* shown_;   // motion of Position(), also after the last frame
    int loopsLeft_;          // this one included
    int keyFramesPerVector_;
    int gap_;    // the gap that plays, from key frame gap_ to gap_ + 1
    int frame_;  // number of frames of the gap that were played
    int shownGap_, shownFrame_;  // gap and frame of Position()
    int keyFrame_;
};

#endif  // MtnPlayer_h_DEFINED
