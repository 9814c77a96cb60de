#include "RemoteLog.h"

void
RcLogHead::Write(RcWriter* out) const
{
    out->U32(count);
    out->U32(first);
    out->U8(state);
    out->U8(here);
    out->U16(size);
}

void
RcLogHead::Read(RcReader* in)
{
    count = in->U32();
    first = in->U32();
    state = in->U8();
    here = in->U8();
    size = in->U16();
}
