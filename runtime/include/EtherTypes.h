// Results, addresses and settings of the wireless card.
#ifndef OPENR_ETHERTYPES_H_INCLUDED
#define OPENR_ETHERTYPES_H_INCLUDED

#include <antTypes.h>

enum EtherStatus {
  ETHER_OK = 0,
  ETHER_UNSUPPORTED = 1,  // the driver object is not loaded
  ETHER_NO_MEMORY = 2,
  ETHER_INVALID_PROTOCOL = 3,
  ETHER_INVALID_ADDRESS = 4,
  ETHER_INVALID_PORT = 5,  // no card in the slot
  ETHER_INVALID_ATTR = 6,
  ETHER_NO_CLIENT_ENTRY = 7,
  ETHER_INVALID_HANDLE = 8,
  ETHER_RCV_IDLE = 9,
  ETHER_RCV_BUSY = 10,
  ETHER_NO_ADDRESS_ENTRY = 11,
  ETHER_NO_DEVICE = 12
};

// The constant's name, "ETHER_OK"; "unknown EtherStatus" for other numbers.
const char* EtherStatusText(int status);
#define etherStatusStr(s) EtherStatusText(s)

struct EtherMACAddress {
  byte octet[6];
};

struct EtherStatistics {
  uint32 carrierSenseErrorCount;
  uint32 lateCollisionCount;
  uint32 excessiveCollisionCount;
  uint32 singleCollisionCount;
  uint32 multipleCollisionCount;
  uint32 deferredCount;
  uint32 alignmentErrorCount;
  uint32 fcsErrorCount;
  uint32 frameTooLongCount;
};

// Longest names, in characters without the closing NUL.
#define ETHER_WLAN_ESSID_MAX 32
#define ETHER_WLAN_STATIONNAME_MAX 32

enum EtherWLANMode { ETHER_WLAN_MODE_ADHOC = 0, ETHER_WLAN_MODE_AP = 1 };

enum EtherWLANEncryption { ETHER_WLAN_ENC_OFF = 0, ETHER_WLAN_ENC_WEP = 1 };

enum EtherWLANRate {
  ETHER_WLAN_RATE_1MB = 0,
  ETHER_WLAN_RATE_2MB = 1,
  ETHER_WLAN_RATE_5_5MB = 2,
  ETHER_WLAN_RATE_11MB = 3,
  ETHER_WLAN_RATE_AUTO = 4
};

enum EtherWLANSensitivity {
  ETHER_WLAN_DENSITY_LOW = 0,
  ETHER_WLAN_DENSITY_MED = 1,
  ETHER_WLAN_DENSITY_HIGH = 2
};

struct EtherWLANStatistics {
  uint8 link;  // %
  uint8 signal;
  uint8 noise;
  uint32 invalidIDCount;
  uint32 invalidEncCount;
  uint32 invalidMiscCount;
};

#endif  // OPENR_ETHERTYPES_H_INCLUDED
