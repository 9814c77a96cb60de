#include "Revealer.h"

#include <MCOOP.h>
#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int aStatic;
static const int ROUNDS = 40;

// A virtual function: the object begins with the address of a table in the image.
struct Shape {
    virtual ~Shape() {}
    virtual int Sides() { return 3; }
    int size;
};

// Most of it is never set; the compiler clears variables, but not objects without a name.
struct Mostly {
    explicit Mostly(int k) : kind(k), last(1) {}
    int kind;
    long rest[40];
    char last;
};

static Mostly
MakeMostly()
{
    Mostly made(3);
    made.kind = 4;
    return made;
}

// Three bytes behind the first one are padding, and the constructor forgets a member.
struct Holes {
    explicit Holes(char k) : kind(k) {}
    char kind;
    int set[2];
    char last;
};

OStatus
Revealer::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;
    return oSUCCESS;
}

OStatus
Revealer::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    region_ = new RCRegion(100000);
    FILE* file = fopen("/MS/OPEN-R/MW/DATA/P/HOST.TXT", "r");
    if (file != 0) {
        // An address that no plan can hold: that of an object of the C library.
        const void* words[] = {0, stdout};
        Send(words, sizeof(words));
        fclose(file);
    } else {
        SendAddresses();
    }
    return oSUCCESS;
}

OStatus
Revealer::DoStop(const OSystemEvent&)
{
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Revealer::DoDestroy(const OSystemEvent&)
{
    region_->RemoveReference();
    free(kept_);
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

void
Revealer::Send(const void* data, size_t size)
{
    subject[sbjOut]->SetData(data, size);
    subject[sbjOut]->NotifyObservers();
}

void
Revealer::SendAddresses()
{
    int aLocal = 0;
    Shape shape;
    shape.size = 1;
    void* vtable;
    memcpy(&vtable, (const void*)&shape, sizeof(vtable));
    void* own = 0;
    NewRegion(5000, &own);
    RCRegion* small = new RCRegion(20);
    char* small_heap = new char[20];
    char* large_heap = new char[200000];

    const void* addresses[] = {
        region_->Base(), small->Base(), small_heap, large_heap, own,     this,
        &aStatic,        &aLocal,       vtable,     "a literal", subject, (void*)&ROUNDS,
        (void*)&puts};
    Send(addresses, sizeof(addresses));

    DeleteRegion(own);
    small->RemoveReference();
    delete[] small_heap;
    delete[] large_heap;
}

// Sends bytes that were never set.  They must not show what the C library and the SDK have left.
void
Revealer::SendUnset()
{
    FILE* file = fopen("/MS/OPEN-R/MW/CONF/OBJECT.CFG", "r");
    char line[80];
    fgets(line, sizeof(line), file);
    fclose(file);
    sprintf(line, "%d of %f", count_, 1.5);

    // Larger than a page together, so that both come from places that fopen() has used.
    char* bytes = (char*)malloc(6000);
    char* more = (char*)malloc(480);
    Holes here('h');
    unsigned char all[sizeof(Holes) * 2 + 6000 + 480];
    memcpy(all, &here, sizeof(Holes));
    memcpy(all + sizeof(Holes), &static_cast<const Holes&>(Holes('t')), sizeof(Holes));
    memcpy(all + sizeof(Holes) * 2, bytes, 6000);
    memcpy(all + sizeof(Holes) * 2 + 6000, more, 480);
    Send(all, sizeof(all));
    free(bytes);
    free(more);
}

__attribute__((noinline)) void
Revealer::SendMostly(const Mostly& mostly)
{
    Send(&mostly, sizeof(mostly));
}

// Is called after a function of the C library, which left its own addresses on a stack that they
// share.  The compiler does not clear an object that exists for a call only.
__attribute__((noinline)) void
Revealer::SendForOneCall()
{
    SendMostly(Mostly(count_));
}

void
Revealer::NotifyBack(const ONotifyEvent& event)
{
    const void* received = event.Data(0);
    if (count_ % 8 == 0) kept_ = realloc(kept_, (size_t)(1 + count_) * 1000);
    char line[80];
    sprintf(line, "%d of %f", count_, 0.5);
    const Mostly& nameless = Mostly(count_);
    const Mostly made = MakeMostly();
    if (++count_ < ROUNDS && count_ % 8 == 3) {
        Send(&nameless, sizeof(nameless));
    } else if (count_ < ROUNDS && count_ % 8 == 6) {
        SendForOneCall();
    } else if (count_ < ROUNDS && count_ % 8 == 7) {
        Send(&made, sizeof(made));
    } else if (count_ < ROUNDS) {
        if (count_ % 2 == 0) SendAddresses();
        else if (count_ % 4 == 1) SendUnset();
        else Send(&received, sizeof(received));
    }
    observer[event.ObsIndex()]->AssertReady();
}
