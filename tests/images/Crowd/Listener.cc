#include "Listener.h"

#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>

OStatus
Listener::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;
    return oSUCCESS;
}

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

void
Listener::NotifyIn(const ONotifyEvent& event)
{
    OSYSPRINT(("heard %d\n", *static_cast<const int*>(event.Data(0))));
    observer[event.ObsIndex()]->AssertReady();
}

void
Listener::Fill(void*)
{
}
