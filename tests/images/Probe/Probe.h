// An object whose only purpose is to be loaded by tests: it answers every text with
// what it finds out.
#ifndef Probe_h_DEFINED
#define Probe_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>

#include <string>
#include <vector>

#include "def.h"

class Probe : public OObject {
public:
    Probe();

    OSubject*  subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void ReadyOut(const OReadyEvent& event);
    void NotifyIn(const ONotifyEvent& event);
    void DoExit(void* msg);
    void DoAbort(void* msg);
    void DoThrow(void* msg);
    void DoEarly(void* msg);

private:
    void        Say(const std::string& text);
    std::string Answer(const std::string& command);

    bool                     oidWasKnown;
    std::vector<std::string> heard;
};

#endif  // Probe_h_DEFINED
