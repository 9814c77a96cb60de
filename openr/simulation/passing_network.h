// PassingNetwork, a network that passes all calls to another network.  Classes that stand between a
// robot and its network are derived from it.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "runtime/ipstack/network.h"

namespace openr_host {

class PassingNetwork : public Network {
 public:
  explicit PassingNetwork(std::unique_ptr<Network> inner) : inner_(std::move(inner)) {}

  void Attach(uint32_t ip) override { inner_->Attach(ip); }
  void SelectAddress(NetHandle handle, uint32_t ip) override { inner_->SelectAddress(handle, ip); }
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
  std::vector<NetworkEvent> Poll() override { return inner_->Poll(); }
  void Forget() override { inner_->Forget(); }
  uint16_t HostPort(NetProtocol protocol, uint16_t port) const override {
    return inner_->HostPort(protocol, port);
  }

 private:
  const std::unique_ptr<Network> inner_;
};

}  // namespace openr_host
