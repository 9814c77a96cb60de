// Messages to a UDP endpoint.
//
// Bind first; then one send and one receive may be pending at a time.
#ifndef OPENR_UDPENDPOINTMSG_H_INCLUDED
#define OPENR_UDPENDPOINTMSG_H_INCLUDED

#include <IPv4Types.h>
#include <antEnvMsg.h>

enum UDPEndpointError {
  UDP_SUCCESS = 0,
  UDP_FAIL = 1,
  UDP_CONNECTION_CLOSED = 2,
  UDP_CONNECTION_BUSY = 3,
  UDP_ADDRESSINUSE = 4,
  UDP_ADDRESSERROR = 5,
  UDP_PORT_UNREACHABLE = 6,
  UDP_PROTOCOL_UNREACHABLE = 7,
  UDP_HOST_UNREACHABLE = 8,
  UDP_NETWORK_UNREACHABLE = 9,
  UDP_MESSAGE_TOO_LONG = 10,
  UDP_TTL_EXCEEDED = 11,
  UDP_TIME_EXCEEDED = 12,
  UDP_BUFFER_INVALID = 13,
  UDP_OPERATION_INVALID = 14,
  UDP_OPERATION_UNKNOWN = 15,
  UDP_WOULDBLOCK = 16
};

typedef antOperationMsg<UDPEndpointError> UDPEndpointMsg;

// Values of dstOperation; the numbers are the robot's, the names ours.  Numbers 5 to 8 are
// for multicast, which programs cannot use.
const int32 UDPEndpoint_Operation_Bind = 0;
const int32 UDPEndpoint_Operation_Connect = 1;
const int32 UDPEndpoint_Operation_Send = 2;
const int32 UDPEndpoint_Operation_Receive = 3;
const int32 UDPEndpoint_Operation_Close = 4;
const int32 UDPEndpoint_Operation_SetBlockingMode = 9;
const int32 UDPEndpoint_Operation_ReadyForRead = 10;
const int32 UDPEndpoint_Operation_ReadyForWrite = 11;
const int32 UDPEndpoint_Operation_Address = 12;
const int32 UDPEndpoint_Operation_ResetConnect = 13;

// IP_ADDR_ANY and IP_PORT_ANY let the stack choose; the answer holds what it chose.
struct UDPEndpointBindMsg : public UDPEndpointMsg {
  IPAddress address;
  Port port;

  UDPEndpointBindMsg() : UDPEndpointMsg(UDPEndpoint_Operation_Bind), address(0), port(0) {}
  UDPEndpointBindMsg(antModuleRef& module, IPAddress addr, Port portNr)
      : UDPEndpointMsg(module, UDPEndpoint_Operation_Bind), address(addr), port(portNr) {}
};

// Fixes the peer of all later sends and receives.
struct UDPEndpointConnectMsg : public UDPEndpointMsg {
  IPAddress address;
  Port port;

  UDPEndpointConnectMsg() : UDPEndpointMsg(UDPEndpoint_Operation_Connect), address(0), port(0) {}
  UDPEndpointConnectMsg(antModuleRef& module, IPAddress addr, Port portNr)
      : UDPEndpointMsg(module, UDPEndpoint_Operation_Connect), address(addr), port(portNr) {}
};

// Answers when the stack has taken the data.
struct UDPEndpointSendMsg : public UDPEndpointMsg {
  IPAddress address;
  Port port;
  byte* buffer;  // in a shared buffer
  int size;      // bytes

  UDPEndpointSendMsg()
      : UDPEndpointMsg(UDPEndpoint_Operation_Send), address(0), port(0), buffer(0), size(0) {}
  UDPEndpointSendMsg(antModuleRef& module, byte* data, int bytes)
      : UDPEndpointMsg(module, UDPEndpoint_Operation_Send),
        address(0),
        port(0),
        buffer(data),
        size(bytes) {}
  UDPEndpointSendMsg(antModuleRef& module, IPAddress addr, Port portNr, byte* data, int bytes)
      : UDPEndpointMsg(module, UDPEndpoint_Operation_Send),
        address(addr),
        port(portNr),
        buffer(data),
        size(bytes) {}
};

