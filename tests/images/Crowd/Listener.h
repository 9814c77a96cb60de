// Prints the numbers that it receives.
#ifndef Listener_h_DEFINED
#define Listener_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>

#include "def.h"

class Listener : public OObject {
public:
    Listener() {}
    virtual ~Listener() {}

    OSubject*  subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void NotifyIn(const ONotifyEvent& event);
    void Fill(void* msg);
};

#endif  // Listener_h_DEFINED
