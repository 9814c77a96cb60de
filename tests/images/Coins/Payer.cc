#include "Payer.h"

#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>

Payer::Payer() : isUnderWay_(false), left_(0)
{
    paid_.coin.series = 0;
    paid_.coin.number = 0;
    paid_.acknowledged = 0;
    paid_.lost = 0;
}

OStatus
Payer::DoInit(const OSystemEvent&)
{
    SystemTime now;
    GetSystemTime(&now);
    paid_.coin.series = now.seconds * 1000 + now.useconds / 1000;
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;
    return oSUCCESS;
}

OStatus
Payer::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Payer::DoStop(const OSystemEvent&)
{
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Payer::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

void
Payer::ReadyCoins(const OReadyEvent& event)
{
    if (isUnderWay_) {
        if (event.IsAssert()) {
            if (paid_.acknowledged == 0) OSYSPRINT(("Payer's first coin has been got\n"));
            paid_.acknowledged = paid_.coin.number;
        } else {
            ++paid_.lost;
        }
        isUnderWay_ = false;
    }
    Pay();
}

void
Payer::ReadyBook(const OReadyEvent&)
{
    Pay();
}

void
Payer::NotifySensor(const ONotifyEvent& event)
{
    left_ = 20;
    Pay();
    observer[event.ObsIndex()]->AssertReady();
}

void
Payer::Pay()
{
    if (isUnderWay_ || left_ == 0) return;
    if (!subject[sbjCoins]->IsReady() || !subject[sbjBook]->IsReady()) return;
    --left_;
    ++paid_.coin.number;
    subject[sbjBook]->SetData(&paid_, sizeof(paid_));
    subject[sbjBook]->NotifyObservers();
    subject[sbjCoins]->SetData(&paid_.coin, sizeof(paid_.coin));
    subject[sbjCoins]->NotifyObservers();
    isUnderWay_ = true;
}
