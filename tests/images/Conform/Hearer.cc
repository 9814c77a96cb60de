#include "Hearer.h"

#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>
#include <stdio.h>
#include <string.h>

// HINIT.TXT: skip, min and max of the observer In.
OStatus
Hearer::DoInit(const OSystemEvent&)
{
    OSYSPRINT(("H init\n"));
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;
    FILE* file = fopen("/MS/OPEN-R/MW/DATA/P/HINIT.TXT", "r");
    if (file == 0) return oSUCCESS;
    int skip, min, max;
    if (fscanf(file, "%d %d %d", &skip, &min, &max) == 3) observer[obsIn]->SetBufCtrlParam(skip, min, max);
    fclose(file);
    return oSUCCESS;
}

// HSTART.TXT: if the file exists, all observers assert ready, as those of most objects do.
OStatus
Hearer::DoStart(const OSystemEvent&)
{
    OSYSPRINT(("H start\n"));
    ENABLE_ALL_SUBJECT;
    FILE* file = fopen("/MS/OPEN-R/MW/DATA/P/HSTART.TXT", "r");
    if (file == 0) return oSUCCESS;
    fclose(file);
    ASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Hearer::DoStop(const OSystemEvent&)
{
    OSYSPRINT(("H stop\n"));
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Hearer::DoDestroy(const OSystemEvent&)
{
    OSYSPRINT(("H destroy\n"));
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

void
Hearer::Print(const char* who, const ONotifyEvent& event)
{
    OSYSPRINT(("H %s", who));
    for (int i = 0; i < event.NumOfData(); i++) OSYSPRINT((" %d", *(const int*)event.Data(i)));
    OSYSPRINT((" (notifies %d refs %d)\n", event.NumOfNotify(), event.RCData(0)->NumberOfReference()));
}

void
Hearer::NotifyIn(const ONotifyEvent& event)
{
    Print("in", event);
    if (remembers) memory = (volatile int*)event.Data(0);
    if (keeps) {
        kept = event.RCData(0);
        kept->AddReference();
        keeps = false;
    }
    if (asserts) observer[event.ObsIndex()]->AssertReady(event.SenderID());
}

void Hearer::NotifyLate(const ONotifyEvent& event) { Print("late", event); }

void
Hearer::Command(void* msg)
{
    const char* command = (const char*)msg;
    if (strcmp(command, "assert") == 0) observer[obsIn]->AssertReady();
    if (strcmp(command, "assert late") == 0) observer[obsLate]->AssertReady();
    if (strcmp(command, "deassert") == 0) observer[obsIn]->DeassertReady();
    if (strcmp(command, "auto") == 0) asserts = true;
    if (strcmp(command, "keep") == 0) keeps = true;
    if (strcmp(command, "let go") == 0) kept->RemoveReference();
    if (strcmp(command, "remember") == 0) remembers = true;
    if (strcmp(command, "peek") == 0) OSYSPRINT(("H peeks %d\n", *memory));
    if (strcmp(command, "poke") == 0) *memory = 0;
    if (strcmp(command, "kept?") == 0) OSYSPRINT(("H kept %d\n", *(int*)kept->Base()));
}
