// Networks inside the process, for tests and for runs without the host's network.  They use no
// sockets of the host, so every run is the same.
//
//   auto hub = std::make_shared<LoopbackHub>();
//   AddIpStack(&system, 0, std::make_unique<LoopbackNetwork>(hub));
//   LoopbackNetwork client(hub);       // the test is a peer of the robot
//   client.Attach(0x0a000102);
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "runtime/ipstack/network.h"

namespace openr_host {

class LoopbackNetwork;

// The hub that connects all LoopbackNetworks of a test.  The hub also has the table in which the
// LoopbackNetworks look up the names of hosts.
class LoopbackHub {
 public:
  // The hosts that LoopbackNetwork::Resolve() finds.  The key is the name of the host without a
  // final dot.
  std::map<std::string, HostInfo> names;

 private:
  friend class LoopbackNetwork;
  std::map<uint32_t, LoopbackNetwork*> hosts_;  // connected hosts by IP address
};

// A host, such as a robot, that is connected to a hub.  Data that a host sends arrive at once; the
// receiver gets the data from its next Poll().  If a host does not read, its peer can send only
// kWindowBytes.
class LoopbackNetwork : public Network {
 public:
  static constexpr size_t kWindowBytes = 65536;
  static constexpr size_t kBacklog = 8;  // largest number of connections that wait to be accepted
  // The number of datagrams that a UDP socket holds until they are received; our choice.  Further
  // datagrams are lost, as on a real network.
  static constexpr size_t kDatagrams = 32;

  // Makes a host at `hub`.  Without the argument, the host gets a new hub, where it has no peers.
  explicit LoopbackNetwork(std::shared_ptr<LoopbackHub> hub = std::make_shared<LoopbackHub>());
  ~LoopbackNetwork() override;

  // Gives this host of the hub the address `ip`.  If several hosts have the same address, peers
  // reach the host that was attached last.
  void Attach(uint32_t ip) override;
  void SelectAddress(NetHandle, uint32_t) override {}  // a host at a hub has one address only
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

  // Returns `port`, because this network does not translate ports.
  uint16_t HostPort(NetProtocol, uint16_t port) const override { return port; }

 private:
  // Direction of a connection between two LoopbackNetworks, with the bytes that were sent in this
  // direction and not read yet.
  struct Pipe {
    std::string bytes;
    bool ended = false;  // whether the writer has ended the stream
    bool gone = false;   // whether the reader has dropped the connection
    // Whether the reader has closed its side, so that bytes that still come are dropped.
    bool discards = false;
  };
  struct Link {
    Pipe to[2];
    bool reset = false;
  };
  struct Connection {
    std::shared_ptr<Link> link;
    int side = 0;     // this side of the connection reads the pipe link->to[side]
    std::string out;  // bytes to send that are not in the pipe yet
    size_t want = 0;  // largest number of bytes that the pending Receive() takes
    bool closing = false;
    Pipe& in() const { return link->to[side]; }
    Pipe& peer() const { return link->to[1 - side]; }
  };
  struct Pending {  // a connection that is not yet accepted
    std::shared_ptr<Link> link;
    NetAddress remote;
  };
  struct Listener {
    uint16_t port = 0;
    std::deque<NetHandle> accepts;
    std::deque<Pending> backlog;
  };
  struct Datagram {
    NetAddress remote;
    std::string bytes;
  };
  struct Udp {
    uint16_t port = 0;
    size_t want = 0;  // largest number of datagrams for the pending ReceiveFrom(); 0: none pending
    std::deque<Datagram> waiting;
  };

  void LeaveHub();
  LoopbackNetwork* HostAt(uint32_t ip);
  Listener* ListenerOn(uint16_t port);
  void Add(NetworkEvent::Kind kind, NetHandle handle, NetError error = NetError::kNone);
  void MatchAccepts(Listener* listener);
  void Push(NetHandle handle, Connection* connection);
  // Adds the new events of `connection` to the events that Poll() will return.  Returns false if
  // both sides have ended `connection` or one side has reset it; the caller then deletes the
  // connection.
  bool PollConnection(NetHandle handle, Connection* connection);

  const std::shared_ptr<LoopbackHub> hub_;
  uint32_t ip_ = 0;
  std::map<NetHandle, Listener> listeners_;
  std::map<NetHandle, Connection> connections_;
  std::map<NetHandle, Udp> udps_;
  std::vector<NetworkEvent> events_;  // events that the next Poll() returns
};

}  // namespace openr_host