// Answers with one datagram: where it came from and how many bytes; what does not fit is
// lost.
struct UDPEndpointReceiveMsg : public UDPEndpointMsg {
  IPAddress address;
  Port port;
  byte* buffer;  // in a shared buffer
  int size;      // bytes

  UDPEndpointReceiveMsg()
      : UDPEndpointMsg(UDPEndpoint_Operation_Receive), address(0), port(0), buffer(0), size(0) {}
  UDPEndpointReceiveMsg(antModuleRef& module, byte* data, int bytes)
      : UDPEndpointMsg(module, UDPEndpoint_Operation_Receive),
        address(0),
        port(0),
        buffer(data),
        size(bytes) {}
};

struct UDPEndpointCloseMsg : public UDPEndpointMsg {
  bool linger;
  int lingerTime;

  UDPEndpointCloseMsg()
      : UDPEndpointMsg(UDPEndpoint_Operation_Close), linger(false), lingerTime(0) {}
  UDPEndpointCloseMsg(antModuleRef& module, bool lingering = false, int time = 0)
      : UDPEndpointMsg(module, UDPEndpoint_Operation_Close), linger(lingering), lingerTime(time) {}
};

struct UDPEndpointSetBlockingModeMsg : public UDPEndpointMsg {
  bool blocking;

  UDPEndpointSetBlockingModeMsg()
      : UDPEndpointMsg(UDPEndpoint_Operation_SetBlockingMode), blocking(true) {}
  UDPEndpointSetBlockingModeMsg(antModuleRef& module, bool block)
      : UDPEndpointMsg(module, UDPEndpoint_Operation_SetBlockingMode), blocking(block) {}
};

struct UDPEndpointReadyForReadMsg : public UDPEndpointMsg {
  boolean ready;  // out

  UDPEndpointReadyForReadMsg() : UDPEndpointMsg(UDPEndpoint_Operation_ReadyForRead), ready(FALSE) {}
  UDPEndpointReadyForReadMsg(antModuleRef& module)
      : UDPEndpointMsg(module, UDPEndpoint_Operation_ReadyForRead), ready(FALSE) {}
};

struct UDPEndpointReadyForWriteMsg : public UDPEndpointMsg {
  boolean ready;  // out

  UDPEndpointReadyForWriteMsg()
      : UDPEndpointMsg(UDPEndpoint_Operation_ReadyForWrite), ready(FALSE) {}
  UDPEndpointReadyForWriteMsg(antModuleRef& module)
      : UDPEndpointMsg(module, UDPEndpoint_Operation_ReadyForWrite), ready(FALSE) {}
};

// Both ends of the endpoint.
struct UDPEndpointAddressMsg : public UDPEndpointMsg {
  IPAddress lAddress;  // local
  Port lPort;
  IPAddress fAddress;  // of the peer
  Port fPort;

  UDPEndpointAddressMsg()
      : UDPEndpointMsg(UDPEndpoint_Operation_Address),
        lAddress(0),
        lPort(0),
        fAddress(0),
        fPort(0) {}
  UDPEndpointAddressMsg(antModuleRef& module)
      : UDPEndpointMsg(module, UDPEndpoint_Operation_Address),
        lAddress(0),
        lPort(0),
        fAddress(0),
        fPort(0) {}
};

struct UDPEndpointResetConnectMsg : public UDPEndpointMsg {
  UDPEndpointResetConnectMsg() : UDPEndpointMsg(UDPEndpoint_Operation_ResetConnect) {}
  UDPEndpointResetConnectMsg(antModuleRef& module)
      : UDPEndpointMsg(module, UDPEndpoint_Operation_ResetConnect) {}
};

#endif  // OPENR_UDPENDPOINTMSG_H_INCLUDED
