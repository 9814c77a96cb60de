#include "RemoteCamera.h"

void
RcPicturePart::Write(RcWriter* out) const
{
    out->U16(part);
    out->U16(parts);
    out->U32(frame);
    out->U8(layer);
    out->U8(bands);
    out->U16(width);
    out->U16(height);
}

void
RcPicturePart::Read(RcReader* in)
{
    part = in->U16();
    parts = in->U16();
    frame = in->U32();
    layer = in->U8();
    bands = in->U8();
    width = in->U16();
    height = in->U16();
}
