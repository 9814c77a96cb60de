// Messages to a TCP endpoint.
//
// An endpoint serves one connection: listen or connect, send and receive, close.  After that the
// endpoint cannot be used again.  One send and one receive may wait for their answers at a time.
// Where pointers have 32 bits, sizes and offsets are those of the robot.
#ifndef OPENR_TCPENDPOINTMSG_H_INCLUDED
#define OPENR_TCPENDPOINTMSG_H_INCLUDED

#include <IPv4Types.h>
#include <antEnvMsg.h>

enum TCPEndpointError {
  TCP_SUCCESS = 0,
  TCP_FAIL = 1,
  TCP_CONNECTION_CLOSED = 2,
  TCP_CONNECTION_RESET = 3,
  TCP_CONNECTION_TIMEOUT = 4,
  TCP_CONNECTION_BUSY = 5,
  TCP_ADDRESSINUSE = 6,
  TCP_ADDRESSERROR = 7,
  TCP_PORT_UNREACHABLE = 8,
  TCP_PROTOCOL_UNREACHABLE = 9,
  TCP_HOST_UNREACHABLE = 10,
  TCP_NETWORK_UNREACHABLE = 11,
  TCP_MESSAGE_TOO_LONG = 12,
  TCP_TTL_EXCEEDED = 13,
  TCP_TIME_EXCEEDED = 14,
  TCP_WOULDBLOCK = 15,
  TCP_BUFFER_INVALID = 16,
  TCP_OPERATION_INVALID = 17,
  TCP_OPERATION_UNKNOWN = 18
};

// Writes the name of the error's constant, such as "TCP_FAIL".  Writes "unknown TCPEndpointError"
// for a number that belongs to no constant.
std::ostream& operator<<(std::ostream& out, TCPEndpointError error);

// The base class of all messages to a TCP endpoint.
struct TCPEndpointBaseMsg : public antOperationMsg<TCPEndpointError> {
  TCPEndpointBaseMsg(int32 operation = 0) : antOperationMsg<TCPEndpointError>(operation) {}
  TCPEndpointBaseMsg(antModuleRef& module, int32 operation)
      : antOperationMsg<TCPEndpointError>(module, operation) {}
};

// The operations that a message to a TCP endpoint can request (field dstOperation).  The numbers
// are those of the robot, the names are our choice.
const int32 TCPEndpoint_Operation_Bind = 1;
const int32 TCPEndpoint_Operation_Listen = 2;
const int32 TCPEndpoint_Operation_Connect = 3;
const int32 TCPEndpoint_Operation_Send = 4;
const int32 TCPEndpoint_Operation_Receive = 5;
const int32 TCPEndpoint_Operation_Close = 6;
const int32 TCPEndpoint_Operation_SetBlockingMode = 7;
const int32 TCPEndpoint_Operation_ReadyForRead = 8;
const int32 TCPEndpoint_Operation_ReadyForWrite = 9;
const int32 TCPEndpoint_Operation_BacklogListen = 10;
const int32 TCPEndpoint_Operation_Accept = 11;
const int32 TCPEndpoint_Operation_BacklogQueues = 12;
const int32 TCPEndpoint_Operation_Address = 13;

// ---- messages to a TCP endpoint that Sony documents

// Waits for one connection.  The answer comes when a client has connected.  In the answer all four
// fields, the addresses and ports of both sides, are filled in.
struct TCPEndpointListenMsg : public TCPEndpointBaseMsg {
  IPAddress lAddress;  // own address
  Port lPort;
  IPAddress fAddress;  // address of the peer
  Port fPort;

  TCPEndpointListenMsg()
      : TCPEndpointBaseMsg(TCPEndpoint_Operation_Listen),
        lAddress(0),
        lPort(0),
        fAddress(0),
        fPort(0) {}
  TCPEndpointListenMsg(antModuleRef& module, IPAddress localAddress = 0, Port localPort = 0,
                       IPAddress foreignAddress = 0, Port foreignPort = 0)
      : TCPEndpointBaseMsg(module, TCPEndpoint_Operation_Listen),
        lAddress(localAddress),
        lPort(localPort),
        fAddress(foreignAddress),
        fPort(foreignPort) {}
};

// Connects to a peer.  The answer comes when the connection is made.  The answer has the local
// address and port filled in.
struct TCPEndpointConnectMsg : public TCPEndpointBaseMsg {
  IPAddress lAddress;  // own address
  Port lPort;
  IPAddress fAddress;  // address of the peer
  Port fPort;

