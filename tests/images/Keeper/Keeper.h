// Everything it says depends on all it has heard: it keeps a map in its heap, a count in a
// static, and its answers go round to itself.
#ifndef Keeper_h_DEFINED
#define Keeper_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>

#include <map>
#include <string>

#include "def.h"

class Keeper : public OObject {
public:
    Keeper() {}
    virtual ~Keeper() {}

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void NotifySensor(const ONotifyEvent& event);
    void NotifyIn(const ONotifyEvent& event);

private:
    std::map<int, std::string> kept_;
};

#endif  // Keeper_h_DEFINED
