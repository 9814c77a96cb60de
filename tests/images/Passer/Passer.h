// Begins with a 1 and passes on what it gets, one more each time, up to 4000; counts the
// sensor vectors that it hears.  Many of them make a ring, each under a name of its own: tests put
// it in place of Passer00.
#ifndef Passer_h_DEFINED
#define Passer_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>

#include "def.h"

class Passer : public OObject {
public:
    Passer() : next_(1), sensors_(0) {}

    OSubject*  subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void ReadyOut(const OReadyEvent& event);
    void NotifyIn(const ONotifyEvent& event);
    void NotifySensor(const ONotifyEvent& event);

private:
    void PassOn();

    unsigned int next_;  // to be passed on; 0: nothing
    unsigned int sensors_;
};

#endif  // Passer_h_DEFINED
