// Messages to a raw IP endpoint, for protocols other than TCP and UDP.
#ifndef OPENR_IPENDPOINTMSG_H_INCLUDED
#define OPENR_IPENDPOINTMSG_H_INCLUDED

#include <IPv4Types.h>
#include <antEnvMsg.h>

enum IPEndpointError {
  IP_SUCCESS = 0,
  IP_FAIL = 1,
  IP_INVALID_PROTOCOL = 2,
  IP_PACKETSIZE = 3,
  IP_CONNECTION_CLOSED = 4,
  IP_CONNECTION_BUSY = 5,
  IP_BUFFER_INVALID = 6,
  IP_OPERATION_INVALID = 7,
  IP_OPERATION_UNKNOWN = 8
};

enum IPPacketType {
  IP_DATA = 1,
  IP_NETWORK_UNREACHABLE = 2,
  IP_HOST_UNREACHABLE = 3,
  IP_PROTOCOL_UNREACHABLE = 4,
  IP_PORT_UNREACHABLE = 5,
  IP_MESSAGE_TOO_LONG = 6,
  IP_TTL_EXCEEDED = 7,
  IP_TIME_EXCEEDED = 8,
  IP_PACKETTYPE_MAX = 9
};

typedef antOperationMsg<IPEndpointError> IPEndpointMsg;

// Values of dstOperation; the numbers are the robot's, the names ours.
const int32 IPEndpoint_Operation_Bind = 1;
const int32 IPEndpoint_Operation_Send = 2;
const int32 IPEndpoint_Operation_Receive = 3;
const int32 IPEndpoint_Operation_Close = 4;

// IP_INVALID_PROTOCOL for TCP and UDP.
struct IPEndpointBindMsg : public IPEndpointMsg {
  Protocol protocol;

  IPEndpointBindMsg() : IPEndpointMsg(IPEndpoint_Operation_Bind), protocol(0) {}
  IPEndpointBindMsg(antModuleRef& module, Protocol number)
      : IPEndpointMsg(module, IPEndpoint_Operation_Bind), protocol(number) {}
};

struct IPEndpointSendMsg : public IPEndpointMsg {
  IPPacketType type;
  byte* buffer;  // in a shared buffer
  int size;      // bytes

  IPEndpointSendMsg()
      : IPEndpointMsg(IPEndpoint_Operation_Send), type(IP_DATA), buffer(0), size(0) {}
  IPEndpointSendMsg(antModuleRef& module, IPPacketType packetType, byte* data, int bytes)
      : IPEndpointMsg(module, IPEndpoint_Operation_Send),
        type(packetType),
        buffer(data),
        size(bytes) {}
};

struct IPEndpointReceiveMsg : public IPEndpointMsg {
  IPPacketType type;  // out
  byte* buffer;       // in a shared buffer
  int size;           // bytes

  IPEndpointReceiveMsg()
      : IPEndpointMsg(IPEndpoint_Operation_Receive), type(IP_DATA), buffer(0), size(0) {}
  IPEndpointReceiveMsg(antModuleRef& module, byte* data, int bytes)
      : IPEndpointMsg(module, IPEndpoint_Operation_Receive),
        type(IP_DATA),
        buffer(data),
        size(bytes) {}
};

struct IPEndpointCloseMsg : public IPEndpointMsg {
  IPEndpointCloseMsg() : IPEndpointMsg(IPEndpoint_Operation_Close) {}
  IPEndpointCloseMsg(antModuleRef& module) : IPEndpointMsg(module, IPEndpoint_Operation_Close) {}
};

#endif  // OPENR_IPENDPOINTMSG_H_INCLUDED
