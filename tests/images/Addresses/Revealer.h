// Sends addresses and bytes that it never set: of its regions, heap, statics, code and stack.
#ifndef Revealer_h_DEFINED
#define Revealer_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>
#include <OPENR/RCRegion.h>

#include "def.h"

struct Mostly;

class Revealer : public OObject {
public:
    Revealer() : count_(0), region_(0), kept_(0) {}
    virtual ~Revealer() {}

    OSubject* subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void NotifyBack(const ONotifyEvent& event);

private:
    void SendAddresses();
    void SendUnset();
    void SendMostly(const Mostly& mostly);
    void SendForOneCall();
    void Send(const void* data, size_t size);

    int count_;
    RCRegion* region_;
    void* kept_;  // grows during the run
};

#endif  // Revealer_h_DEFINED
