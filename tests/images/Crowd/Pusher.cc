#include "Pusher.h"

#include <MCOOP.h>
#include <OPENR/OPENR.h>
#include <OPENR/core_macro.h>

OStatus
Pusher::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;
    return oSUCCESS;
}

// Orders a message to Push every 200 ms.
OStatus
Pusher::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    TimeEventInfoWithRelativeTime info(RelativeTime(0, 200), RelativeTime(0, 200));
    SetTimeEvent(&info, myOID_, oentryBASE + 4, 0, 0, 0);
    return oSUCCESS;
}

OStatus
Pusher::DoStop(const OSystemEvent&)
{
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Pusher::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

void
Pusher::Notify(int number)
{
    subject[sbjOut]->SetData(&number, sizeof(number));
    subject[sbjOut]->NotifyObservers();
}

// Fills the queue of the listener at the second and at the fourth call, and always notifies.  At the
// fourth call notifies twice, so that the second notification waits when the first comes back.
void
Pusher::Push(void*)
{
    ++pushes_;
    const bool isFilling = pushes_ == 2 || pushes_ == 4;
    OID        listener;
    if (isFilling && Find("listener", &listener) == sSUCCESS) {
        for (int i = 0; i < 40; i++) Send(listener, oentryBASE + 4, 0, 0);
    }
    Notify(10 * pushes_);
    if (pushes_ == 4) Notify(10 * pushes_ + 1);
}
