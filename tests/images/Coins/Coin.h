// The data that Payer, Payee and Ledger send to each other.
//
// Payer pays one coin at a time and books it; Payee books each that it gets before it asserts
// ready.  So Ledger, which nobody kills, can tell whether a coin came twice, and whether one that
// was acknowledged by a ready did not come.
#ifndef Coin_h_DEFINED
#define Coin_h_DEFINED

#include <OPENR/OPENRAPI.h>

struct Coin {
    unsigned int series;   // the time in ms at which the Payer that pays this coin began
    unsigned int number;   // from 1
};

// An entry of Payer's book: this coin is on its way, all earlier coins are acknowledged or lost.
struct Paid {
    Coin coin;
    unsigned int acknowledged;  // number of the last one whose ready came; 0: none
    unsigned int lost;          // how many came back unread
};

#endif  // Coin_h_DEFINED
