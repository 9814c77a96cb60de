// Messages to a UDP endpoint.
//
// An endpoint must be bound first.  Then one send and one receive may wait for their answers at a
// time.
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

// Writes the name of the error's constant, such as "UDP_FAIL".  Writes "unknown UDPEndpointError"
// for a number that belongs to no constant.
std::ostream& operator<<(std::ostream& out, UDPEndpointError error);

// The base class of all messages to a UDP endpoint.
struct UDPEndpointBaseMsg : public antOperationMsg<UDPEndpointError> {
  UDPEndpointBaseMsg(int32 operation = 0) : antOperationMsg<UDPEndpointError>(operation) {}
  UDPEndpointBaseMsg(antModuleRef& module, int32 operation)
      : antOperationMsg<UDPEndpointError>(module, operation) {}
};

// The operations that a message to a UDP endpoint can request (field dstOperation).  The numbers
// are those of the robot, the names are our choice.  Numbers 5 to 8 are for multicast, which
// programs cannot use.
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

// Binds the endpoint.  With IP_ADDR_ANY and IP_PORT_ANY the network stack chooses; the answer
// contains the chosen address and port.
struct UDPEndpointBindMsg : public UDPEndpointBaseMsg {
  IPAddress address;
  Port port;

  UDPEndpointBindMsg() : UDPEndpointBaseMsg(UDPEndpoint_Operation_Bind), address(0), port(0) {}
  UDPEndpointBindMsg(antModuleRef& module, IPAddress addr, Port portNr)
      : UDPEndpointBaseMsg(module, UDPEndpoint_Operation_Bind), address(addr), port(portNr) {}
};

// Sets the peer of all later sends and receives of the endpoint.
struct UDPEndpointConnectMsg : public UDPEndpointBaseMsg {
  IPAddress address;
  Port port;

  UDPEndpointConnectMsg()
      : UDPEndpointBaseMsg(UDPEndpoint_Operation_Connect), address(0), port(0) {}
  UDPEndpointConnectMsg(antModuleRef& module, IPAddress addr, Port portNr)
      : UDPEndpointBaseMsg(module, UDPEndpoint_Operation_Connect), address(addr), port(portNr) {}
};

// Sends one datagram.  The answer comes when the network stack has accepted the data.
struct UDPEndpointSendMsg : public UDPEndpointBaseMsg {
  IPAddress address;
  Port port;
  byte* buffer;  // must point into a shared buffer
  int size;      // in bytes

  UDPEndpointSendMsg()
      : UDPEndpointBaseMsg(UDPEndpoint_Operation_Send), address(0), port(0), buffer(0), size(0) {}
  UDPEndpointSendMsg(antModuleRef& module, byte* data, int bytes)
      : UDPEndpointBaseMsg(module, UDPEndpoint_Operation_Send),
        address(0),
        port(0),
        buffer(data),
        size(bytes) {}
  UDPEndpointSendMsg(antModuleRef& module, IPAddress addr, Port portNr, byte* data, int bytes)
      : UDPEndpointBaseMsg(module, UDPEndpoint_Operation_Send),
        address(addr),
        port(portNr),
        buffer(data),
        size(bytes) {}
};

// Receives one datagram.  The answer contains the sender and the size of the datagram; bytes that
// do not fit into the buffer are lost.
struct UDPEndpointReceiveMsg : public UDPEndpointBaseMsg {
  IPAddress address;
  Port port;
  byte* buffer;  // must point into a shared buffer
  int size;      // in bytes

  UDPEndpointReceiveMsg()
      : UDPEndpointBaseMsg(UDPEndpoint_Operation_Receive),
        address(0),
        port(0),
        buffer(0),
        size(0) {}
  UDPEndpointReceiveMsg(antModuleRef& module, byte* data, int bytes)
      : UDPEndpointBaseMsg(module, UDPEndpoint_Operation_Receive),
        address(0),
        port(0),
        buffer(data),
        size(bytes) {}
};

struct UDPEndpointCloseMsg : public UDPEndpointBaseMsg {
  bool linger;
  int lingerTime;

  UDPEndpointCloseMsg()
      : UDPEndpointBaseMsg(UDPEndpoint_Operation_Close), linger(false), lingerTime(0) {}
  UDPEndpointCloseMsg(antModuleRef& module, bool lingering = false, int time = 0)
      : UDPEndpointBaseMsg(module, UDPEndpoint_Operation_Close),
        linger(lingering),
        lingerTime(time) {}
};

struct UDPEndpointSetBlockingModeMsg : public UDPEndpointBaseMsg {
  bool blocking;

  UDPEndpointSetBlockingModeMsg()
      : UDPEndpointBaseMsg(UDPEndpoint_Operation_SetBlockingMode), blocking(true) {}
  UDPEndpointSetBlockingModeMsg(antModuleRef& module, bool block)
      : UDPEndpointBaseMsg(module, UDPEndpoint_Operation_SetBlockingMode), blocking(block) {}
};

struct UDPEndpointReadyForReadMsg : public UDPEndpointBaseMsg {
  boolean ready;  // set in the answer of the network stack to this message

  UDPEndpointReadyForReadMsg()
      : UDPEndpointBaseMsg(UDPEndpoint_Operation_ReadyForRead), ready(FALSE) {}
  UDPEndpointReadyForReadMsg(antModuleRef& module)
      : UDPEndpointBaseMsg(module, UDPEndpoint_Operation_ReadyForRead), ready(FALSE) {}
};

struct UDPEndpointReadyForWriteMsg : public UDPEndpointBaseMsg {
  boolean ready;  // set in the answer of the network stack to this message

  UDPEndpointReadyForWriteMsg()
      : UDPEndpointBaseMsg(UDPEndpoint_Operation_ReadyForWrite), ready(FALSE) {}
  UDPEndpointReadyForWriteMsg(antModuleRef& module)
      : UDPEndpointBaseMsg(module, UDPEndpoint_Operation_ReadyForWrite), ready(FALSE) {}
};

// Asks for the addresses of the endpoint and of its peer.
struct UDPEndpointAddressMsg : public UDPEndpointBaseMsg {
  IPAddress lAddress;  // own address
  Port lPort;
  IPAddress fAddress;  // address of the peer
  Port fPort;

  UDPEndpointAddressMsg()
      : UDPEndpointBaseMsg(UDPEndpoint_Operation_Address),
        lAddress(0),
        lPort(0),
        fAddress(0),
        fPort(0) {}
  UDPEndpointAddressMsg(antModuleRef& module)
      : UDPEndpointBaseMsg(module, UDPEndpoint_Operation_Address),
        lAddress(0),
        lPort(0),
        fAddress(0),
        fPort(0) {}
};

struct UDPEndpointResetConnectMsg : public UDPEndpointBaseMsg {
  UDPEndpointResetConnectMsg() : UDPEndpointBaseMsg(UDPEndpoint_Operation_ResetConnect) {}
  UDPEndpointResetConnectMsg(antModuleRef& module)
      : UDPEndpointBaseMsg(module, UDPEndpoint_Operation_ResetConnect) {}
};

#endif  // OPENR_UDPENDPOINTMSG_H_INCLUDED
