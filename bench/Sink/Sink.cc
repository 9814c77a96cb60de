#include "Sink.h"

#include <OPENR/core_macro.h>

OStatus
Sink::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;
    return oSUCCESS;
}

OStatus
Sink::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Sink::DoStop(const OSystemEvent&)
{
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Sink::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

void
Sink::NotifyIn(const ONotifyEvent& event)
{
    observer[event.ObsIndex()]->AssertReady();
}
