#include "Payee.h"

#include <MCOOP.h>
#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>
#include <stdio.h>

// A test changes a word of this text in the image, so that the image counts as new code.
static const char edition[] = "edition one";

// Whether coin 30 brings this object down.
static bool
IsFragile()
{
    FILE* file = fopen("/MS/OPEN-R/MW/DATA/P/FRAGILE.TXT", "r");
    if (file == NULL) return false;
    fclose(file);
    return true;
}

Payee::Payee() : hasBooked_(false)
{
    coin_.series = 0;
    coin_.number = 0;
}

OStatus
Payee::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;
    OSYSPRINT(("Payee registers Purse: %d\n", (int)Register(myOID_, "Purse")));
    return oSUCCESS;
}

OStatus
Payee::DoStart(const OSystemEvent&)
{
    OSYSPRINT(("Payee, %s\n", edition));
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Payee::DoStop(const OSystemEvent&)
{
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Payee::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

void
Payee::NotifyCoins(const ONotifyEvent& event)
{
    coin_ = *(const Coin*)event.Data(0);
    if (coin_.number == 30 && IsFragile()) *(volatile int*)16 = 1;
    Book();
}

void
Payee::ReadyBook(const OReadyEvent&)
{
    Book();
}

void
Payee::Book()
{
    if (coin_.number == 0 || !subject[sbjBook]->IsReady()) return;
    subject[sbjBook]->SetData(&coin_, sizeof(coin_));
    subject[sbjBook]->NotifyObservers();
    if (!hasBooked_) OSYSPRINT(("Payee has booked its first coin\n"));
    hasBooked_ = true;
    coin_.number = 0;
    observer[obsCoins]->AssertReady();
}
