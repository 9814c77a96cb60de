// A Network for tests, which passes commands to another Network and makes one command fail.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "runtime/ipstack/network.h"

namespace openr_host {

// Passes all commands to `inner`, but makes command number `nth` fail, counted from 1.  Only the
// commands Listen, Accept, Connect, Send, Receive, Bind, SendTo, ReceiveFrom, Resolve and
// ResolveAddress are counted.  The failing command is not passed to `inner`; the next Poll()
// reports the failure with `error`.
class FailingNetwork : public Network {
 public:
  FailingNetwork(std::unique_ptr<Network> inner, int nth, NetError error)
      : inner_(std::move(inner)), left_(nth), error_(error) {}

  void Attach(uint32_t ip) override { inner_->Attach(ip); }
  void SelectAddress(NetHandle handle, uint32_t ip) override { inner_->SelectAddress(handle, ip); }
  void Listen(NetHandle listener, uint16_t port) override;
  void Accept(NetHandle listener, NetHandle handle) override;
  void Connect(NetHandle handle, uint16_t local_port, NetAddress remote) override;
  void Send(NetHandle handle, const void* data, size_t size) override;
  void Receive(NetHandle handle, size_t size_max) override;
  void Close(NetHandle handle) override { inner_->Close(handle); }
  void Bind(NetHandle handle, uint16_t port, bool any_port) override;
  void SendTo(NetHandle handle, NetAddress remote, const void* data, size_t size) override;
  void ReceiveFrom(NetHandle handle, size_t count_max) override;
  void Resolve(NetHandle handle, const std::string& name) override;
  void ResolveAddress(NetHandle handle, uint32_t ip) override;
  void Drop(NetHandle handle, bool reset) override { inner_->Drop(handle, reset); }
  std::vector<NetworkEvent> Poll() override;
  uint16_t HostPort(NetProtocol protocol, uint16_t port) const override {
    return inner_->HostPort(protocol, port);
  }

 private:
  // Counts a command for the socket `handle`.  Returns true if this is command number `nth`, which
  // must fail; the caller then does not pass this command to the other Network.
  bool Fails(NetHandle handle);

  const std::unique_ptr<Network> inner_;
  int left_;
  const NetError error_;
  // The socket whose command has failed, until Poll() reports the failure; 0 if there is no failure
  // to report.
  NetHandle failed_ = 0;
};

}  // namespace openr_host
