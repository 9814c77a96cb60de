//
// Answers the requests that version 2 of the protocol has added.  One of them is BATCH, a packet
// that contains several requests.
//

#include "RequestHandler.h"

#include "ByteOrder.h"
#include "TextFormat.h"

// Handles the commands that version 2 of the remote control's protocol adds, and leaves the others
// to HandleVersion1().
int
RequestHandler::HandleVersion2(int command, RcReader* in, RcWriter* out)
{
    switch (command) {
    case rcBATCH:
        return AnswerBatch(in, out);
    case rcGAINS:
        return SetOrTellGains(in, out);
    case rcMOTOR_OFF:
    case rcMOTOR_ON:
        return SwitchMotor(command, in);
    case rcTRACK:
        return TrackJoint(in, out);
    case rcPOWER:
        return TellPower(in, out);
    case rcSUBSCRIBE:
        return Subscribe(in, out);
    case rcUNSUBSCRIBE:
        return Unsubscribe(in);
    case rcCAMERA:
        return AskForPicture(in);
    case rcCAMERA_PART:
        return TellPicturePart(in, out);
    case rcMTN_LIST:
        return ListMotions(in, out);
    case rcUPLOAD_BEGIN:
        return BeginUpload(in, out);
    case rcUPLOAD_DATA:
        return ReceiveUpload(in, out);
    case rcUPLOAD_END:
        return EndUpload(in, out);
    case rcDELETE:
        return DeleteFile(in);
    case rcDOWNLOAD:
        return Download(in, out);
    case rcLOG:
        return TellLog(in, out);
    case rcREBOOT:
        return EndRun(in, true);
    case rcSHUTDOWN:
        return EndRun(in, false);
    default:
        return HandleVersion1(command, in, out);
    }
}

// ---- Batch ---------------------------------------------------------------------------

// Returns whether a command may be a part of a batch (several requests in one packet).  After a
// failed request, a batch goes on with its next request.  An upload must not go on after an error
// in one of its parts, so uploads may not be in a batch.
static bool
MayBeInBatch(int command)
{
    switch (command) {
    case rcBATCH:
    case rcUPLOAD_BEGIN:
    case rcUPLOAD_DATA:
    case rcUPLOAD_END:
    case rcREBOOT:
    case rcSHUTDOWN:
        return false;
    default:
        return true;
    }
}

// Checks the bytes of all requests of a batch, so that no request is carried out when any request
// of the batch is broken.  Returns rcOK and sets `count` to the number of requests.
int
RequestHandler::CountBatch(RcReader in, int* count)
{
    *count = 0;
    const int whole = in.RestSize();
    while (in.RestSize() > 0) {
        const int at = whole - in.RestSize();
        RcHeader header;
        header.size = 0;
        if (in.RestSize() >= RC_HEADER_SIZE) header.Read(in.Rest());
        if (header.size < RC_HEADER_SIZE || header.size > in.RestSize() ||
            GetU16(in.Rest()) != RC_MAGIC) {
            return Fail(rcerrorMALFORMED,
                        TextFormat("request %d of the batch, at byte %d of the payload, is no whole "
                                   "packet; nothing was done",
                                   *count, at));
        }
        in.Skip(header.size);
        *count += 1;
    }
    if (*count >= 1 && *count <= RC_MAX_BATCH) return rcOK;
    return Fail(rcerrorBAD_VALUE, TextFormat("%d requests, a batch has 1 to %d; nothing was done",
                                             *count, RC_MAX_BATCH));
}

// Answers the requests of a batch (several requests in one packet) one after the other.  Each
// answer leaves room for the smallest answers to the requests behind it.  Because RC_MAX_BATCH of
// the smallest answers fit into a packet, every request gets an answer.
int
RequestHandler::AnswerBatch(RcReader* in, RcWriter* out)
{
    int count;
    const int status = CountBatch(*in, &count);
    if (status != rcOK) return status;
    isInBatch_ = true;
    for (; count > 0; count--) {
        RcHeader header;
        header.Read(in->Rest());
        RcWriter part(out->End(), out->Room() - (count - 1) * RC_SMALLEST_BATCH_ANSWER);
        AnswerOne(header, in->Rest() + RC_HEADER_SIZE, &part);
        out->Add(part.Size());
        in->Skip(header.size);
    }
    isInBatch_ = false;
    return rcOK;
}

int
RequestHandler::Handle(int command, RcReader* in, RcWriter* out)
{
    if (version_ == RC_VERSION) return HandleVersion1(command, in, out);
    if (isInBatch_ && !MayBeInBatch(command)) {
        return Fail(rcerrorNOT_IN_BATCH, "must not be in a batch");
    }
    return HandleVersion2(command, in, out);
}
