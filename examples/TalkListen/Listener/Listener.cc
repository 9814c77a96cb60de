#include "Listener.h"

#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>

#include "Line.h"

OStatus
Listener::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;
    return oSUCCESS;
}

// Asserts ready for the first time.  Without this ready, no subject would ever send anything.
OStatus
Listener::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Listener::DoStop(const OSystemEvent&)
{
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Listener::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

// Takes the data first, and then asserts ready once: from then on the data belong to the talker
// again.
void
Listener::NotifyHear(const ONotifyEvent& event)
{
    for (int i = 0; i < event.NumOfData(); i++) {
        const Line* line = (const Line*)event.Data(i);
        OSYSPRINT(("Listener: %u. %s\n", (unsigned)line->number, line->text));
    }
    observer[event.ObsIndex()]->AssertReady(event.SenderID());
}
