#include "Early.h"

#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const Selector answerEntry = 8;  // DoAnswer of oracle.cfg
static const Selector hearEntry   = 8;  // DoHear of early.cfg
static const Selector tickEntry   = 9;  // DoTick of early.cfg
static const Selector wrongEntry  = 99;
static const int      lastTick    = 3;  // the tick at which First crashes if the stick has FRAGILE.TXT

static bool
HasFile(const char* name)
{
    char path[64];
    sprintf(path, "/MS/OPEN-R/MW/DATA/P/%s", name);
    FILE* file = fopen(path, "r");
    if (file == NULL) return false;
    fclose(file);
    return true;
}

// The request to Oracle comes last, because no call after it needs an answer at once.  So in a
// worker the request waits until the object is loaded.
Early::Early() : heard_(0), ticks_(0)
{
    printf("%s is made\n", earlyName);
    random_ = rand();
    SystemTime now;
    GetSystemTime(&now);
    made_ = now.seconds * 1000 + now.useconds / 1000;
    sent_ = Send(myOID_, hearEntry, 0, 0);
    named_ = Register(myOID_, earlyService);
    registered_ = RegisterServiceEntry(OServiceEntry(myOID_, hearEntry), earlyService);
    TimeEventInfoWithRelativeTime tick(RelativeTime(0, 100), RelativeTime(0, 100));
    SetTimeEvent(&tick, myOID_, tickEntry, 0, 0, 0);
    char question[] = "who?";
    if (HasFile("WRONG.TXT")) SendWithRBox(myOID_, wrongEntry, question, sizeof(question), &wrongBox_);
    OID self, oracle;
    found_ = Find(earlyName, &self);
    Find("Oracle", &oracle);
    SetResourceValue(rMAXQUEUESIZE, 7);
    GetResourceValue(rMAXQUEUESIZE, &queue_);
    asked_ = SendWithRBox(oracle, answerEntry, question, sizeof(question), &box_);
}

OStatus
Early::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;
    return oSUCCESS;
}

OStatus
Early::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Early::DoStop(const OSystemEvent&)
{
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Early::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

void
Early::DoHear(void*)
{
    heard_++;
}

void
Early::DoTick(void*)
{
    ticks_++;
    if (ticks_ == 1) Report();
    if (ticks_ == lastTick && strcmp(earlyName, "First") == 0 && HasFile("FRAGILE.TXT")) *(volatile int*)16 = 1;
}

void
Early::Report()
{
    char         reply[24] = "";
    size_t       got       = 0;
    RelativeTime soon(0, 10);
    if (Receive(box_, reply, sizeof(reply), &got, &soon) != sSUCCESS) strcpy(reply, "no answer");
    OSYSPRINT(("%s: made at %u ms, sent %d, asked %d, named %d, registered %d, found %d, random %d, queue %d\n",
               earlyName, made_, (int)sent_, (int)asked_, (int)named_, (int)registered_, (int)found_, random_,
               (int)queue_));
    // A second registration is refused if the first still holds.
    const bool keepsName = Register(myOID_, earlyService) != sSUCCESS;
    const bool keepsService = RegisterServiceEntry(OServiceEntry(myOID_, hearEntry), earlyService) != oSUCCESS;
    OSYSPRINT(("%s: heard %d, keeps %d %d, %s\n", earlyName, heard_, (int)keepsName, (int)keepsService, reply));
    if (HasFile("WRONG.TXT")) OSYSPRINT(("%s: wrong %d\n", earlyName, (int)Receive(wrongBox_)));
}
