//
// Splits a motion into command vectors: the play-back algorithm of Hohl 2004, section 4.1.2 and
// table 4.2.
//
// A motion is a sequence of key frames (postures); a gap is the time between two of them.  The
// robot is at key frame 0 when play-back begins.  A gap with interpolation count n lasts (n + 1) x
// 16 ms.  It is played as a straight line in 2 (n + 1) frames of 8 ms.  The last frame of a gap is
// the next key frame itself, so key frames are reached exactly.  Each further loop begins at once
// with the first gap: there is no movement from the last key frame back to key frame 0.  Speed
// limits are ignored.
//
// A vector has as many whole gaps as fit, but no more than `keyFramesPerVector` (Start()).  So a
// vector ends at a key frame, where positions are measured.  The last vector of a loop may be
// short.  Only a gap that is longer than a vector is split.
//

#ifndef MtnPlayer_h_DEFINED
#define MtnPlayer_h_DEFINED

#include "FixedTypes.h"
#include "MtnFile.h"

// Maximum number of frames of a command vector (ocommandMAX_FRAMES, Level 2 Reference Guide 4.2.1).
const int MAX_VECTOR_FRAMES = 16;

// Number of key frames per vector when no number is given.  A key frame without interpolation lasts
// two frames of 8 ms, so two such key frames make a vector of 32 ms, which is the period of the
// sensor vectors.  JointMover sends the next vector while a vector plays, so that the effector has
// two vectors at a time.  So a stop acts within 64 ms.
const int DEFAULT_KEYFRAMES_PER_VECTOR = 2;

class MtnPlayer {
public:
    MtnPlayer();

    // Starts playing `motion` from key frame 0.  `motion` must exist until play-back has ended.
    // `keyFramesPerVector` is rounded down to an even number and limited to 2 to 8.  REQUIRES:
    // loops >= 1.
    void Start(const MtnFile* motion, int loops, int keyFramesPerVector);

    // Ends the play-back of the motion at the present frame.
    void Stop() { motion_ = 0; }

    // Returns whether the motion has a frame that is left to play.
    bool IsPlaying() const { return motion_ != 0; }

    // Returns the number of frames of the motion's next command vector: 1 to MAX_VECTOR_FRAMES; 0
    // when play-back has ended.
    int FramesOfNextVector() const;

    // Advances play-back by one frame of 8 ms.  REQUIRES: IsPlaying().
    void NextFrame();

    // Returns the position of the file's joint `j` in the frame to which NextFrame() advanced, in
    // urad (10^-6 rad).
    Sint32 Position(int j) const;

    // Returns the index of the key frame that the motion has reached last; 0 at the beginning.
    int KeyFrame() const { return keyFrame_; }

private:
    int FramesOfGap(int gap) const { return 2 * (motion_->Interpolation(gap) + 1); }
    void EndLoop();

    const MtnFile* motion_;  // motion that plays; 0 if no motion plays
    const MtnFile* shown_;   // motion that Position() shows, also after the last frame
    int loopsLeft_;          // number of loops that are not over yet, including the present loop
    int keyFramesPerVector_;
    int gap_;    // index of the gap that plays, from key frame gap_ to gap_ + 1
    int frame_;  // number of frames of the gap gap_ that were played
    int shownGap_, shownFrame_;  // gap and frame that Position() shows
    int keyFrame_;
};

#endif  // MtnPlayer_h_DEFINED
