// Sends messages, asks and registers in its constructor, which runs before DoInit.
#ifndef Early_h_DEFINED
#define Early_h_DEFINED

#include <MCOOP.h>
#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>

#include "def.h"

extern const char earlyName[];     // "First" or "Second"
extern const char earlyService[];  // a service that the constructor registers for DoHear

class Early : public OObject {
public:
    Early();
    virtual ~Early() {}

    OSubject*  subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void DoHear(void* message);
    void DoTick(void* message);

private:
    void Report();

    // ---- Results of calls of the constructor
    sError       sent_;
    sError       named_;
    sError       found_;  // result of the search for this object
    OStatus      registered_;
    sError       asked_;
    slongword    queue_;   // limit of waiting messages
    unsigned int made_;    // virtual time, in ms
    int          random_;  // first random number
    RID          box_;
    RID          wrongBox_;  // box of a request to an entry that this object lacks
    int          heard_;     // messages to DoHear
    int          ticks_;     // time events
};

#endif  // Early_h_DEFINED
