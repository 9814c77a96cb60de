// The ports on which TCP endpoints listen.
//
// Any number of endpoints may listen on one port; connections go to these endpoints in the order of
// their Listen messages.  The socket of a port stays open between two Listen messages.  So a client
// that connects in between is not refused, but waits until an endpoint listens again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <vector>

#include "runtime/ipstack/endpoint.h"

namespace openr_host {

class TcpPorts {
 public:
  explicit TcpPorts(IpStack* stack) : stack_(stack) {}

  // The largest number of ports that can be open at a time.  There is a limit because each open
  // port needs a socket of the host.
  static constexpr size_t kPortsMax = 64;

  // Lets `endpoint` wait for a connection to `port`.  If the port is not open yet, opens it at the
  // address `ip` (0 means the robot's own address).  `socket` becomes the handle of the connection.
  // Returns false if too many ports are open.
  bool Accept(uint16_t port, uint32_t ip, NetHandle socket, EventSink* endpoint);

  // Removes `endpoint` from the endpoints that wait for a connection to `port`, whether or not the
  // endpoint has got a connection.
  void Forget(uint16_t port, const EventSink* endpoint);

  bool IsOpen(uint16_t port) const { return ports_.contains(port); }

  // Closes the socket of `port`.  Called for a port that the network stack has chosen for one
  // endpoint, when the Listen of this endpoint ends.
  void Close(uint16_t port);
  void CloseAll();

 private:
  struct Port : EventSink {
    // Passes kFailed to all endpoints that wait for a connection.
    void StoreEvent(const NetworkEvent& event) override;

    NetHandle listener = 0;
    bool failed = false;
    std::vector<EventSink*> waiting;
  };

  IpStack* const stack_;
  std::map<uint16_t, std::unique_ptr<Port>> ports_;
};

}  // namespace openr_host
