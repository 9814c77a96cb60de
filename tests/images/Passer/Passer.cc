#include "Passer.h"

#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>

static const unsigned int kLast = 4000;

OStatus
Passer::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;
    return oSUCCESS;
}

OStatus
Passer::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Passer::DoStop(const OSystemEvent&)
{
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Passer::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

void
Passer::PassOn()
{
    OSubject* const out = subject[sbjOut];
    if (next_ == 0 || !out->IsAllReady()) return;
    out->SetData(&next_, sizeof(next_));
    next_ = 0;
    out->NotifyObservers();
}

void
Passer::ReadyOut(const OReadyEvent& event)
{
    if (event.IsAssert()) PassOn();
}

void
Passer::NotifyIn(const ONotifyEvent& event)
{
    const unsigned int number = *(const unsigned int*)event.Data(0);
    if (number == kLast) OSYSPRINT(("Passer: %u\n", number));
    next_ = number < kLast ? number + 1 : 0;
    PassOn();
    observer[event.ObsIndex()]->AssertReady(event.SenderID());
}

void
Passer::NotifySensor(const ONotifyEvent& event)
{
    sensors_++;
    observer[event.ObsIndex()]->AssertReady(event.SenderID());
}
