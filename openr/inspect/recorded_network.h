// Two implementations of Network: one records the events of the network during a run, the other
// gives the recorded events to a replay.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "openr/simulation/passing_network.h"
#include "runtime/ipstack/network.h"

namespace openr_host {

// Passes all calls to the network `inner`.  If Poll() has returned events, calls `heard` with these
// events, so that they can be recorded.
class RecordingNetwork : public PassingNetwork {
 public:
  using Heard = std::function<void(const std::vector<NetworkEvent>&)>;
  RecordingNetwork(std::unique_ptr<Network> inner, Heard heard)
      : PassingNetwork(std::move(inner)), heard_(std::move(heard)) {}

  std::vector<NetworkEvent> Poll() override {
    std::vector<NetworkEvent> events = PassingNetwork::Poll();
    if (!events.empty()) heard_(events);
    return events;
  }

 private:
  const Heard heard_;
};

// The network of a replay.  All commands are ignored, because a replay sends nothing.  Poll() calls
// the function `next_events`, which returns the next recorded events.
class ReplayedNetwork : public Network {
 public:
  using NextEvents = std::function<std::vector<NetworkEvent>()>;
  explicit ReplayedNetwork(NextEvents next_events) : next_events_(std::move(next_events)) {}

  void Attach(uint32_t) override {}
  void SelectAddress(NetHandle, uint32_t) override {}
  void Listen(NetHandle, uint16_t) override {}
  void Accept(NetHandle, NetHandle) override {}
  void Connect(NetHandle, uint16_t, NetAddress) override {}
  void Send(NetHandle, const void*, size_t) override {}
  void Receive(NetHandle, size_t) override {}
  void Close(NetHandle) override {}
  void Bind(NetHandle, uint16_t, bool) override {}
  void SendTo(NetHandle, NetAddress, const void*, size_t) override {}
  void ReceiveFrom(NetHandle, size_t) override {}
  void Resolve(NetHandle, const std::string&) override {}
  void ResolveAddress(NetHandle, uint32_t) override {}
  void Drop(NetHandle, bool) override {}
  std::vector<NetworkEvent> Poll() override { return next_events_(); }
  uint16_t HostPort(NetProtocol, uint16_t) const override { return 0; }

 private:
  const NextEvents next_events_;
};

}  // namespace openr_host
