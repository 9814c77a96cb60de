#include "RemoteStreams.h"

void
RcSubscribe::Write(RcWriter* out) const
{
    out->U8(stream);
    out->U16(period);
}

bool
RcSubscribe::Read(RcReader* in)
{
    stream = in->U8();
    period = in->U16();
    return in->IsComplete();
}

void
RcEventHead::Write(RcWriter* out) const
{
    out->U8(stream);
    out->U8(0);
    out->U16(leftOut);
}

void
RcEventHead::Read(RcReader* in)
{
    stream = in->U8();
    in->U8();
    leftOut = in->U16();
}

void
RcSetValues::Write(RcWriter* out) const
{
    out->U8((Uint32)commanded.size());
    out->U8(state);
    out->U8(isOver);
    out->U8(motorsOff);
    out->U8(earMask);
    out->U8(earOn);
    out->U16(0);
    out->S32(keyFrame);
    out->String(file);
    for (size_t i = 0; i < commanded.size(); i++) out->S32(commanded[i]);
    for (size_t i = 0; i < measured.size(); i++) out->S32(measured[i]);
}

bool
RcSetValues::Read(RcReader* in)
{
    const int count = in->U8();
    state = in->U8();
    isOver = in->U8();
    motorsOff = in->U8();
    earMask = in->U8();
    earOn = in->U8();
    in->U16();
    keyFrame = in->S32();
    file = in->String();
    commanded.clear();
    measured.clear();
    for (int i = 0; i < count && !in->HasFailed(); i++) commanded.push_back(in->S32());
    for (int i = 0; i < count && !in->HasFailed(); i++) measured.push_back(in->S32());
    return in->IsComplete();
}
