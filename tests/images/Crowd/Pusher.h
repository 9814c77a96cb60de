// Sends more messages than the queue of the object listener holds, and a notification behind them.
#ifndef Pusher_h_DEFINED
#define Pusher_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>

#include "def.h"

class Pusher : public OObject {
public:
    Pusher() : pushes_(0) {}
    virtual ~Pusher() {}

    OSubject*  subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void Push(void* msg);

private:
    void Notify(int number);

    int pushes_;
};

#endif  // Pusher_h_DEFINED
