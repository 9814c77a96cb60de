// BranchNetwork, the network of a robot whose run can be copied at an earlier moment.
//
// In the run it passes all calls on and logs what comes from outside.  In a copy it first says
// again what came in the run, and reaches nobody.  When the copy goes on as a new run, it opens the
// ports again at which the robot listens.  Connections do not go on: their peers talk to the first
// run, so the robot sees them broken.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "openr/rewind/input_log.h"
#include "openr/simulation/passing_network.h"

namespace openr_host {

class BranchNetwork : public PassingNetwork {
 public:
  // `log` gets what comes from outside to robot number `robot`, and must outlive the network.
  BranchNetwork(std::unique_ptr<Network> inner, int robot, InputLog* log)
      : PassingNetwork(std::move(inner)), robot_(robot), log_(*log) {}

  // Says `input`, of which all are for this robot, in the calls of Poll() of their numbers, and
  // reaches nobody from now on.  REQUIRES: Forget() was called.
  void Repeat(std::deque<LoggedInput> inputs);
  // Ends Repeat(), or Forget() if nothing was repeated: drops the inputs that Poll() has not
  // returned yet, opens the ports of the robot again, and uses the real network from now on.
  void GoOn();

  void At(NetHandle handle, uint32_t ip) override;
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

 private:
  // What the robot has opened, as far as it is needed to open it again.
  struct Socket {
    enum class Kind { kNew, kListener, kStream, kUdp, kName, kAddress };
    Kind kind = Kind::kNew;
    bool has_address = false;  // At() was called with `address`
    uint32_t address = 0;      // kAddress: the one whose name is asked for
    uint16_t port = 0;
    bool any_port = false;
    std::deque<NetHandle> accepts;  // kListener: calls of Accept() that wait
    size_t datagrams = 0;           // kUdp: of the ReceiveFrom() that waits; 0: none
    std::string name;               // kName: host name whose address the robot has asked for
  };

  void Follow(const NetworkEvent& event);
  void OpenAgain(NetHandle handle, const Socket& socket);

  const int robot_;
  InputLog& log_;
  uint64_t poll_ = 0;                 // number of calls of Poll()
  bool repeats_ = false;              // Poll() returns logged inputs, and nothing is sent
  std::deque<LoggedInput> inputs_;    // what Poll() still has to say, in order of its numbers
  std::vector<NetworkEvent> broken_;  // what the next Poll() says after the copy has gone on
  std::map<NetHandle, Socket> sockets_;
};

}  // namespace openr_host
