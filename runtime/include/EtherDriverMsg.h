// Arguments of the card functions in ERA201D1.h that every Ethernet card has.
#ifndef OPENR_ETHERDRIVERMSG_H_INCLUDED
#define OPENR_ETHERDRIVERMSG_H_INCLUDED

#include <EtherTypes.h>

// 16 bytes.
struct EtherDriverGetMACAddressMsg {
  int32 port;  // ignored
  EtherMACAddress address;
  EtherStatus status;
};

// 44 bytes.
struct EtherDriverGetStatisticsMsg {
  int32 port;  // ignored
  EtherStatistics statistics;
  EtherStatus status;
};

#endif  // OPENR_ETHERDRIVERMSG_H_INCLUDED
