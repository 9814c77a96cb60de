// Networks inside the process: no host socket, every run the same.
//
//   auto hub = std::make_shared<LoopbackHub>();
//   AddIpStack(&system, 0, std::make_unique<LoopbackNetwork>(hub));
//   LoopbackNetwork client(hub);       // a test as the robot's peer
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

// The wire between LoopbackNetworks, and its directory of names.
class LoopbackHub {
 public:
  // Name, without a final dot, to what a question for it answers.
  std::map<std::string, HostInfo> names;

 private:
  friend class LoopbackNetwork;
  std::map<uint32_t, LoopbackNetwork*> hosts_;  // by address
};

// One host on the wire.  What is sent arrives at once and is seen at the receiver's next
// Poll().  A peer that does not read stops its sender after kWindowBytes.
class LoopbackNetwork : public Network {
 public:
  static constexpr size_t kWindowBytes = 65536;
  static constexpr size_t kBacklog = 8;     // connections held until accepted
  static constexpr size_t kDatagrams = 32;  // held until received, then lost

  // Alone on a wire of its own when no hub is given.
  explicit LoopbackNetwork(std::shared_ptr<LoopbackHub> hub = std::make_shared<LoopbackHub>());
  ~LoopbackNetwork() override;

  // The last of two with the same address is the one that others reach.
  void Attach(uint32_t ip) override;
  void At(NetHandle, uint32_t) override {}  // the wire knows one address of a robot
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

  // The port itself: nothing is translated.
  uint16_t HostPort(NetProtocol, uint16_t port) const override { return port; }

 private:
  // A connection: a pipe to each of its two sides.
  struct Pipe {
    std::string bytes;
    bool ended = false;  // nothing more will come
    bool gone = false;   // its reader has gone
  };
  struct Link {
    Pipe to[2];
    bool reset = false;
  };
  struct Connection {
    std::shared_ptr<Link> link;
    int side = 0;     // reads link->to[side]
    std::string out;  // not yet in the pipe
    size_t want = 0;  // of a Receive()
    bool closing = false;
    Pipe& in() const { return link->to[side]; }
    Pipe& peer() const { return link->to[1 - side]; }
  };
  struct Pending {  // connected, not accepted
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
    size_t want = 0;  // datagrams
    std::deque<Datagram> waiting;
  };

  LoopbackNetwork* HostAt(uint32_t ip);
  Listener* ListenerOn(uint16_t port);
  void Add(NetworkEvent::Kind kind, NetHandle handle, NetError error = NetError::kNone);
  void MatchAccepts(Listener* listener);
  void Push(NetHandle handle, Connection* connection);
  // Appends what happened to the connection; false when it is of no use any more.
  bool PollConnection(NetHandle handle, Connection* connection);

  const std::shared_ptr<LoopbackHub> hub_;
  uint32_t ip_ = 0;
  std::map<NetHandle, Listener> listeners_;
  std::map<NetHandle, Connection> connections_;
  std::map<NetHandle, Udp> udps_;
  std::vector<NetworkEvent> events_;  // for the next Poll()
};

}  // namespace openr_host
