#include "runtime/ipstack/failing_network.h"

namespace openr_host {

bool FailingNetwork::Fails(NetHandle handle) {
  if (--left_ != 0) return false;
  failed_ = handle;
  return true;
}

void FailingNetwork::Listen(NetHandle listener, uint16_t port) {
  if (!Fails(listener)) inner_->Listen(listener, port);
}
void FailingNetwork::Accept(NetHandle listener, NetHandle handle) {
  if (!Fails(handle)) inner_->Accept(listener, handle);
}
void FailingNetwork::Connect(NetHandle handle, uint16_t local_port, NetAddress remote) {
  if (!Fails(handle)) inner_->Connect(handle, local_port, remote);
}
void FailingNetwork::Send(NetHandle handle, const void* data, size_t size) {
  if (!Fails(handle)) inner_->Send(handle, data, size);
}
void FailingNetwork::Receive(NetHandle handle, size_t size_max) {
  if (!Fails(handle)) inner_->Receive(handle, size_max);
}
void FailingNetwork::Bind(NetHandle handle, uint16_t port, bool any_port) {
  if (!Fails(handle)) inner_->Bind(handle, port, any_port);
}
void FailingNetwork::SendTo(NetHandle handle, NetAddress remote, const void* data, size_t size) {
  if (!Fails(handle)) inner_->SendTo(handle, remote, data, size);
}
void FailingNetwork::ReceiveFrom(NetHandle handle, size_t count_max) {
  if (!Fails(handle)) inner_->ReceiveFrom(handle, count_max);
}
void FailingNetwork::Resolve(NetHandle handle, const std::string& name) {
  if (!Fails(handle)) inner_->Resolve(handle, name);
}
void FailingNetwork::ResolveAddress(NetHandle handle, uint32_t ip) {
  if (!Fails(handle)) inner_->ResolveAddress(handle, ip);
}

std::vector<NetworkEvent> FailingNetwork::Poll() {
  std::vector<NetworkEvent> events = inner_->Poll();
  if (failed_ != 0) {
    NetworkEvent event;
    event.kind = NetworkEvent::Kind::kFailed;
    event.handle = failed_;
    event.error = error_;
    events.push_back(event);
    failed_ = 0;
  }
  return events;
}

}  // namespace openr_host
