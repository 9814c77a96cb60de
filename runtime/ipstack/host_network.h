// The robot's network over sockets of the host.
//
// A server port of the robot is bound to 127.0.0.1 unless the options say otherwise, under
// its own number if that is free (host_ports.h).  The robot's own address means the robot
// and reaches only ports that it listens on.  127.0.0.1 means the robot where it listens,
// else this computer: its programs appear to objects under that address, and answers and
// the data connections of FTP go back there.  Other addresses that programs have compiled in
// are translated both ways, as the options say; an address of the robot among them says where
// its server ports are bound.
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
  uint32_t bind_ip = 0x7f000001;  // of the host, for server ports; 0: every interface
  // Robot's port to host's port, which it gets or none; 0: any free one.  Others keep their number
  // if it is free.
  std::map<uint16_t, uint16_t> tcp_ports;
  std::map<uint16_t, uint16_t> udp_ports;
  // Addresses as programs know them, and where they are; the first one of a host's address is how
  // its programs appear (address_map.h).
  std::vector<AddressPair> addresses;
  // Answered before the host's resolver is asked, which may take its time.
  std::map<std::string, HostInfo> names;
};

class HostNetwork : public Network {
 public:
  static constexpr int kBacklog = 8;              // connections held until accepted
  static constexpr size_t kReadBytesMax = 65536;  // of one connection at one poll

  explicit HostNetwork(HostNetworkOptions options = {});

  void Attach(uint32_t ip) override;
  void At(NetHandle handle, uint32_t ip) override { at_[handle] = ip; }
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
  uint16_t HostPort(NetProtocol protocol, uint16_t port) const override;

 private:
  struct Listener {
    Fd fd;
    std::deque<NetHandle> accepts;
  };
  struct Connection {
    Fd fd;
    std::string out;     // not yet taken by the host; bounded by the endpoint's pool
    uint64_t taken = 0;  // bytes since the last poll
    size_t want = 0;     // of a Receive()
    bool connecting = false;
    bool closing = false;
    bool ended = false;   // our side has been ended
    bool failed = false;  // reported
  };

  // Where a program's `remote` is on the host; port 0: nowhere.
  NetAddress ToHost(NetAddress remote, const HostPorts& ports);
  // How a program knows the host's `remote`.
  NetAddress FromHost(NetAddress remote, const HostPorts& ports) const;

  void AcceptAll(Listener* listener);
  void PollConnection(NetHandle handle, Connection* connection);
  void Push(NetHandle handle, Connection* connection);
  void Read(NetHandle handle, Connection* connection);
  void Discard(NetHandle handle, Connection* connection);
  void Fail(NetHandle handle, Connection* connection, int error);

  // Whether the robot has this address: its own one, loopback, or one that it bound to.
  bool IsRobot(uint32_t ip) const;
  // The address of the host for a server socket; takes what At() said.
  uint32_t BindIp(NetHandle handle);
  // Says that the host has no such address.
  void NoteBindError(uint32_t ip, int error);

  const HostNetworkOptions options_;
  AddressMap addresses_;
  uint32_t ip_ = 0;
  uint32_t bind_ip_;                    // of the host, for server ports at the robot's own address
  std::map<NetHandle, uint32_t> at_;    // of At(), until the socket is bound
  std::map<uint32_t, uint32_t> bound_;  // of At(), bound: the robot's address to the host's
  HostPorts tcp_ports_;
  HostUdp udp_;
  std::map<NetHandle, Listener> listeners_;
  std::map<NetHandle, Connection> connections_;
  std::vector<NetworkEvent> events_;  // for the next Poll()
};

NetworkEvent NoteEvent(std::string text);
NetworkEvent FailedEvent(NetHandle handle, NetError error);

}  // namespace openr_host
