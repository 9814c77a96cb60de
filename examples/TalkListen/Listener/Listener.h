//
// Listener prints the lines that it receives.
//
//   Listener.Hear <- Talker.Say
//

#ifndef Listener_h_DEFINED
#define Listener_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OSubject.h>
#include <OPENR/OObserver.h>

#include "def.h"

class Listener : public OObject {
public:
    Listener() {}
    virtual ~Listener() {}

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void NotifyHear(const ONotifyEvent& event);
};

#endif  // Listener_h_DEFINED
