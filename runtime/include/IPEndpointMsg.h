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

// Writes the name of the error's constant, such as "IP_FAIL".  Writes "unknown IPEndpointError" for
// a number that belongs to no constant.
std::ostream& operator<<(std::ostream& out, IPEndpointError error);

// The base class of all messages to a raw IP endpoint.
struct IPEndpointBaseMsg : public antOperationMsg<IPEndpointError> {
  IPEndpointBaseMsg(int32 operation = 0) : antOperationMsg<IPEndpointError>(operation) {}
  IPEndpointBaseMsg(antModuleRef& module, int32 operation)
      : antOperationMsg<IPEndpointError>(module, operation) {}
};

// The operations that a message to a raw IP endpoint can request (field dstOperation).  The numbers
// are those of the robot, the names are our choice.
const int32 IPEndpoint_Operation_Bind = 1;
const int32 IPEndpoint_Operation_Send = 2;
const int32 IPEndpoint_Operation_Receive = 3;
const int32 IPEndpoint_Operation_Close = 4;

// Selects the protocol of a raw IP endpoint.  The error is IP_INVALID_PROTOCOL for TCP and UDP.
struct IPEndpointBindMsg : public IPEndpointBaseMsg {
  Protocol protocol;

  IPEndpointBindMsg() : IPEndpointBaseMsg(IPEndpoint_Operation_Bind), protocol(0) {}
  IPEndpointBindMsg(antModuleRef& module, Protocol number)
      : IPEndpointBaseMsg(module, IPEndpoint_Operation_Bind), protocol(number) {}
};

struct IPEndpointSendMsg : public IPEndpointBaseMsg {
  IPPacketType type;
  byte* buffer;  // must point into a shared buffer
  int size;      // in bytes

  IPEndpointSendMsg()
      : IPEndpointBaseMsg(IPEndpoint_Operation_Send), type(IP_DATA), buffer(0), size(0) {}
  IPEndpointSendMsg(antModuleRef& module, IPPacketType packetType, byte* data, int bytes)
      : IPEndpointBaseMsg(module, IPEndpoint_Operation_Send),
        type(packetType),
        buffer(data),
        size(bytes) {}
};

struct IPEndpointReceiveMsg : public IPEndpointBaseMsg {
  IPPacketType type;  // set by the network stack in its answer
  byte* buffer;       // must point into a shared buffer
  int size;           // in bytes

  IPEndpointReceiveMsg()
      : IPEndpointBaseMsg(IPEndpoint_Operation_Receive), type(IP_DATA), buffer(0), size(0) {}
  IPEndpointReceiveMsg(antModuleRef& module, byte* data, int bytes)
      : IPEndpointBaseMsg(module, IPEndpoint_Operation_Receive),
        type(IP_DATA),
        buffer(data),
        size(bytes) {}
};

struct IPEndpointCloseMsg : public IPEndpointBaseMsg {
  IPEndpointCloseMsg() : IPEndpointBaseMsg(IPEndpoint_Operation_Close) {}
  IPEndpointCloseMsg(antModuleRef& module)
      : IPEndpointBaseMsg(module, IPEndpoint_Operation_Close) {}
};

#endif  // OPENR_IPENDPOINTMSG_H_INCLUDED
