#include "Bulk.h"

#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>

static const unsigned int kSize = 1 << 20;
static const unsigned int kRounds = 12;

OStatus
Bulk::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;
    return oSUCCESS;
}

OStatus
Bulk::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Bulk::DoStop(const OSystemEvent&)
{
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Bulk::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

void
Bulk::ReadyOut(const OReadyEvent&)
{
    OSubject* const out = subject[sbjOut];
    if (!out->IsAllReady() || round_ >= kRounds) return;
    ++round_;
    RCRegion* const region = new RCRegion(kSize);
    unsigned char* const bytes = (unsigned char*)region->Base();
    for (unsigned int i = 0; i < kSize; i++) bytes[i] = (unsigned char)(i * 31 + (i >> 8) * round_);
    out->SetData(region);
    region->RemoveReference();
    out->SetData(&round_, sizeof(round_));
    out->NotifyObservers();
}

void
Bulk::NotifyIn(const ONotifyEvent& event)
{
    OSYSPRINT(("Bulk heard itself: %d data\n", event.NumOfData()));
    observer[event.ObsIndex()]->AssertReady(event.SenderID());
}

void
Bulk::NotifySums(const ONotifyEvent& event)
{
    OSYSPRINT(("Bulk is told %u in round %u\n", *(const unsigned int*)event.Data(0), round_));
    observer[event.ObsIndex()]->AssertReady(event.SenderID());
}
