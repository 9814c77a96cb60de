#include "Bulk.h"

#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>
#include <stdio.h>

// Values that the file BULK.TXT of the stick may set: bytes of a region, regions at a time, rounds.
static unsigned int bytesEach = 1 << 20;
static unsigned int regions = 1;
static unsigned int rounds = 12;

static void
ReadPlan()
{
    FILE* const file = fopen("/MS/OPEN-R/MW/DATA/P/BULK.TXT", "r");
    if (file == 0) return;
    if (fscanf(file, "%u %u %u", &bytesEach, &regions, &rounds) != 3) OSYSPRINT(("Bulk: what?\n"));
    fclose(file);
}

OStatus
Bulk::DoInit(const OSystemEvent&)
{
    ReadPlan();
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
    if (!out->IsAllReady() || round_ >= rounds) return;
    ++round_;
    for (unsigned int k = 0; k < regions; k++) {
        RCRegion* const region = new RCRegion(bytesEach);
        unsigned char* const bytes = (unsigned char*)region->Base();
        for (unsigned int i = 0; i < bytesEach; i++)
            bytes[i] = (unsigned char)(i * 31 + (i >> 8) * round_);
        out->SetData(region);
        region->RemoveReference();
    }
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
