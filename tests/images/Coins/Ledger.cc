#include "Ledger.h"

#include <MCOOP.h>
#include <OPENR/OSyslog.h>
#include <OPENR/core_macro.h>

Ledger::Ledger() : got_(0), twice_(0), missed_(0), lost_(0)
{
}

OStatus
Ledger::DoInit(const OSystemEvent&)
{
    NEW_ALL_SUBJECT_AND_OBSERVER;
    REGISTER_ALL_ENTRY;
    SET_ALL_READY_AND_NOTIFY_ENTRY;
    return oSUCCESS;
}

OStatus
Ledger::DoStart(const OSystemEvent&)
{
    ENABLE_ALL_SUBJECT;
    ASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Ledger::DoStop(const OSystemEvent&)
{
    OSYSPRINT(("got %u twice %u missed %u lost %u series %u\n", got_, twice_, missed_, lost_,
               (unsigned int)series_.size()));
    OID purse;
    OSYSPRINT(("Purse is %s\n", Find("Purse", &purse) == sSUCCESS ? "there" : "gone"));
    DISABLE_ALL_SUBJECT;
    DEASSERT_READY_TO_ALL_OBSERVER;
    return oSUCCESS;
}

OStatus
Ledger::DoDestroy(const OSystemEvent&)
{
    DELETE_ALL_SUBJECT_AND_OBSERVER;
    return oSUCCESS;
}

void
Ledger::NotifyPaid(const ONotifyEvent& event)
{
    const Paid& paid = *(const Paid*)event.Data(0);
    Series& series = series_[paid.coin.series];
    const unsigned int n = paid.acknowledged;
    if (n != series.acknowledged && (n > series.last || series.missing.count(n) != 0)) {
        ++missed_;
        OSYSPRINT(("MISSED series %u number %u\n", paid.coin.series, n));
    }
    series.acknowledged = paid.acknowledged;
    lost_ += paid.lost - series.lost;
    series.lost = paid.lost;
    observer[event.ObsIndex()]->AssertReady();
}

void
Ledger::NotifyGot(const ONotifyEvent& event)
{
    const Coin& coin = *(const Coin*)event.Data(0);
    Series& series = series_[coin.series];
    ++got_;
    if (coin.number <= series.last) {
        ++twice_;
        OSYSPRINT(("TWICE series %u number %u\n", coin.series, coin.number));
    }
    for (unsigned int n = series.last + 1; n < coin.number; n++) series.missing.insert(n);
    if (coin.number > series.last) series.last = coin.number;
    observer[event.ObsIndex()]->AssertReady();
}
