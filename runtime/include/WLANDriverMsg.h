// Arguments of the card functions in ERA201D1.h that only wireless cards have.
#ifndef OPENR_WLANDRIVERMSG_H_INCLUDED
#define OPENR_WLANDRIVERMSG_H_INCLUDED

#include <EtherTypes.h>

// 104 bytes.
struct EtherDriverGetWLANSettingsMsg {
  int32 port;  // ignored
  EtherWLANMode mode;
  char essid[ETHER_WLAN_ESSID_MAX + 1];
  char stationName[ETHER_WLAN_STATIONNAME_MAX + 1];
  int32 channel;  // 1..11
  EtherWLANEncryption encryption;
  EtherWLANRate rate;
  int32 rts;            // threshold, bytes
  int32 fragmentation;  // threshold, bytes
  EtherWLANSensitivity sensitivity;
  EtherStatus status;
};

// 24 bytes.
struct EtherDriverGetWLANStatisticsMsg {
  int32 port;  // ignored
  EtherWLANStatistics statistics;
  EtherStatus status;
};

#endif  // OPENR_WLANDRIVERMSG_H_INCLUDED
