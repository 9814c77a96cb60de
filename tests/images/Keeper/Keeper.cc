#include "Keeper.h"

#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>
#include <stdio.h>

static int heard = 0;

// Puts a 1 in place of what was in the file, if there is one, and returns that.
static unsigned int
ReplaceFile()
{
    const char* const name = "/MS/OPEN-R/MW/DATA/P/KEPT.TXT";
    FILE* file = fopen(name, "r");
    if (file == NULL) return 0;
    unsigned int sum = 0;
    for (int c = getc(file); c != EOF; c = getc(file)) sum = sum * 31 + c;
    fclose(file);
    file = fopen(name, "w");
    fprintf(file, "1\n");
    fclose(file);
    return sum;
}

OStatus
Keeper::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;
    return oSUCCESS;
}

OStatus
Keeper::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Keeper::DoStop(const OSystemEvent&)
{
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Keeper::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

void
Keeper::NotifySensor(const ONotifyEvent& event)
{
    char text[32];
    sprintf(text, "vector %d", ++heard);
    kept_[heard * 7919 % 101] = text;
    // A sum over all that is kept.
    unsigned int sum = heard == 1 ? ReplaceFile() : 0;
    for (std::map<int, std::string>::iterator it = kept_.begin(); it != kept_.end(); ++it) {
        for (size_t i = 0; i < it->second.size(); i++) sum = sum * 31 + it->second[i];
    }
    subject[sbjOut]->SetData(&sum, sizeof(sum));
    subject[sbjOut]->NotifyObservers();
    observer[event.ObsIndex()]->AssertReady();
}

void
Keeper::NotifyIn(const ONotifyEvent& event)
{
    observer[event.ObsIndex()]->AssertReady();
}
