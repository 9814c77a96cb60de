// Compares what was paid with what was got.
#ifndef Ledger_h_DEFINED
#define Ledger_h_DEFINED

#include <OPENR/OObject.h>
#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>

#include <map>
#include <set>

#include "Coin.h"
#include "def.h"

class Ledger : public OObject {
public:
    Ledger();
    virtual ~Ledger() {}

    OSubject*  subject[numOfSubject];
    OObserver* observer[numOfObserver];

    virtual OStatus DoInit(const OSystemEvent& event);
    virtual OStatus DoStart(const OSystemEvent& event);
    virtual OStatus DoStop(const OSystemEvent& event);
    virtual OStatus DoDestroy(const OSystemEvent& event);

    void NotifyPaid(const ONotifyEvent& event);
    void NotifyGot(const ONotifyEvent& event);

private:
    struct Series {
        Series() : last(0), acknowledged(0), lost(0) {}
        unsigned int last;          // number of the last coin got
        unsigned int acknowledged;  // number of the last coin acknowledged
        unsigned int lost;          // told by Payer
        std::set<unsigned int> missing;
    };

    std::map<unsigned int, Series> series_;
    unsigned int got_;
    unsigned int twice_;
    unsigned int missed_;  // acknowledged, and never got
    unsigned int lost_;
};

#endif  // Ledger_h_DEFINED
