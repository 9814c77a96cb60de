#include "Taker.h"

#include <OPENR/core_macro.h>

OStatus
Taker::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;
    return oSUCCESS;
}

OStatus
Taker::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Taker::DoStop(const OSystemEvent&)
{
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Taker::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

void
Taker::NotifyIn(const ONotifyEvent& event)
{
    unsigned int sum = 0;
    for (int i = 0; i < event.NumOfData(); i++) {
        const unsigned char* const bytes = (const unsigned char*)event.Data(i);
        for (size_t k = 0; k < event.RCData(i)->Size(); k++) sum = sum * 31 + bytes[k];
    }
    subject[sbjSum]->SetData(&sum, sizeof(sum));
    subject[sbjSum]->NotifyObservers();
    observer[event.ObsIndex()]->AssertReady(event.SenderID());
}
