// Networks that write down what came from outside, and that say it again.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "runtime/ipstack/network.h"

namespace openr_host {

// Passes everything on to another network; `heard` gets what every Poll() returned, if it was
// anything.
class RecordingNetwork : public Network {
 public:
  using Heard = std::function<void(const std::vector<NetworkEvent>&)>;
  RecordingNetwork(std::unique_ptr<Network> inner, Heard heard)
      : inner_(std::move(inner)), heard_(std::move(heard)) {}

  void Attach(uint32_t ip) override { inner_->Attach(ip); }
  void Listen(NetHandle listener, uint16_t port) override { inner_->Listen(listener, port); }
  void Accept(NetHandle listener, NetHandle handle) override { inner_->Accept(listener, handle); }
  void Connect(NetHandle handle, uint16_t local_port, NetAddress remote) override {
    inner_->Connect(handle, local_port, remote);
  }
  void Send(NetHandle handle, const void* data, size_t size) override {
    inner_->Send(handle, data, size);
  }
  void Receive(NetHandle handle, size_t size_max) override { inner_->Receive(handle, size_max); }
  void Close(NetHandle handle) override { inner_->Close(handle); }
  void Bind(NetHandle handle, uint16_t port, bool any_port) override {
    inner_->Bind(handle, port, any_port);
  }
  void SendTo(NetHandle handle, NetAddress remote, const void* data, size_t size) override {
    inner_->SendTo(handle, remote, data, size);
  }
  void ReceiveFrom(NetHandle handle, size_t count_max) override {
    inner_->ReceiveFrom(handle, count_max);
  }
  void Resolve(NetHandle handle, const std::string& name) override {
    inner_->Resolve(handle, name);
  }
  void ResolveAddress(NetHandle handle, uint32_t ip) override {
    inner_->ResolveAddress(handle, ip);
  }
  void Drop(NetHandle handle, bool reset) override { inner_->Drop(handle, reset); }
  std::vector<NetworkEvent> Poll() override {
    std::vector<NetworkEvent> events = inner_->Poll();
    if (!events.empty()) heard_(events);
    return events;
  }
  uint16_t HostPort(NetProtocol protocol, uint16_t port) const override {
    return inner_->HostPort(protocol, port);
  }

 private:
  const std::unique_ptr<Network> inner_;
  const Heard heard_;
};

// Ignores every command; Poll() returns what `say` says.
class ReplayedNetwork : public Network {
 public:
  using Say = std::function<std::vector<NetworkEvent>()>;
  explicit ReplayedNetwork(Say say) : say_(std::move(say)) {}

  void Attach(uint32_t) override {}
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
