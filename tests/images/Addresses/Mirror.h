// Answers every notification with the addresses at which it received the data, and with some of its
// own.
#ifndef Mirror_h_DEFINED
#define Mirror_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>

#include "def.h"

class Mirror : public OObject {
public:
    Mirror() {}
    virtual ~Mirror() {}

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void NotifyIn(const ONotifyEvent& event);
};

#endif  // Mirror_h_DEFINED
