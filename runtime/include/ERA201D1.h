// Functions that read the state of the wireless card.  Each function fills in its argument and
// returns the status, which is also a field of the argument.  The status is ETHER_INVALID_PORT
// without a card, ETHER_UNSUPPORTED without the driver of the card.
#ifndef OPENR_ERA201D1_H_INCLUDED
#define OPENR_ERA201D1_H_INCLUDED

#include <EtherDriverMsg.h>
#include <EtherTypes.h>
#include <WLANDriverMsg.h>

extern "C" {

EtherStatus ERA201D1_GetMACAddress(EtherDriverGetMACAddressMsg* msg);
EtherStatus ERA201D1_GetEtherStatistics(EtherDriverGetStatisticsMsg* msg);
EtherStatus ERA201D1_GetWLANSettings(EtherDriverGetWLANSettingsMsg* msg);
EtherStatus ERA201D1_GetWLANStatistics(EtherDriverGetWLANStatisticsMsg* msg);

}  // extern "C"

#endif  // OPENR_ERA201D1_H_INCLUDED
