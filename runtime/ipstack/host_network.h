// HostNetwork: connects the robot's network to the world with sockets of the host.
//
// Server ports: a port of the robot is bound to HostNetworkOptions::bind_ip, by default 127.0.0.1.
// The port keeps its number if that number is free on the host (host_ports.h).
//
// Addresses in programs of the robot:
// - The robot's own address reaches only ports on which the robot listens.
// - 127.0.0.1 means the robot for ports on which the robot listens, and this computer for all other
//   ports.  If a program of this computer connects to the robot, objects see this program at
//   127.0.0.1.  So objects can also connect to the program there, as FTP does for its data.
// - Other addresses are translated in both directions by HostNetworkOptions::addresses.  A pair for
//   the robot's own address selects the address of the host at which server ports are bound.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "runtime/ipstack/address_map.h"
#include "runtime/ipstack/host_ports.h"
#include "runtime/ipstack/host_socket.h"
#include "runtime/ipstack/host_udp.h"
#include "runtime/ipstack/network.h"

namespace openr_host {

struct HostNetworkOptions {
  uint32_t bind_ip = 0x7f000001;  // the host's address for server ports; 0 for all interfaces
  // Ports of the robot for which the user wants a certain port of the host.  The key is the port of
  // the robot, the value is the port of the host (0: any free port).  A port without an entry keeps
  // its number if that number is free on the host.
  std::map<uint16_t, uint16_t> tcp_ports;
  std::map<uint16_t, uint16_t> udp_ports;
  // Pairs of addresses: an address that programs use, and the host's address that replaces it.  If
  // several pairs have the same address of the host, AddressMap::FromHost() chooses the address
  // that programs see.
  std::vector<AddressPair> addresses;
  // Shortest time, by the clock of the host, between two searches for new connections.  With 0,
  // every Poll() searches.  A run at full speed polls much more often than connections come, so
  // searching every time would waste time.
  int64_t accept_interval_ns = 0;
  // Hosts by name.  Resolve() and ResolveAddress() look into this table first.  They ask the host's
  // resolver only if the table does not have the host, because the resolver may be slow or may not
  // know the host.
  std::map<std::string, HostInfo> names;
};

class HostNetwork : public Network {
 public:
  static constexpr int kBacklog = 8;  // largest number of connections that wait to be accepted
  // Largest number of bytes read from one connection in one Poll(), so that a fast peer cannot hold
  // up the run.
  static constexpr size_t kReadBytesMax = 65536;

  explicit HostNetwork(HostNetworkOptions options = {});

  void Attach(uint32_t ip) override;
  void SelectAddress(NetHandle handle, uint32_t ip) override { selected_ips_[handle] = ip; }
  void Listen(NetHandle listener, uint16_t port) override;
  void Accept(NetHandle listener, NetHandle handle) override;
  void Connect(NetHandle handle, uint16_t local_port, NetAddress remote) override;
  void Send(NetHandle handle, const void* data, size_t size) override;
  void Receive(NetHandle handle, size_t size_max) override;
  void Close(NetHandle handle) override;
  void Bind(NetHandle handle, uint16_t port, bool any_port) override;
  void SendTo(NetHandle handle, NetAddress remote, const void* data, size_t size) override;
  void ReceiveFrom(NetHandle handle, size_t count_max) override;
  void Resolve(NetHandle handle, const std::string& name) override;
  void ResolveAddress(NetHandle handle, uint32_t ip) override;
  void Drop(NetHandle handle, bool reset) override;
  std::vector<NetworkEvent> Poll() override;
  void Forget() override;
  uint16_t HostPort(NetProtocol protocol, uint16_t port) const override;

 private:
  struct Listener {
    Fd fd;
    std::deque<NetHandle> accepts;
  };
  struct Connection {
    Fd fd;
    std::string out;  // bytes not yet accepted by the host; limited by the endpoint's pool
    uint64_t accepted_bytes = 0;  // number of bytes that the host has accepted since the last poll
    size_t want = 0;              // largest number of bytes that the pending Receive() takes
    bool connecting = false;
    bool closing = false;
    bool ended = false;   // whether this side has ended the stream
    bool failed = false;  // whether a failure of the connection was reported
  };

  // Translates the address `remote`, to which a program sends, to an address of the host.  `ports`
  // maps the robot's ports of the protocol (TCP or UDP) to ports of the host.  Returns port 0 if
  // the program may not reach this address.
  NetAddress ToHost(NetAddress remote, const HostPorts& ports);
  // Translates `remote`, an address that the host's network gives for the other end of a
  // connection, to the address under which the robot's programs know this other end.
  NetAddress FromHost(NetAddress remote, const HostPorts& ports) const;

  bool IsTimeToAccept();
  void AcceptAll(Listener* listener);
  void PollConnection(NetHandle handle, Connection* connection);
  void Push(NetHandle handle, Connection* connection);
  void Read(NetHandle handle, Connection* connection);
  void Discard(NetHandle handle, Connection* connection);
  void Fail(NetHandle handle, Connection* connection, int error);

  // Returns whether `ip` is an address of the robot: the robot's own address, loopback, or the
  // address of a bound socket.
  bool IsRobot(uint32_t ip) const;
  // Returns the address of the host at which the server socket `handle` must be bound.  This is
  // normally bind_ip_, the address for server ports.  But if SelectAddress() has selected an
  // address of the robot for this socket, returns the host's address that replaces it, and removes
  // the socket from selected_ips_, because SelectAddress() is for one Listen() or Bind() only.
  uint32_t BindIp(NetHandle handle);
  // Adds a note for the user if binding a socket to the address `ip` failed with `error` because
  // the host has no such address.
  void NoteBindError(uint32_t ip, int error);

  const HostNetworkOptions options_;
  AddressMap addresses_;
  uint32_t ip_ = 0;
  // The host's address for server sockets for which SelectAddress() was not called.
  uint32_t bind_ip_;
  // For each socket that is not bound yet, the address of the robot that SelectAddress() has
  // selected for this socket.
  std::map<NetHandle, uint32_t> selected_ips_;
  // The addresses of the robot, besides its own address, at which sockets are bound.  The value is
  // the address of the host that replaces the robot's address.
  std::map<uint32_t, uint32_t> bound_;
  HostPorts tcp_ports_;
  HostUdp udp_;
  std::map<NetHandle, Listener> listeners_;
  std::map<NetHandle, Connection> connections_;
  int64_t next_accept_ns_ = 0;        // time of the next search for new connections
  std::vector<NetworkEvent> events_;  // events that the next Poll() returns
};

NetworkEvent NoteEvent(std::string text);
NetworkEvent FailedEvent(NetHandle handle, NetError error);

}  // namespace openr_host
