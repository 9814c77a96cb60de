// BranchNetwork, the network of a robot in a run that can go back to an earlier moment.
//
// In the run itself, BranchNetwork passes all calls on to the real network and logs the events that
// come from outside.  In a copy of the run, BranchNetwork first returns the logged events again and
// sends nothing.  When the copy goes on as a new run, the network opens the ports again at which
// the robot listens.  The robot sees its TCP connections as broken, because their other ends are
// still connected to the first run.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "openr/rewind/input_log.h"
#include "openr/simulation/passing_network.h"

namespace openr_host {

class BranchNetwork : public PassingNetwork {
 public:
  // Logs the events that come from outside to robot number `robot` in `log`, which must outlive the
  // network.
  BranchNetwork(std::unique_ptr<Network> inner, int robot, InputLog* log)
      : PassingNetwork(std::move(inner)), robot_(robot), log_(*log) {}

  // Repeats `inputs`, which are all for this robot: each call of Poll() returns the events that the
  // call with the same number returned in the original run.  From now on nothing is sent.
  // REQUIRES: Forget() was called.
  void Repeat(std::deque<LoggedInput> inputs);
  // Repeats events: each call of Poll() calls `next_events` and returns the events that
  // `next_events` returns, such as the events of a recording.
  void RepeatFrom(std::function<std::vector<NetworkEvent>()> next_events);
  // Goes on with the real network after Repeat() or RepeatFrom(), or after Forget() if nothing was
  // repeated.  Drops the inputs that Poll() has not returned yet, and opens the ports of the robot
  // again.
  void GoOn();

  void SelectAddress(NetHandle handle, uint32_t ip) override;
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
  // A socket of the robot, with the data that are needed to open it again.
  struct Socket {
    enum class Kind { kNew, kListener, kStream, kUdp, kName, kAddress };
    Kind kind = Kind::kNew;
    bool has_address = false;  // true: the robot has called SelectAddress() with `address`
    uint32_t address = 0;      // for a kAddress: the address whose name the robot has asked for
    uint16_t port = 0;
    bool any_port = false;
    std::deque<NetHandle> accepts;  // for a kListener: sockets with a waiting call of Accept()
    // For kUdp: the number of datagrams for which ReceiveFrom() waits; 0: it does not wait.
    size_t datagrams = 0;
    std::string name;  // for a kName: the host name whose address the robot has asked for
  };

  void Follow(const NetworkEvent& event);
  void OpenAgain(NetHandle handle, const Socket& socket);

  const int robot_;
  InputLog& log_;
  uint64_t poll_ = 0;  // number of calls of Poll()
  // The function from which Poll() takes its events, set by RepeatFrom(); null: Poll() does not
  // call a function for its events.
  std::function<std::vector<NetworkEvent>()> next_events_;
  bool repeats_ = false;  // true: Poll() returns logged inputs, and nothing is sent
  // Inputs that Poll() has still to return, in the order of the calls of Poll() that returned them
  // in the original run.
  std::deque<LoggedInput> inputs_;
  // Events that tell the robot that its connections are broken; the next Poll() returns them.
  std::vector<NetworkEvent> broken_;
  std::map<NetHandle, Socket> sockets_;
};

}  // namespace openr_host
