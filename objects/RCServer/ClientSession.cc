#include "ClientSession.h"

#include <string.h>

// Size, in bytes, that most answers do not exceed.  Answers to requests that arrived together go
// into one send, as long as one more answer of this size fits into RC_MAX_PACKET.
static const int USUAL_ANSWER_SIZE = 256;

void
ClientSession::Reset()
{
    framer_.Reset();
    isLast_ = false;
    endsRun_ = false;
    isWaiting_ = false;
    hasSpoken_ = true;
    eventFrame_ = 0;
    heldAt_ = 0;
    heldSize_ = 0;
}

void
ClientSession::Begin(int number, RequestHandler* handler)
{
    number_ = number;
    handler_ = handler;
    Reset();
}

void
ClientSession::Receive(const Uint8* bytes, int size)
{
    framer_.Append(bytes, size);
    hasSpoken_ = true;
}

// Returns whether the packet that framer_ has found only acknowledges packets of streams (values to
// which the client has subscribed).  Such a packet gets no answer.
bool
ClientSession::IsAcknowledgement() const
{
    const RcHeader& header = framer_.Header();
    return header.command == rcEVENT && header.version == RC_VERSION_FILES;
}

int
ClientSession::NextAnswers(Uint8* buffer)
{
    int size = heldSize_;
    memmove(buffer, buffer + heldAt_, (size_t)size);
    heldSize_ = 0;
    while (!isLast_ && size + USUAL_ANSWER_SIZE <= RC_MAX_PACKET) {
        RcWriter out(buffer + size, RC_MAX_PACKET);
        const RcFramer::Result result = framer_.Next();
        if (result == RcFramer::NEEDS_MORE) break;
        if (result == RcFramer::PACKET && isWaiting_) return TurnAway(buffer, &framer_);
        if (result == RcFramer::PACKET && IsAcknowledgement()) continue;
        if (result == RcFramer::PACKET) {
            handler_->Answer(number_, framer_, &out);
            if (handler_->EndsRun()) isLast_ = endsRun_ = true;
        } else {
            handler_->AnswerBroken(framer_.Error(), &out);
            isLast_ = true;
        }
        if (size + out.Size() > RC_MAX_PACKET) {
            heldAt_ = size;
            heldSize_ = out.Size();
            return size;
        }
        size += out.Size();
    }
    return size;
}

int
ClientSession::NextEvents(Uint8* buffer)
{
    const Uint32 frame = handler_->Frame();
    if (isLast_ || !(hasSpoken_ || frame - eventFrame_ >= EVENT_FRAMES)) return 0;
    RcWriter out(buffer, RC_MAX_PACKET);
    handler_->WriteEvents(number_, &out);
    if (out.Size() > 0) {
        hasSpoken_ = false;
        eventFrame_ = frame;
    }
    return out.Size();
}

int
ClientSession::TurnAway(Uint8* buffer, const RcFramer* request)
{
    RcWriter out(buffer, RC_MAX_PACKET);
    handler_->AnswerNoPlace(request, RC_PLACES, RC_IDLE_SECONDS, &out);
    isLast_ = true;
    return out.Size();
}
