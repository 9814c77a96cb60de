// Arguments of the two functions of ERA201D1.h that return the settings and the statistics of the
// wireless card, and messages to the driver of the card.
#ifndef OPENR_WLANDRIVERMSG_H_INCLUDED
#define OPENR_WLANDRIVERMSG_H_INCLUDED

#include <EtherTypes.h>

// The argument of ERA201D1_GetWLANSettings(), 104 bytes.
struct EtherDriverGetWLANSettingsMsg {
  int32 port;  // ignored
  EtherWLANMode mode;
  char essid[ETHER_WLAN_ESSID_MAX + 1];
  char stationName[ETHER_WLAN_STATIONNAME_MAX + 1];
  int32 channel;  // 1..11
  EtherWLANEncryption encryption;
  EtherWLANRate rate;
  int32 rts;            // threshold in bytes
  int32 fragmentation;  // threshold in bytes
  EtherWLANSensitivity sensitivity;
  EtherStatus status;
};

// The argument of ERA201D1_GetWLANStatistics(), 24 bytes.
struct EtherDriverGetWLANStatisticsMsg {
  int32 port;  // ignored
  EtherWLANStatistics statistics;
  EtherStatus status;
};

// ---- messages to the driver of the wireless card
//
// The messages change the settings of WLANCONF.TXT.  Objects of users cannot send them to the
// driver of the wireless card.  They are declared because sources of old programs name them.

struct EtherDriverSetWLANModeMsg {
  longword port;
  EtherWLANMode mode;
  EtherStatus status;
};

struct EtherDriverSetWLANESSIDMsg {
  longword port;
  char essid[ETHER_WLAN_ESSID_MAX];
  longword length;
  EtherStatus status;
};

struct EtherDriverSetWLANStationNameMsg {
  longword port;
  char stationName[ETHER_WLAN_STATIONNAME_MAX];
  longword length;
  EtherStatus status;
};

struct EtherDriverSetWLANChannelMsg {
  longword port;
  longword channel;
  EtherStatus status;
};

struct EtherDriverSetWLANEncryptionMsg {
  longword port;
  EtherWLANEncryption type;
  char key[ETHER_WLAN_ENC_MAX];
  EtherStatus status;
};

struct EtherDriverSetWLANEncryption128Msg {
  longword port;
  EtherWLANEncryption type;
  char key[ETHER_WLAN_ENC_128_MAX];
  EtherStatus status;
};

struct EtherDriverSetWLANRateMsg {
  longword port;
  EtherWLANRate rate;
  EtherStatus status;
};

struct EtherDriverSetWLANMediumReservationMsg {
  longword port;
  longword threshold;
  EtherStatus status;
};

struct EtherDriverSetWLANFragmentationMsg {
  longword port;
  longword threshold;
  EtherStatus status;
};

struct EtherDriverSetWLANSensitivityMsg {
  longword port;
  EtherWLANSensitivity sensitivity;
  EtherStatus status;
};

#endif  // OPENR_WLANDRIVERMSG_H_INCLUDED
