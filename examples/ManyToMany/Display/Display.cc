#include "Display.h"

#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>

#include "Reading.h"

OStatus
Display::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;
    return oSUCCESS;
}

// Asserts ready to all connected subjects.
OStatus
Display::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Display::DoStop(const OSystemEvent&)
{
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Display::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

// Asserts ready only to the sender of this reading, because the other instrument knows already that
// this object is ready.
void
Display::NotifyValue(const ONotifyEvent& event)
{
    const Reading* reading = (const Reading*)event.Data(0);
    OSYSPRINT(("Display: %s %d\n", reading->name, (int)reading->value));
    observer[event.ObsIndex()]->AssertReady(event.SenderID());
}