  TCPEndpointConnectMsg()
      : TCPEndpointBaseMsg(TCPEndpoint_Operation_Connect),
        lAddress(0),
        lPort(0),
        fAddress(0),
        fPort(0) {}
  TCPEndpointConnectMsg(antModuleRef& module, IPAddress localAddress, Port localPort,
                        IPAddress foreignAddress, Port foreignPort)
      : TCPEndpointBaseMsg(module, TCPEndpoint_Operation_Connect),
        lAddress(localAddress),
        lPort(localPort),
        fAddress(foreignAddress),
        fPort(foreignPort) {}
};

// Sends data.  The answer comes when the network stack has accepted all data, which may be before
// the peer has received them.
struct TCPEndpointSendMsg : public TCPEndpointBaseMsg {
  byte* buffer;  // data in a shared buffer; must not be changed before the answer
  int size;      // in bytes
  int16 queueNr;

  TCPEndpointSendMsg()
      : TCPEndpointBaseMsg(TCPEndpoint_Operation_Send), buffer(0), size(0), queueNr(0) {}
  TCPEndpointSendMsg(antModuleRef& module, byte* data, int bytes, int16 queue = 0)
      : TCPEndpointBaseMsg(module, TCPEndpoint_Operation_Send),
        buffer(data),
        size(bytes),
        queueNr(queue) {}
};

// Receives at least sizeMin and at most sizeMax bytes.  In the answer sizeMin and sizeMax are both
// the number of bytes received.  At the end of the stream the error is TCP_CONNECTION_CLOSED.
struct TCPEndpointReceiveMsg : public TCPEndpointBaseMsg {
  byte* buffer;  // must point into a shared buffer
  int sizeMin;
  int sizeMax;
  int16 queueNr;

  TCPEndpointReceiveMsg()
      : TCPEndpointBaseMsg(TCPEndpoint_Operation_Receive),
        buffer(0),
        sizeMin(0),
        sizeMax(0),
        queueNr(0) {}
  TCPEndpointReceiveMsg(antModuleRef& module, byte* data, int least, int most, int16 queue = 0)
      : TCPEndpointBaseMsg(module, TCPEndpoint_Operation_Receive),
        buffer(data),
        sizeMin(least),
        sizeMax(most),
        queueNr(queue) {}
};

// Closes the connection; the answer comes when it is closed.  Sony's network guide shows a
// constructor with the arguments (module, abort).  This constructor follows the SDK's header
// instead, where the argument after the module is `linger` (network.md, 4.1).
struct TCPEndpointCloseMsg : public TCPEndpointBaseMsg {
  bool abort;  // true: drops the connection and all data at once
  bool linger;
  int lingerTime;
  int16 queueNr;  // -100 probably means all queues

  TCPEndpointCloseMsg()
      : TCPEndpointBaseMsg(TCPEndpoint_Operation_Close),
        abort(false),
        linger(false),
        lingerTime(0),
        queueNr(-100) {}
  TCPEndpointCloseMsg(antModuleRef& module, bool lingering = false, int time = 0,
                      bool aborting = false, int16 queue = -100)
      : TCPEndpointBaseMsg(module, TCPEndpoint_Operation_Close),
        abort(aborting),
        linger(lingering),
        lingerTime(time),
        queueNr(queue) {}
};

// ---- messages to a TCP endpoint that Sony does not document

struct TCPEndpointBindMsg : public TCPEndpointBaseMsg {
  IPAddress lAddress;  // own address
  Port lPort;

  TCPEndpointBindMsg() : TCPEndpointBaseMsg(TCPEndpoint_Operation_Bind), lAddress(0), lPort(0) {}
  TCPEndpointBindMsg(antModuleRef& module, IPAddress localAddress, Port localPort)
      : TCPEndpointBaseMsg(module, TCPEndpoint_Operation_Bind),
        lAddress(localAddress),
        lPort(localPort) {}
};

struct TCPEndpointSetBlockingModeMsg : public TCPEndpointBaseMsg {
  bool blocking;
  int16 queueNr;

  TCPEndpointSetBlockingModeMsg()
      : TCPEndpointBaseMsg(TCPEndpoint_Operation_SetBlockingMode), blocking(true), queueNr(0) {}
  TCPEndpointSetBlockingModeMsg(antModuleRef& module, bool block, int16 queue = 0)
      : TCPEndpointBaseMsg(module, TCPEndpoint_Operation_SetBlockingMode),
        blocking(block),
        queueNr(queue) {}
};

