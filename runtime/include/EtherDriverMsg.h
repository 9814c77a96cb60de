// Arguments of the card functions in ERA201D1.h that every Ethernet card has, and the messages of
// its driver.
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

// ---- messages to the driver
//
// They are for the network stack, which the robot has and an application cannot reach; on the
// host nobody takes them.  They are here for sources that name them.

typedef longword EtherClientHandle;  // given by RegisterClient

struct EtherDeviceInfo {
  longword nrPorts;
  longword capabilities;
};

struct EtherDriverGetDeviceInfoMsg {
  EtherDeviceInfo deviceInfo;  // out
  EtherStatus status;
};

struct EtherDriverGetDeviceModeMsg {
  longword port;
  EtherDeviceMode mode;  // out
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
  longword txmitNotification;  // selectors of the client
  longword rcvNotification;
  void* cookie;               // comes back with every notification
  unsigned int txmitBufSize;  // bytes
  unsigned int rcvBufSize;    // bytes
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
