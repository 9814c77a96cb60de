#include "Mirror.h"

#include <MCOOP.h>
#include <OPENR/core_macro.h>
#include <stdlib.h>

static int aStatic;

OStatus
Mirror::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;
    return oSUCCESS;
}

OStatus
Mirror::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Mirror::DoStop(const OSystemEvent&)
{
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Mirror::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

void
Mirror::NotifyIn(const ONotifyEvent& event)
{
    int aLocal = 0;
    void* heap = malloc(50);
    size_t left = 0;  // free memory of the robot, which Revealer uses as well
    GetFreeMemorySize(&left);
    const void* addresses[] = {event.Data(0), heap, &aStatic, &aLocal, this, (void*)left};
    free(heap);
    subject[sbjOut]->SetData(addresses, sizeof(addresses));
    subject[sbjOut]->NotifyObservers();
    observer[event.ObsIndex()]->AssertReady();
}
