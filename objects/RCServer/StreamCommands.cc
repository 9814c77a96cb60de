//
// Answers the requests that begin and end streams (values that the robot sends to a client again
// and again), and makes the packets of streams.
//

#include "RequestHandler.h"

#include "Angle.h"
#include "TextFormat.h"

int
RequestHandler::Subscribe(RcReader* in, RcWriter* out)
{
    RcSubscribe request;
    if (!request.Read(in)) return FailSize();
    if (request.stream >= NUM_RC_STREAMS) return FailStream(request.stream);
    const int least = request.stream == rcstreamSENSORS ? RC_FRAMES_PER_VECTOR : 0;
    if (request.period % RC_FRAMES_PER_VECTOR != 0 || request.period < least) {
        return Fail(rcerrorBAD_VALUE,
                    TextFormat("period of %d frames, must be a multiple of %d from %d on",
                               request.period, RC_FRAMES_PER_VECTOR, least));
    }
    streams_[client_].Begin(request.stream, request.period, tag_);
    out->U16(request.period);
    return rcOK;
}

int
RequestHandler::Unsubscribe(RcReader* in)
{
    const int stream = in->U8();
    if (!in->IsComplete()) return FailSize();
    if (stream >= NUM_RC_STREAMS) return FailStream(stream);
    streams_[client_].End(stream);
    return rcOK;
}

int
RequestHandler::FailStream(int stream)
{
    return Fail(rcerrorBAD_VALUE,
                TextFormat("stream %d is unknown; 0 is sensor values, 1 is set values", stream));
}

void
RequestHandler::SetSensors(const SensorValues& values)
{
    sensors_ = values;
    for (int i = 0; i < MAX_CLIENTS; i++) streams_[i].NewValues(rcstreamSENSORS, values.frame);
}

void
RequestHandler::WriteEvents(int client, RcWriter* out)
{
    ClientStreams& streams = streams_[client];
    for (int stream = streams.Due(sensors_.frame); stream >= 0;
         stream = streams.Due(sensors_.frame)) {
        RcWriter packet(out->End(), out->Room());
        BeginAnswer(&packet, rcOK);
        RcEventHead head;
        head.stream = (Uint8)stream;
        head.leftOut = streams.Sent(stream, sensors_.frame);
        head.Write(&packet);
        if (stream == rcstreamSENSORS) {
            WriteSensors(&packet);
        } else {
            WriteSetValues(&packet);
        }
        packet.PutHeader(rcEVENT, streams.Tag(stream), RC_VERSION_FILES);
        out->Add(packet.Size());
    }
}

void
RequestHandler::WriteSetValues(RcWriter* out) const
{
    RcSetValues values;
    values.state = (Uint8)report_.state;
    values.isOver = report_.isOver;
    values.motorsOff = report_.motorsOff;
    values.earMask = report_.earMask;
    values.earOn = report_.earOn;
    values.keyFrame = report_.keyFrame;
    values.file = report_.file;
    for (int j = 0; j < robot_->numJoints; j++) {
        values.commanded.push_back(CdegFromUrad(report_.commanded[j]));
        values.measured.push_back(CdegFromUrad(report_.measured[j]));
    }
    values.Write(out);
}
