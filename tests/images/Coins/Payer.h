// Pays coins, one at a time: the next when the last one was acknowledged, some at each vector of
// sensor values.
#ifndef Payer_h_DEFINED
#define Payer_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>

#include "Coin.h"
#include "def.h"

class Payer : public OObject {
public:
    Payer();
    virtual ~Payer() {}

    OSubject*  subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void ReadyCoins(const OReadyEvent& event);
    void ReadyBook(const OReadyEvent& event);
    void NotifySensor(const ONotifyEvent& event);

private:
    void Pay();

    Paid paid_;
    bool isUnderWay_;
    int  left_;  // coins that may be paid until the next vector
};

#endif  // Payer_h_DEFINED
