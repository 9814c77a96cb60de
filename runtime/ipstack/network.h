// The interface between the IPStack and the outside world.
//
// The stack gives commands, which return nothing and never wait.  All input from outside is
// returned by Poll(), which IpStack calls at one place only, at frame boundaries.  So a run can be
// replayed exactly: a recording contains all results of Poll() with their virtual time, and for a
// replay another Network ignores commands and returns the recorded results.
//
// Handles are small integers that the stack chooses, from 1 up.  Each handle is used only once, so
// handles are the same in every run.  Commands and events contain the robot's ports and addresses.
// A Network that uses other ports and addresses on the host translates them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace openr_host {

using NetHandle = uint32_t;

struct NetAddress {
  uint32_t ip = 0;  // in host byte order: 10.0.1.2 is 0x0a000102; 0 is any address
  uint16_t port = 0;
  bool operator==(const NetAddress&) const = default;
};

enum class NetProtocol : uint8_t { kTcp, kUdp };

enum class NetError : uint8_t {
  kNone,
  kFailed,  // any error that has no other value in this enum
  kClosed,  // a write failed because the peer had closed the connection
  kReset,
  kTimeout,
  kAddressInUse,
  kBadAddress,
  kRefused,  // nobody listens at the port
  kHostUnreachable,
  kNetworkUnreachable,
  kTooLong,
};

// A host that Resolve() or ResolveAddress() of a Network has found.
struct HostInfo {
  std::string name;  // the official name of the host
  std::vector<std::string> aliases;
  std::vector<uint32_t> addresses;
};

struct NetworkEvent {
  enum class Kind : uint8_t {
    kAccepted,   // an Accept() has a connection from `remote`
    kConnected,  // a Connect() has succeeded
    kSent,       // the network has accepted `count` more bytes of Send()
    kReceived,   // answer to Receive(): at least one byte, at most as many as requested
    kEnd,        // answer to Receive(): the peer has ended the stream
    kClosed,     // answer to Close(): both sides have ended the stream
    kDatagram,   // answer to ReceiveFrom(): `bytes` came from `remote`
    // The event that answers Resolve() or ResolveAddress().  If there is no such host, `host` has
    // no addresses.
    kResolved,
    kFailed,  // the socket failed and must be dropped; `error` tells why
    kNote,    // `bytes` is a text for the user
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
  virtual ~Network() = default;  // closes all sockets

  // Tells the network the robot's own address.  Called before all other functions, and again at
  // each later boot of the robot, when all sockets have been dropped.
  virtual void Attach(uint32_t ip) = 0;

  // Selects the address at which the next Listen() or Bind() of `handle` opens its port.  `ip` is
  // an address of the robot besides its own address (IpStackOptions::addresses).  Without this call
  // the port is opened at the robot's own address.
  virtual void SelectAddress(NetHandle handle, uint32_t ip) = 0;

  // ---- Commands for TCP sockets

  // Accepts connections to `port` from now on, as socket `listener`.  Holds a few connections until
  // Accept() takes them.
  virtual void Listen(NetHandle listener, uint16_t port) = 0;
  // Makes `handle` the socket of the next connection to `listener`.  If several calls of Accept()
  // wait for a connection, the first call gets the first connection.
  virtual void Accept(NetHandle listener, NetHandle handle) = 0;
  // Connects to `remote`.  Programs see `local_port` as the local port; on the host the connection
  // may have another local port.
  virtual void Connect(NetHandle handle, uint16_t local_port, NetAddress remote) = 0;
  // Copies the bytes at `data` and sends them as fast as the peer accepts them.
  virtual void Send(NetHandle handle, const void* data, size_t size) = 0;
  // Requests the bytes that have arrived or will arrive next, at most `size_max`.  One event,
  // kReceived or kEnd, answers the request.  A new request replaces a request that has no answer
  // yet.
  virtual void Receive(NetHandle handle, size_t size_max) = 0;
  // Ends the stream after the bytes that were given to Send().  Bytes that arrive from now on are
  // discarded.
  virtual void Close(NetHandle handle) = 0;

  // ---- Commands for UDP sockets

  // Binds the UDP socket `handle` to the robot's port `port`.  `any_port` is true if the network
  // stack has chosen the port.  Then no peer expects a certain number, so the host may use another
  // port.
  virtual void Bind(NetHandle handle, uint16_t port, bool any_port) = 0;
  // Copies the bytes at `data` and sends them as one datagram.  A datagram that cannot be sent is
  // lost, as in any UDP network; an event kNote may inform the user.
  virtual void SendTo(NetHandle handle, NetAddress remote, const void* data, size_t size) = 0;
  // Requests at most `count_max` datagrams.  The next Poll() that finds a datagram answers the
  // request with all datagrams that have arrived, but not more than `count_max`.  A new request
  // replaces a request that has no answer yet.
  virtual void ReceiveFrom(NetHandle handle, size_t count_max) = 0;

  // ---- Commands that look up names and addresses of hosts

  // Asks for the addresses of the host `name`, which is complete (with its domain) and has no final
  // dot.  Poll() returns the answer as an event kResolved.
  virtual void Resolve(NetHandle handle, const std::string& name) = 0;
  // Asks for the name of the host with the address `ip`.  Poll() returns the answer as an event
  // kResolved.
  virtual void ResolveAddress(NetHandle handle, uint32_t ip) = 0;

  // ---- Functions for sockets of every protocol

  // Returns a number for a new socket.  No number is returned twice, not even after a boot of the
  // robot.
  NetHandle NewHandle() { return ++last_handle_; }
  NetHandle last_handle() const { return last_handle_; }

  // Closes the socket `handle`, which gets no more events.  If `reset` is true, the peer sees a
  // broken connection instead of an end of the stream.  Unknown handles are ignored.
  virtual void Drop(NetHandle handle, bool reset) = 0;

  // Returns the events of all sockets and look-ups that have come since the last call of Poll(),
  // without waiting.
  virtual std::vector<NetworkEvent> Poll() = 0;

  // Closes this process's copies of all sockets and forgets all handles.  Peers notice nothing,
  // because the original process keeps its sockets open.  Called in a fork of the process, which
  // must not use the sockets of the original process.
  virtual void Forget() {}

  // Returns the host's port for the robot's `port`, or 0 if `port` has no port of the host.  The
  // port is for messages to the user; the run must not depend on it.
  virtual uint16_t HostPort(NetProtocol protocol, uint16_t port) const = 0;

 private:
  NetHandle last_handle_ = 0;
};

}  // namespace openr_host
