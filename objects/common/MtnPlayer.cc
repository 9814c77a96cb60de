#include "MtnPlayer.h"

#include "Angle.h"

MtnPlayer::MtnPlayer()
    : motion_(0),
      shown_(0),
      loopsLeft_(0),
      keyFramesPerVector_(DEFAULT_KEYFRAMES_PER_VECTOR),
      gap_(0),
      frame_(0),
      shownGap_(0),
      shownFrame_(0),
      keyFrame_(0)
{
}

void
MtnPlayer::Start(const MtnFile* motion, int loops, int keyFramesPerVector)
{
    shown_ = motion;
    // Plays nothing if there is a single key frame, because a motion is played gap by gap, and a
    // gap is the time between two key frames.
    motion_ = motion->NumKeyFrames() > 1 ? motion : 0;
    loopsLeft_ = loops;
    keyFramesPerVector_ = Clamp(keyFramesPerVector / 2 * 2, 2, MAX_VECTOR_FRAMES / 2);
    gap_ = frame_ = 0;
    shownGap_ = shownFrame_ = 0;
    keyFrame_ = 0;
}

int
MtnPlayer::FramesOfNextVector() const
{
    if (motion_ == 0) return 0;
    const int numGaps = motion_->NumKeyFrames() - 1;
    int frames = FramesOfGap(gap_) - frame_;
    if (frames > MAX_VECTOR_FRAMES) return MAX_VECTOR_FRAMES;
    for (int i = 1; i < keyFramesPerVector_ && gap_ + i < numGaps; i++) {
        if (frames + FramesOfGap(gap_ + i) > MAX_VECTOR_FRAMES) break;
        frames += FramesOfGap(gap_ + i);
    }
    return frames;
}

void
MtnPlayer::NextFrame()
{
    frame_++;
    // Keeps gap and frame for Position(), because at a key frame this function moves gap_ and
    // frame_ on to the next gap, or to the next loop.
    shownGap_ = gap_;
    shownFrame_ = frame_;
    if (frame_ < FramesOfGap(gap_)) return;
    frame_ = 0;
    gap_++;
    keyFrame_ = gap_;
    if (gap_ == motion_->NumKeyFrames() - 1) EndLoop();
}

void
MtnPlayer::EndLoop()
{
    gap_ = 0;
    if (--loopsLeft_ == 0) motion_ = 0;
}

Sint32
MtnPlayer::Position(int j) const
{
    const Sint32 from = shown_->Angle(shownGap_, j);
    if (shownFrame_ == 0) return from;
    const Sint32 to = shown_->Angle(shownGap_ + 1, j);
    const int frames = 2 * (shown_->Interpolation(shownGap_) + 1);
    // Multiplies in 64 bits: between two key frames that are far apart in time, the product of the
    // difference of the angles and the number of the frame would not fit 32 bits.
    return from + (Sint32)DivideRounded((Sint64)(to - from) * shownFrame_, frames);
}
