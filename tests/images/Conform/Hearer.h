// An object that does what texts tell it with its observers, and prints what it hears.
#ifndef Hearer_h_DEFINED
#define Hearer_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>

#include "def.h"

class Hearer : public OObject {
public:
    Hearer() : kept(0), memory(0), asserts(false), keeps(false), remembers(false) {}

    OSubject*  subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void NotifyIn(const ONotifyEvent& event);
    void NotifyLate(const ONotifyEvent& event);
    void Command(void* msg);

private:
    void Print(const char* who, const ONotifyEvent& event);

    RCRegion*     kept;
    volatile int* memory;     // where the data of the last notification were
    bool          asserts;    // after every notification
    bool          keeps;      // the next region
    bool          remembers;  // in `memory`
};

#endif  // Hearer_h_DEFINED
