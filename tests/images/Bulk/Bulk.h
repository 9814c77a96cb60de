// Sends a megabyte and a number, as often as everybody is ready for it, to others and to itself.
#ifndef Bulk_h_DEFINED
#define Bulk_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>

#include "def.h"

class Bulk : public OObject {
public:
    Bulk() : round_(0) {}

    OSubject*  subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void ReadyOut(const OReadyEvent& event);
    void NotifyIn(const ONotifyEvent& event);
    void NotifySums(const ONotifyEvent& event);

private:
    unsigned int round_;
};

#endif  // Bulk_h_DEFINED