struct TCPEndpointReadyForReadMsg : public TCPEndpointBaseMsg {
  boolean ready;  // set by the network stack in its answer
  int16 queueNr;

  TCPEndpointReadyForReadMsg()
      : TCPEndpointBaseMsg(TCPEndpoint_Operation_ReadyForRead), ready(FALSE), queueNr(0) {}
  TCPEndpointReadyForReadMsg(antModuleRef& module, int16 queue = 0)
      : TCPEndpointBaseMsg(module, TCPEndpoint_Operation_ReadyForRead),
        ready(FALSE),
        queueNr(queue) {}
};

struct TCPEndpointReadyForWriteMsg : public TCPEndpointBaseMsg {
  boolean ready;  // set by the network stack in its answer
  int16 queueNr;

  TCPEndpointReadyForWriteMsg()
      : TCPEndpointBaseMsg(TCPEndpoint_Operation_ReadyForWrite), ready(FALSE), queueNr(0) {}
  TCPEndpointReadyForWriteMsg(antModuleRef& module, int16 queue = 0)
      : TCPEndpointBaseMsg(module, TCPEndpoint_Operation_ReadyForWrite),
        ready(FALSE),
        queueNr(queue) {}
};

struct TCPEndpointBacklogListenMsg : public TCPEndpointBaseMsg {
  IPAddress lAddress;  // own address
  Port lPort;
  IPAddress fAddress;  // address of the peer
  Port fPort;

  TCPEndpointBacklogListenMsg()
      : TCPEndpointBaseMsg(TCPEndpoint_Operation_BacklogListen),
        lAddress(0),
        lPort(0),
        fAddress(0),
        fPort(0) {}
  TCPEndpointBacklogListenMsg(antModuleRef& module, IPAddress localAddress = 0, Port localPort = 0,
                              IPAddress foreignAddress = 0, Port foreignPort = 0)
      : TCPEndpointBaseMsg(module, TCPEndpoint_Operation_BacklogListen),
        lAddress(localAddress),
        lPort(localPort),
        fAddress(foreignAddress),
        fPort(foreignPort) {}
};

struct TCPEndpointAcceptMsg : public TCPEndpointBaseMsg {
  IPAddress lAddress;  // own address
  Port lPort;
  IPAddress fAddress;  // address of the peer
  Port fPort;
  int16 queueNr;

  TCPEndpointAcceptMsg()
      : TCPEndpointBaseMsg(TCPEndpoint_Operation_Accept),
        lAddress(0),
        lPort(0),
        fAddress(0),
        fPort(0),
        queueNr(0) {}
  TCPEndpointAcceptMsg(antModuleRef& module)
      : TCPEndpointBaseMsg(module, TCPEndpoint_Operation_Accept),
        lAddress(0),
        lPort(0),
        fAddress(0),
        fPort(0),
        queueNr(0) {}
};

struct TCPEndpointBacklogQueueMsg : public TCPEndpointBaseMsg {
  int16 backlog;

  TCPEndpointBacklogQueueMsg()
      : TCPEndpointBaseMsg(TCPEndpoint_Operation_BacklogQueues), backlog(0) {}
  TCPEndpointBacklogQueueMsg(antModuleRef& module, int16 connections)
      : TCPEndpointBaseMsg(module, TCPEndpoint_Operation_BacklogQueues), backlog(connections) {}
};

struct TCPEndpointAddressMsg : public TCPEndpointBaseMsg {
  int16 queueNr;
  IPAddress lAddress;  // own address
  Port lPort;
  IPAddress fAddress;  // address of the peer
  Port fPort;

  TCPEndpointAddressMsg()
      : TCPEndpointBaseMsg(TCPEndpoint_Operation_Address),
        queueNr(0),
        lAddress(0),
        lPort(0),
        fAddress(0),
        fPort(0) {}
  TCPEndpointAddressMsg(antModuleRef& module, int16 queue = 0)
      : TCPEndpointBaseMsg(module, TCPEndpoint_Operation_Address),
        queueNr(queue),
        lAddress(0),
        lPort(0),
        fAddress(0),
        fPort(0) {}
};

#endif  // OPENR_TCPENDPOINTMSG_H_INCLUDED
