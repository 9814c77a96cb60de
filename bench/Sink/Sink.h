// Sink: an object that receives data and asserts ready again after each notification.
#ifndef Sink_h_DEFINED
#define Sink_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>

#include "def.h"

class Sink : public OObject {
public:
    OSubject*  subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void NotifyIn(const ONotifyEvent& event);
};

#endif  // Sink_h_DEFINED
