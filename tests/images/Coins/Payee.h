// Takes coins, and is ready for the next one when it has booked the last.
#ifndef Payee_h_DEFINED
#define Payee_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>

#include "Coin.h"
#include "def.h"

class Payee : public OObject {
public:
    Payee();
    virtual ~Payee() {}

    OSubject*  subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void NotifyCoins(const ONotifyEvent& event);
    void ReadyBook(const OReadyEvent& event);

private:
    void Book();

    Coin coin_;  // number 0: none
    bool hasBooked_;
};

#endif  // Payee_h_DEFINED
