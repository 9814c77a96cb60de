// The seam between the IPStack and the world outside of it.
//
// The stack gives commands.  They return nothing and never wait.  Everything the
// stack ever learns from outside comes out of Poll(), and IpStack calls Poll() at one
// place only, at frame boundaries: whoever records what Poll() returned together with
// the virtual time can replay a run exactly, with a Network that ignores commands and
// plays the record.
//
// Sockets are small integers that the stack chooses, from 1 up, never used twice, so
// they are the same in every run.  Ports and addresses are those of the robot; a
// Network that has others outside translates.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace openr_host {

using NetHandle = uint32_t;

struct NetAddress {
  uint32_t ip = 0;  // order of the host: 10.0.1.2 is 0x0a000102; 0 is any
  uint16_t port = 0;
  bool operator==(const NetAddress&) const = default;
};

enum class NetProtocol : uint8_t { kTcp, kUdp };

enum class NetError : uint8_t {
  kNone,
  kFailed,  // anything else
  kClosed,  // written to a connection that the peer has closed
  kReset,
  kTimeout,
  kAddressInUse,
  kBadAddress,
  kRefused,  // nobody listens there
  kHostUnreachable,
  kNetworkUnreachable,
  kTooLong,
};

// What a name or an address stands for.
struct HostInfo {
  std::string name;  // the official one
  std::vector<std::string> aliases;
  std::vector<uint32_t> addresses;
};

struct NetworkEvent {
  enum class Kind : uint8_t {
    kAccepted,   // an Accept() has its connection: remote
    kConnected,  // a Connect() has succeeded
    kSent,       // `count` more bytes of Send() have been taken
    kReceived,   // answers Receive(): bytes, at least one and at most what was asked
    kEnd,        // answers Receive(): the peer sends no more
    kClosed,     // answers Close(): both sides have ended
    kDatagram,   // answers ReceiveFrom(): bytes and remote
    kResolved,   // answers Resolve() and ResolveAddress(): host; no addresses: not found
    kFailed,     // error: the socket is of no use any more, except to be dropped
    kNote,       // bytes is a text for the user
  };
  Kind kind = Kind::kNote;
  NetHandle handle = 0;
  NetError error = NetError::kNone;
  NetAddress remote;
  uint64_t count = 0;
  std::string bytes;
  HostInfo host;
};

class Network {
 public:
  virtual ~Network() = default;  // lets go of every socket

  // Called once, before everything else, with the robot's own address.
  virtual void Attach(uint32_t ip) = 0;

  // Says that the next Listen() or Bind() of `handle` is at this address, which the robot has
  // besides its own (IpStackOptions::addresses).
  virtual void At(NetHandle handle, uint32_t ip) = 0;

  // ---- TCP

  // Takes connections to `port` from now on and holds a few until they are accepted.
  virtual void Listen(NetHandle listener, uint16_t port) = 0;
  // The next connection to `listener` becomes `handle`, in the order of the calls.
  virtual void Accept(NetHandle listener, NetHandle handle) = 0;
  // `local_port` is a wish.
  virtual void Connect(NetHandle handle, uint16_t local_port, NetAddress remote) = 0;
  // Copies the bytes; they are sent as fast as the peer takes them.
  virtual void Send(NetHandle handle, const void* data, size_t size) = 0;
  // Asks once for what there is, `size_max` bytes at most.  REQUIRES: the last one was
  // answered.
  virtual void Receive(NetHandle handle, size_t size_max) = 0;
  // Ends the stream after what was sent; what still comes in is thrown away.
  virtual void Close(NetHandle handle) = 0;

  // ---- UDP

  // `any_port`: the stack chose the port, so nobody outside waits for that one.
  virtual void Bind(NetHandle handle, uint16_t port, bool any_port) = 0;
  // Copies the bytes.  Datagrams that cannot be sent are lost; a kNote may say so.
  virtual void SendTo(NetHandle handle, NetAddress remote, const void* data, size_t size) = 0;
  // Asks once for what there is, `count_max` whole datagrams at most, all of one Poll().
  // REQUIRES: the last one was answered.
  virtual void ReceiveFrom(NetHandle handle, size_t count_max) = 0;

  // ---- names

  // A complete name, without a dot at its end.
  virtual void Resolve(NetHandle handle, const std::string& name) = 0;
  virtual void ResolveAddress(NetHandle handle, uint32_t ip) = 0;

  // ---- all sockets, listeners and questions

  // Forgets `handle`; nothing is heard of it any more.  `reset`: the peer of a
  // connection sees it broken instead of ended.  Unknown handles are ignored.
  virtual void Drop(NetHandle handle, bool reset) = 0;

  // What has happened since the last call, without waiting.
  virtual std::vector<NetworkEvent> Poll() = 0;

  // The port under which the outside finds the robot's `port`; 0 when it cannot.  For
  // people: nothing in the run may depend on it.
  virtual uint16_t HostPort(NetProtocol protocol, uint16_t port) const = 0;
};

}  // namespace openr_host
