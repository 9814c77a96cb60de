#include "runtime/ipstack/tcp_ports.h"

#include <algorithm>

#include "runtime/ipstack/ip_stack.h"

namespace openr_host {

void TcpPorts::Port::StoreEvent(const NetworkEvent& event) {
  if (event.kind != NetworkEvent::Kind::kFailed) return;
  failed = true;
  for (EventSink* endpoint : waiting) endpoint->StoreEvent(event);
}

bool TcpPorts::Accept(uint16_t number, uint32_t ip, NetHandle socket, EventSink* endpoint) {
  const auto known = ports_.find(number);
  // If the socket of the port `number` has failed, closes the port, so that the code below opens it
  // again with a new socket.
  if (known != ports_.end() && known->second->failed) Close(number);
  std::unique_ptr<Port>& port = ports_[number];
  if (port == nullptr) {
    if (ports_.size() > kPortsMax) {  // ports_ already includes the new port, added above
      ports_.erase(number);
      return false;
    }
    port = std::make_unique<Port>();
    port->listener = stack_->Open(port.get());
    if (ip != 0) stack_->network().SelectAddress(port->listener, ip);
    stack_->network().Listen(port->listener, number);
  }
  port->waiting.push_back(endpoint);
  stack_->network().Accept(port->listener, socket);
  return true;
}

void TcpPorts::Forget(uint16_t number, const EventSink* endpoint) {
  const auto found = ports_.find(number);
  if (found != ports_.end()) std::erase(found->second->waiting, endpoint);
}

void TcpPorts::Close(uint16_t number) {
  const auto found = ports_.find(number);
  if (found == ports_.end()) return;
  stack_->Drop(found->second->listener, false);
  ports_.erase(found);
}

void TcpPorts::CloseAll() {
  while (!ports_.empty()) Close(ports_.begin()->first);
}

}  // namespace openr_host
