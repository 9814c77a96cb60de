#include "ClientStreams.h"

#include <string.h>

void
ClientStreams::Clear()
{
    memset(stream_, 0, sizeof(stream_));
}

void
ClientStreams::Begin(int stream, Uint16 period, Uint16 tag)
{
    Stream& begun = stream_[stream];
    memset(&begun, 0, sizeof(begun));
    begun.isOn = true;
    begun.period = period;
    begun.tag = tag;
}

// Returns whether the period of the subscription (the least time between two packets) has passed
// since lastFrame.  Also returns true when the robot counts its frames from the beginning again:
// `frame` is then less than lastFrame, so the difference of these unsigned numbers is very large.
// The next packet is then sent too early, which is better than a long wait.
bool
ClientStreams::IsPeriodOver(const Stream& stream, Uint32 frame) const
{
    return !stream.hasLastFrame || frame - stream.lastFrame >= stream.period;
}

// Counts new values of a stream.  Sensor values come in every vector, usually more often than the
// client wants them.  So a sensor value counts only if the period of the subscription is over.  All
// set values (reports of JointMover) count, because each of them is a key frame.
void
ClientStreams::NewValues(int stream, Uint32 frame)
{
    Stream& changed = stream_[stream];
    if (!changed.isOn) return;
    if (stream == rcstreamSENSORS) {
        if (!IsPeriodOver(changed, frame)) return;
        changed.hasLastFrame = true;
        changed.lastFrame = frame;
    }
    if (changed.numNew < 0xffff) changed.numNew++;
}

int
ClientStreams::Due(Uint32 frame) const
{
    for (int i = 0; i < NUM_RC_STREAMS; i++) {
        if (!stream_[i].isOn || stream_[i].numNew == 0) continue;
        if (i == rcstreamSENSORS || IsPeriodOver(stream_[i], frame)) return i;
    }
    return -1;
}

Uint16
ClientStreams::Sent(int stream, Uint32 frame)
{
    Stream& sent = stream_[stream];
    const Uint16 leftOut = (Uint16)(sent.numNew - 1);
    sent.numNew = 0;
    sent.hasLastFrame = true;
    sent.lastFrame = frame;
    return leftOut;
}
