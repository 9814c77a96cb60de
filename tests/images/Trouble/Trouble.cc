#include "Trouble.h"

#include <OPENR/OPENRAPI.h>
#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../Writes.h"
#include "Faults.h"

static volatile int sink;
static const char* volatile nowhere = 0;

// Uses up the stack.
static int
Recurse(int depth)
{
    volatile char frame[1024];
    frame[0] = (char)depth;
    sink = frame[0];
    if (depth < 0) return 0;  // never; the compiler wants to see an end
    return Recurse(depth + 1) + frame[0];
}

// Takes much of the stack at once.
static void
TakeRoom()
{
    volatile char room[40000];
    for (unsigned i = 0; i < sizeof(room); i++) room[i] = (char)i;
    sink = room[sizeof(room) - 1];
}

// Takes more than the 8192 bytes of the .ocf file, and less than twice as much.
static void
TakeSomeRoom()
{
    volatile char room[10000];
    for (unsigned i = 0; i < sizeof(room); i++) room[i] = (char)i;
    sink = room[sizeof(room) - 1];
}

// Calls what goes deep on a host: functions of the SDK and of the C library.
static void
CallLibraries()
{
    char text[64];
    sprintf(text, "%f %d", 0.5 + sink, sink);
    sscanf(text, "%d", const_cast<int*>(&sink));
    OSYSLOG1((osyslogINFO, "%s", text));
    FILE* file = fopen("/MS/OPEN-R/MW/DATA/P/TROUBLE.TXT", "r");
    if (file != 0) fclose(file);
    RCRegion* region = new RCRegion(16);
    region->RemoveReference();
}

OStatus
Trouble::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;
    return oSUCCESS;
}

OStatus
Trouble::DoStart(const OSystemEvent&)
{
    char word[32] = "";
    FILE* file = fopen("/MS/OPEN-R/MW/DATA/P/TROUBLE.TXT", "r");
    if (file != 0) {
        if (fscanf(file, "%31s", word) != 1) word[0] = 0;
        fclose(file);
    }
    if (strcmp(word, "hang") == 0) {
        for (;;) sink = 1 - sink;
    } else if (strcmp(word, "sayhang") == 0) {
        OSYSPRINT(("it hangs now\n"));
        for (;;) sink = 1 - sink;
    } else if (strcmp(word, "lock") == 0) {
        static pthread_mutex_t mutex = PTHREAD_MUTEX_INITIALIZER;
        OSYSPRINT(("it hangs now\n"));
        for (;;) pthread_mutex_lock(&mutex);  // waits without processor time
    } else if (strcmp(word, "flood") == 0) {
        for (;;) OSYSPRINT(("x"));
    } else if (strcmp(word, "crash") == 0) {
        *(volatile int*)16 = 1;
    } else if (strcmp(word, "copynull") == 0) {
        char copy[32];
        strcpy(copy, nowhere);
        sink = copy[0];
    } else if (strcmp(word, "callnull") == 0) {
        void (*volatile nothing)() = 0;
        nothing();
        sink = 1;  // not the last thing that is done: a call, not a jump
    } else if (strcmp(word, "divide") == 0) {
        sink = 0;
        sink = 100 / sink;
    } else if (strcmp(word, "recurse") == 0) {
        sink = Recurse(0);
    } else if (strcmp(word, "deep") == 0) {
        TakeRoom();
    } else if (strcmp(word, "some") == 0) {
        TakeSomeRoom();
    } else if (strcmp(word, "libraries") == 0) {
        CallLibraries();
    } else if (strcmp(word, "print") == 0) {
        printf("printed by an object\n");
        fflush(stdout);
        OSYSPRINT(("said by an object\n"));
    } else if (strcmp(word, "half") == 0) {
        printf("half a line");
        return oSUCCESS;
    } else if (strcmp(word, "halfcrash") == 0) {
        printf("half a line");
        *(volatile int*)16 = 1;
    } else if (strcmp(word, "halfhang") == 0) {
        printf("half a line");
        for (;;) sink = 1 - sink;
    } else if (strcmp(word, "write") == 0) {
        FILE* left = fopen("/MS/OPEN-R/MW/DATA/P/LEFT.TXT", "w");
        OSYSPRINT(("left behind: %d\n", left != 0 && fputs("left", left) >= 0));
        if (left != 0) fclose(left);
    } else if (strcmp(word, "writes") == 0) {
        WriteInAllWays();
        LeaveStreams();
    } else if (strcmp(word, "shutdown") == 0) {
        OPENR::Shutdown(OBootCondition(obcbPAUSE_SW));
    } else if (strcmp(word, "fatal") == 0) {
        OPENR::Fatal(ofatalMEMORY_STICK);
    } else {
        MakeFault(word);
    }
    OSYSPRINT(("Trouble is running\n"));
    return oSUCCESS;
}

OStatus
Trouble::DoStop(const OSystemEvent&)
{
    OSYSPRINT(("Trouble was stopped\n"));
    return oSUCCESS;
}

OStatus
Trouble::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}
