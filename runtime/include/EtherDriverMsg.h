// The arguments of the two functions of ERA201D1.h that return the MAC address and the error
// counters of the network card, and the messages to the driver of the card.
#ifndef OPENR_ETHERDRIVERMSG_H_INCLUDED
#define OPENR_ETHERDRIVERMSG_H_INCLUDED

#include <EtherTypes.h>

// The argument of ERA201D1_GetMACAddress(), 16 bytes.
struct EtherDriverGetMACAddressMsg {
  int32 port;  // ignored
  EtherMACAddress address;
  EtherStatus status;
};

// The argument of ERA201D1_GetEtherStatistics(), 44 bytes.
struct EtherDriverGetStatisticsMsg {
  int32 port;  // ignored
  EtherStatistics statistics;
  EtherStatus status;
};

// ---- messages to the driver of the network card
//
// On the robot only the network stack sends these messages; applications cannot, and the host has
// no driver.  The messages are declared because sources of old programs name them.

// The number of a client of the network card's driver; the network stack is such a client.  The
// driver gives this number when the client registers.
typedef longword EtherClientHandle;

struct EtherDeviceInfo {
  longword nrPorts;
  longword capabilities;
};

struct EtherDriverGetDeviceInfoMsg {
  EtherDeviceInfo deviceInfo;  // set by the driver
  EtherStatus status;
};

struct EtherDriverGetDeviceModeMsg {
  longword port;
  EtherDeviceMode mode;  // set by the driver
  EtherStatus status;
};

struct EtherDriverSetDeviceModeMsg {
  longword port;
  EtherDeviceMode mode;
  EtherStatus status;
};

struct EtherDriverSetMACAddressMsg {
  longword port;
  EtherMACAddress address;
  EtherStatus status;
};

struct EtherDriverRegisterClientMsg {
  longword port;
  OID client;
  longword txmitNotification;  // selector of the client's entry for reports about sent frames
  longword rcvNotification;
  void* cookie;               // a value of the client, which the driver repeats in every report
  unsigned int txmitBufSize;  // in bytes
  unsigned int rcvBufSize;    // in bytes
  EtherClientHandle clientHandle;
  EtherFrameBufferID bufferID;
  EtherStatus status;
};

struct EtherDriverDeregisterClientMsg {
  EtherClientHandle client;
  EtherStatus status;
};

struct EtherDriverAddAddressMsg {
  EtherClientHandle client;
  EtherMACAddress address;
  EtherStatus status;
};

struct EtherDriverRemoveAddressMsg {
  EtherClientHandle client;
  EtherMACAddress address;
  EtherStatus status;
};

struct EtherDriverStartReceiveMsg {
  EtherClientHandle client;
  EtherProtocolType proto;
  EtherStatus status;
};

struct EtherDriverStopReceiveMsg {
  EtherClientHandle client;
  EtherProtocolType proto;
  EtherStatus status;
};

struct EtherDriverStartReceivePromiscMsg {
  EtherClientHandle client;
  EtherPromiscLevel level;
  EtherStatus status;
};

struct EtherDriverStopReceivePromiscMsg {
  EtherClientHandle client;
  EtherPromiscLevel level;
  EtherProtocolType proto;
  EtherStatus status;
};

struct EtherDriverTransmitMsg {
  EtherClientHandle client;
  longword nrFrames;
  EtherTxmitNotificationFlag flag;
};

struct EtherDriverTxmitNotificationMsg {
  longword frameCount;
  EtherClientHandle client;
  void* cookie;
  EtherStatus status;
};

struct EtherDriverRcvNotificationMsg {
  longword frameCount;
  EtherClientHandle client;
  void* cookie;
};

#endif  // OPENR_ETHERDRIVERMSG_H_INCLUDED
