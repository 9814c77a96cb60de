// Networks for recordings: one records what comes from outside, the other plays the recording
// again.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "openr/simulation/passing_network.h"
#include "runtime/ipstack/network.h"

namespace openr_host {

// Passes all calls to another network, and calls `heard` with what Poll() returned, if that was
// anything.
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

// A network that ignores all commands.  Poll() returns the events that `say` returns.
class ReplayedNetwork : public Network {
 public:
  using Say = std::function<std::vector<NetworkEvent>()>;
  explicit ReplayedNetwork(Say say) : say_(std::move(say)) {}

  void Attach(uint32_t) override {}
  void At(NetHandle, uint32_t) override {}
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
  std::vector<NetworkEvent> Poll() override { return say_(); }
  uint16_t HostPort(NetProtocol, uint16_t) const override { return 0; }

 private:
  const Say say_;
};

}  // namespace openr_host
