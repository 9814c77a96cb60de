#include "RemoteFiles.h"

void
RcList::Write(RcWriter* out) const
{
    out->U16(total);
    out->U16(first);
    out->U8((Uint32)entries.size());
    for (size_t i = 0; i < entries.size(); i++) {
        out->String(entries[i].name);
        out->U32(entries[i].size);
    }
}

bool
RcList::Read(RcReader* in)
{
    entries.clear();
    total = in->U16();
    first = in->U16();
    const int count = in->U8();
    for (int i = 0; i < count && !in->HasFailed(); i++) {
        RcListEntry entry;
        entry.name = in->String();
        entry.size = in->U32();
        entries.push_back(entry);
    }
    return in->IsComplete();
}

void
RcUploadBegin::Write(RcWriter* out) const
{
    out->U8(kind);
    out->String(name);
    out->U32(size);
    out->U32(crc);
}

bool
RcUploadBegin::Read(RcReader* in)
{
    kind = in->U8();
    name = in->String();
    size = in->U32();
    crc = in->U32();
    return in->IsComplete();
}

void
RcFileName::Write(RcWriter* out) const
{
    out->U8(kind);
    out->String(name);
}

bool
RcFileName::Read(RcReader* in)
{
    kind = in->U8();
    name = in->String();
    return in->IsComplete();
}

void
RcDownload::Write(RcWriter* out) const
{
    out->U8(kind);
    out->String(name);
    out->U32(offset);
}

bool
RcDownload::Read(RcReader* in)
{
    kind = in->U8();
    name = in->String();
    offset = in->U32();
    return in->IsComplete();
}
