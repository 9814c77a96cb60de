//
// Cuts a motion into command vectors: the play-back algorithm of Hohl 2004, section 4.1.2
// and table 4.2.
//
// The robot stands at key frame 0 when play-back begins.  A gap with interpolation count
// n lasts (n + 1) x 16 ms, in 2 (n + 1) frames of 8 ms on a straight line; the last frame
// of a gap is the next key frame itself, so the last key frame is reached exactly.
// Another loop begins with the first gap again, without a way back to key frame 0.
// Speed limits play no part.
//
// A vector holds as many whole gaps as fit, at most the number of key frames asked for, so
// that it ends at a key frame, where positions are measured; the last vector of a loop may
// be short.  Only a gap longer than a vector is split.
//

#ifndef MtnPlayer_h_DEFINED
#define MtnPlayer_h_DEFINED

#include "FixedTypes.h"
#include "MtnFile.h"

// Frames of a command vector (ocommandMAX_FRAMES, Level 2 Reference Guide 4.2.1).
const int MAX_VECTOR_FRAMES = 16;

// Two key frames without interpolation make a vector of 32 ms, the period of the sensor
// vectors; two vectors wait in the effector, so a stop acts within 64 ms.
const int DEFAULT_KEYFRAMES_PER_VECTOR = 2;

class MtnPlayer {
public:
    MtnPlayer();

    // Begins at key frame 0.  `motion` must stay until the end.  `loops` >= 1.  An uneven
    // number of key frames per vector is rounded down to the next even one, but not
    // below 2; more than 8 do not fit into a vector.
    void Start(const MtnFile* motion, int loops, int keyFramesPerVector);

    // Plays nothing more.
    void Stop() { motion_ = 0; }

    // False when there is no frame left.
    bool IsPlaying() const { return motion_ != 0; }

    // How many frames the next vector has: 1 to MAX_VECTOR_FRAMES; 0 when there is none.
    int FramesOfNextVector() const;

    // Advances one frame.  REQUIRES: IsPlaying().
    void NextFrame();

    // Position of the file's joint `j` in the frame NextFrame() advanced to, urad.
    Sint32 Position(int j) const;

    // The key frame reached last; 0 before the first.
    int KeyFrame() const { return keyFrame_; }

private:
    int FramesOfGap(int gap) const { return 2 * (motion_->Interpolation(gap) + 1); }
    void EndLoop();

    const MtnFile* motion_;  // 0: not playing
    const MtnFile* shown_;   // what Position() speaks of; outlives the last frame
    int loopsLeft_;          // this one included
    int keyFramesPerVector_;
    int gap_;    // being played: from key frame gap_ to gap_ + 1
    int frame_;  // of that gap: 0 before its first frame
    int shownGap_, shownFrame_;
    int keyFrame_;
};

#endif  // MtnPlayer_h_DEFINED
