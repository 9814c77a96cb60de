// Results, addresses and settings of the wireless card.
#ifndef OPENR_ETHERTYPES_H_INCLUDED
#define OPENR_ETHERTYPES_H_INCLUDED

#include <antTypes.h>

#include <iostream>

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

// Returns the name of the status constant, such as "ETHER_OK".  Returns "unknown EtherStatus" for a
// number that belongs to no constant.
const char* EtherStatusText(int status);
#define etherStatusStr(s) EtherStatusText(s)

// Writes the name of the status constant, such as "ETHER_OK".
std::ostream& operator<<(std::ostream& out, EtherStatus status);

// ---- Ethernet addresses and Ethernet frames

#define ETHER_ADDR_LEN 6  // in octets

// An Ethernet address, 6 bytes in the order in which they are sent.
struct EtherMACAddress {
  // The six octets of an Ethernet address as three words.
  struct Opt {
    word w1;
    word w2;
    word w3;
  };

  byte octet[ETHER_ADDR_LEN];

  EtherMACAddress() { Set(0, 0, 0, 0, 0, 0); }  // sets 00:00:00:00:00:00
  EtherMACAddress(byte* octets) {
    Set(octets[0], octets[1], octets[2], octets[3], octets[4], octets[5]);
  }
  EtherMACAddress(byte o1, byte o2, byte o3, byte o4, byte o5, byte o6) {
    Set(o1, o2, o3, o4, o5, o6);
  }

  // Returns whether this is the address of all stations, ff:ff:ff:ff:ff:ff.
  bool IsBroadcast() const {
    for (int i = 0; i < ETHER_ADDR_LEN; i++) {
      if (octet[i] != 0xff) return false;
    }
    return true;
  }
  // Returns whether this is the address of a group of stations or of all stations.  In such an
  // address the bit that is sent first is 1.
  bool IsMulticast() const { return (octet[0] & 1) != 0; }

  // Copies the six octets of this address to `octets`.
  void ToByte(byte* octets) const {
    for (int i = 0; i < ETHER_ADDR_LEN; i++) octets[i] = octet[i];
  }

  bool operator==(const EtherMACAddress& other) const {
    for (int i = 0; i < ETHER_ADDR_LEN; i++) {
      if (octet[i] != other.octet[i]) return false;
    }
    return true;
  }
  bool operator!=(const EtherMACAddress& other) const { return !(*this == other); }

 private:
  void Set(byte o1, byte o2, byte o3, byte o4, byte o5, byte o6) {
    octet[0] = o1;
    octet[1] = o2;
    octet[2] = o3;
    octet[3] = o4;
    octet[4] = o5;
    octet[5] = o6;
  }
};

// Writes the address in the form "02:00:00:00:00:01".
std::ostream& operator<<(std::ostream& out, const EtherMACAddress& address);

// The protocol of an Ethernet frame: a value of the field ether_type, whose high byte is sent
// first.
typedef word EtherProtocolType;

enum EtherFrameType {  // the name of the type is our choice
  ETHER_FRAMETYPE_ETHERNET_II = 0,
  ETHER_FRAMETYPE_IEEE_802_3 = 1
};

// The first 14 bytes of an Ethernet II frame.
struct ether_header {
  byte ether_dhost[ETHER_ADDR_LEN];  // address of the receiver
  byte ether_shost[ETHER_ADDR_LEN];  // address of the sender
  word ether_type;
};

// The first 22 bytes of a network frame of IEEE 802.3 with a SNAP header.
struct ether_802_3_header {
  byte ether_dhost[ETHER_ADDR_LEN];  // address of the receiver
  byte ether_shost[ETHER_ADDR_LEN];  // address of the sender
  word ether_size;
  byte dsap;
  byte ssap;
  byte ctrl;
  byte code[3];
  word ether_type;
};

// The shared memory through which the driver of the network card and its user pass Ethernet frames;
// not used on the host.
struct EtherFrameBufferID {
  MemoryRegionID rcvID;
  unsigned int rcvsize;  // in bytes
  void* rcvbase;
  MemoryRegionID txID;
  unsigned int txsize;  // in bytes
  void* txbase;
};

// ---- settings and counters of the network card

enum EtherDeviceMode {
  ETHER_MODE_10BASET = 0,
  ETHER_MODE_10BASET_FULLDUPLEX = 1,
  ETHER_MODE_100BASETX = 2,
  ETHER_MODE_100BASETX_FULLDUPLEX = 3,
  ETHER_MODE_100BASET4 = 4,
  ETHER_MODE_AUTONEGOTIATION = 5
};

// The level of the promiscuous mode, in which the user of the network card also gets Ethernet
// frames that are addressed to other receivers.
enum EtherPromiscLevel { ETHER_PROMISC_PHYS = 1, ETHER_PROMISC_RAW = 2, ETHER_PROMISC_MULTI = 4 };

// The moment at which the driver of the network card reports that Ethernet frames have been sent.
enum EtherTxmitNotificationFlag {
  ETHER_NOTIFY_NEVER = 1,
  ETHER_NOTIFY_ONCE = 2,
  ETHER_NOTIFY_FREED = 4
};

// The error counters of a network card, 36 bytes.
struct EtherDriverStatistics {
  longword carrier_sense_error_count;
  longword late_collision_count;
  longword excessive_collision_count;
  longword single_collision_count;
  longword multiple_collision_count;
  longword deferred_count;
  longword alignment_error_count;
  longword fcs_error_count;
  longword frame_too_long_count;
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

// Limits for the name of a wireless network (ESSID) and the name of a station, in characters
// without the closing NUL.
#define ETHER_WLAN_ESSID_MAX 32
#define ETHER_WLAN_STATIONNAME_MAX 32
// Sizes in bytes of the two kinds of WEP key, inferred from the sizes of the messages to the driver
// of the wireless card.
#define ETHER_WLAN_ENC_MAX 5
#define ETHER_WLAN_ENC_128_MAX 13

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
  uint8 link;  // quality of the link in %
  uint8 signal;
  uint8 noise;
  uint32 invalidIDCount;
  uint32 invalidEncCount;
  uint32 invalidMiscCount;
};

#endif  // OPENR_ETHERTYPES_H_INCLUDED
