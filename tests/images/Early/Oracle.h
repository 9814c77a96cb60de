// Answers requests with their number.
#ifndef Oracle_h_DEFINED
#define Oracle_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>

#include "def.h"

class Oracle : public OObject {
public:
    Oracle() : count_(0) {}
    virtual ~Oracle() {}

    OSubject*  subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void DoAnswer(void* message);

private:
    int count_;  // requests so far
};

#endif  // Oracle_h_DEFINED
