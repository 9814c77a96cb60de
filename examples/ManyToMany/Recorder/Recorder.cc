#include "Recorder.h"

#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>

#include "Reading.h"

OStatus
Recorder::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;
    return oSUCCESS;
}

// Asserts ready to all connected subjects.
OStatus
Recorder::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Recorder::DoStop(const OSystemEvent&)
{
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Recorder::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

void
Recorder::NotifyValue(const ONotifyEvent& event)
{
    numReadings_ += event.NumOfData();
    if (numReadings_ == NUM_WANTED) {
        OSYSPRINT(("Recorder: %d readings of %d instruments\n", numReadings_,
                   observer[obsValue]->NumberOfSubjects()));
    }
    observer[event.ObsIndex()]->AssertReady(event.SenderID());
}
