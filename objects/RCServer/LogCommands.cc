//
// Answers the requests for the log of motions (the key frames that motions have reached).
//

#include "RequestHandler.h"

#include "TextFormat.h"

// Answers with records of the log of motions, from the record number in the request on, as many as
// there is room for.  The log keeps only the newest records.  If the log does not have the record
// that was asked for any more, begins with the oldest record that it has.  The client notices this,
// because the answer has the number of its first record.
int
RequestHandler::TellLog(RcReader* in, RcWriter* out)
{
    const Uint32 asked = in->U32();
    if (!in->IsComplete()) return FailSize();
    if (asked > log_.Count() && asked != RC_LOG_END) {
        return Fail(rcerrorBAD_VALUE, TextFormat("record %u, but there are %u so far",
                                                 (unsigned)asked, (unsigned)log_.Count()));
    }
    RcLogHead head;
    head.count = log_.Count();
    head.first = asked < log_.Oldest() ? log_.Oldest() : asked;
    if (asked == RC_LOG_END) head.first = head.count;
    head.state = (Uint8)state_;
    head.size = (Uint16)log_.RecordSize();
    const Uint32 room = (Uint32)((out->Room() - RcLogHead::SIZE) / log_.RecordSize());
    const Uint32 rest = head.count - head.first;
    head.here = (Uint8)(rest < room ? rest : room);
    head.Write(out);
    for (Uint32 i = 0; i < head.here; i++) out->Bytes(log_.Record(head.first + i), head.size);
    return rcOK;
}
