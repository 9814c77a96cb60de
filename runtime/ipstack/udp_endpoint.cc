#include "runtime/ipstack/udp_endpoint.h"

#include <EndpointTypes.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "runtime/ipstack/ant_message.h"
#include "runtime/ipstack/ip_stack.h"

namespace openr_host {

UDPEndpointError UdpErrorOf(NetError error) {
  switch (error) {
    case NetError::kNone:
      return UDP_SUCCESS;
    case NetError::kClosed:
      return UDP_CONNECTION_CLOSED;
    case NetError::kAddressInUse:
      return UDP_ADDRESSINUSE;
    case NetError::kBadAddress:
      return UDP_ADDRESSERROR;
    case NetError::kRefused:
      return UDP_PORT_UNREACHABLE;
    case NetError::kHostUnreachable:
      return UDP_HOST_UNREACHABLE;
    case NetError::kNetworkUnreachable:
      return UDP_NETWORK_UNREACHABLE;
    case NetError::kTooLong:
      return UDP_MESSAGE_TOO_LONG;
    default:
      return UDP_FAIL;
  }
}

UdpEndpoint::UdpEndpoint(IpStack* stack, ObjectId owner, int32_t pool_bytes)
    : Endpoint(stack, EndpointType_UDP, owner, pool_bytes) {}

void UdpEndpoint::Start(const Operation& operation) {
  switch (operation.message().dstOperation) {
    case UDPEndpoint_Operation_Bind:
      return Bind(operation);
    case UDPEndpoint_Operation_Connect:
      return Connect(operation);
    case UDPEndpoint_Operation_ResetConnect:
      return ResetConnect(operation);
    case UDPEndpoint_Operation_Send:
      return Send(operation);
    case UDPEndpoint_Operation_Receive:
      return Receive(operation);
    case UDPEndpoint_Operation_Close:
      return Close(operation);
    case UDPEndpoint_Operation_Address:
      return Address(operation);
    default:
      return Refuse(operation, UDP_OPERATION_UNKNOWN);
  }
}

void UdpEndpoint::Refuse(Operation operation, UDPEndpointError error) {
  stack_->Answer(&operation, error);
}

void UdpEndpoint::Finish(std::optional<Operation>* operation, UDPEndpointError error,
                         const void* data, size_t size) {
  ASSERT(operation->has_value());
  stack_->Answer(&**operation, error, data, size);
  operation->reset();
}

void UdpEndpoint::Bind(Operation operation) {
  auto& message = operation.As<UDPEndpointBindMsg>();
  if (socket_ != 0) return Refuse(operation, UDP_OPERATION_INVALID);
  if (!stack_->IsOwnAddress(message.address.Address())) return Refuse(operation, UDP_ADDRESSERROR);
  const bool any_port = message.port == 0;
  const uint16_t port = any_port ? stack_->ChoosePort() : message.port;
  if (port == 0 || !stack_->ReserveUdpPort(port)) return Refuse(operation, UDP_ADDRESSINUSE);
  port_ = port;
  local_ip_ = message.address.Address();
  socket_ = stack_->Open(this);
  if (const uint32_t ip = stack_->FurtherAddress(local_ip_); ip != 0)
    stack_->network().SelectAddress(socket_, ip);
  stack_->network().Bind(socket_, port, any_port);
  message.address = stack_->LocalAddress(local_ip_);
  message.port = port;
  stack_->Answer(&operation, UDP_SUCCESS);
}

void UdpEndpoint::Connect(Operation operation) {
  const auto& message = operation.As<UDPEndpointConnectMsg>();
  if (socket_ == 0) return Refuse(operation, UDP_OPERATION_INVALID);
  if (message.address.Address() == 0 || message.port == 0) {
    return Refuse(operation, UDP_ADDRESSERROR);
  }
  peer_ = {message.address.Address(), message.port};
  stack_->Answer(&operation, UDP_SUCCESS);
}

void UdpEndpoint::ResetConnect(Operation operation) {
  peer_ = {};
  stack_->Answer(&operation, UDP_SUCCESS);
}

NetAddress UdpEndpoint::DestinationOf(const UDPEndpointSendMsg& message) const {
  if (peer_.ip != 0) return peer_;
  const uint32_t ip = message.address.Address();
  // Returns no destination for a broadcast, so that Send refuses it.  Broadcasts also failed on the
  // robot (BBS 402, a message of Sony's developer board).
  return ip == 0xffffffffu || message.port == 0 ? NetAddress{} : NetAddress{ip, message.port};
}

// If a Send or Receive cannot be executed, answers it with an error and returns true.  Otherwise
// returns false.  The operation can be executed if the socket is bound and without error, no
// operation of the same kind is pending (`busy`), and the `size` bytes at `buffer` lie in a shared
// buffer.
bool UdpEndpoint::RefuseTransfer(const Operation& operation, bool busy, const byte* buffer,
                                 int size) {
  UDPEndpointError error = error_;
  if (socket_ == 0) {
    error = UDP_OPERATION_INVALID;
  } else if (busy) {
    error = UDP_CONNECTION_BUSY;
  } else if (!stack_->buffers().Contains(buffer, size)) {
    error = UDP_BUFFER_INVALID;
  }
  if (error != UDP_SUCCESS) Refuse(operation, error);
  return error != UDP_SUCCESS;
}

void UdpEndpoint::Send(const Operation& operation) {
  Operation accepted = operation;
  const auto& message = accepted.As<UDPEndpointSendMsg>();
  if (RefuseTransfer(operation, send_.has_value(), message.buffer, message.size)) return;
  if (DestinationOf(message).ip == 0) return Refuse(operation, UDP_ADDRESSERROR);
  if (message.size > kDatagramMax) return Refuse(operation, UDP_MESSAGE_TOO_LONG);
  if (message.size > pool_bytes_) {
    stack_->Warn(
        operation,
        fmt::format("UDP Send of {} bytes fails: the endpoint was created with a pool of {} "
                    "bytes; a pool holds a little more than the largest datagram",
                    message.size, pool_bytes_));
    return Refuse(operation, UDP_FAIL);
  }
  if (message.size > kRobotDatagramMax) {
    stack_->Warn(operation, fmt::format("a UDP datagram of more than {} bytes is sent: the robot's "
                                        "IPStack crashed at such sizes",
                                        kRobotDatagramMax));
  }
  NoteSecondSend(operation);
  send_ = accepted;
}

// Adds a note if the program has sent this Send and the Send before it in the same handler, without
// waiting for an answer.  This stack executes both, but the robot's stack executes only one Send at
// a time, so this Send may fail on the robot (network.md, 5).
void UdpEndpoint::NoteSecondSend(const Operation& operation) {
  const uint64_t cause = operation.ticket.box == 0 ? operation.cause : 0;
  if (cause != 0 && cause == last_send_cause_) {
    stack_->Note(operation,
                 "UDP Send before the answer to the last one: on the robot it may fail with "
                 "UDP_CONNECTION_BUSY, and one developer's first Send was never answered; send "
                 "again when the answer has come");
  }
  last_send_cause_ = cause;
}

void UdpEndpoint::Receive(const Operation& operation) {
  Operation accepted = operation;
  const auto& message = accepted.As<UDPEndpointReceiveMsg>();
  if (RefuseTransfer(operation, receive_.has_value(), message.buffer, message.size)) return;
  receive_ = accepted;
}

void UdpEndpoint::Close(Operation operation) {
  for (std::optional<Operation>* pending : {&send_, &receive_}) {
    if (!*pending) continue;
    Refuse(**pending, UDP_CONNECTION_CLOSED);
    pending->reset();
  }
  Drop();
  stack_->Answer(&operation, UDP_SUCCESS);
}

void UdpEndpoint::Address(Operation operation) {
  auto& message = operation.As<UDPEndpointAddressMsg>();
  message.lAddress = stack_->LocalAddress(local_ip_);
  message.lPort = port_;
  message.fAddress = peer_.ip;
  message.fPort = peer_.port;
  stack_->Answer(&operation, UDP_SUCCESS);
}

void UdpEndpoint::StoreEvent(const NetworkEvent& event) {
  if (event.kind == NetworkEvent::Kind::kFailed) {
    asked_ = false;
    error_ = UdpErrorOf(event.error);
  } else if (event.kind == NetworkEvent::Kind::kDatagram) {
    asked_ = false;
    waiting_.push_back(event);
  }
}

void UdpEndpoint::AnswerReady() {
  if (send_) FinishSend();
  if (receive_) FinishReceive();
}

void UdpEndpoint::FinishSend() {
  const auto& message = send_->As<UDPEndpointSendMsg>();
  if (error_ != UDP_SUCCESS) return Finish(&send_, error_);
  if (sent_in_frame_ + message.size > pool_bytes_) return;
  // The shared buffer with the data is checked again, because the program may have destroyed or
  // unmapped it while the Send waited.
  if (!stack_->buffers().Contains(message.buffer, message.size)) {
    return Finish(&send_, UDP_BUFFER_INVALID);
  }
  const auto size = static_cast<size_t>(message.size);
  const byte* const data = message.buffer;
  stack_->WarnIfChanged(*send_, data, size);
  stack_->network().SendTo(socket_, DestinationOf(message), data, size);
  sent_in_frame_ += message.size;
  Finish(&send_, UDP_SUCCESS, data, size);
}

// Returns whether a datagram from `sender` comes from the connected peer.  The network gives the
// robot's own address for a datagram that the robot has sent to itself.  So if the program has
// connected to 127.0.0.1, its own robot, also accepts the robot's own address.
bool UdpEndpoint::IsFromPeer(const NetAddress& sender) const {
  return sender == peer_ ||
         (IPAddress(peer_.ip).InLoop() && sender == NetAddress{stack_->address(), peer_.port});
}

// Drops the waiting datagrams in front of the first datagram of the connected peer, because after
// Connect only the peer's datagrams are delivered.  Without a connected peer, drops no datagrams.
// Returns whether a datagram is left.
bool UdpEndpoint::DropFromOtherSenders() {
  while (peer_.ip != 0 && !waiting_.empty() && !IsFromPeer(waiting_.front().remote)) {
    waiting_.pop_front();
  }
  return !waiting_.empty();
}

void UdpEndpoint::FinishReceive() {
  auto& message = receive_->As<UDPEndpointReceiveMsg>();
  const int room = message.size;
  if (error_ != UDP_SUCCESS) return Finish(&receive_, error_);
  if (!DropFromOtherSenders()) {
    if (!asked_) stack_->network().ReceiveFrom(socket_, kReadAhead);
    asked_ = true;
    return;
  }
  // The shared buffer for the data is checked again, because the program may have destroyed or
  // unmapped it while the Receive waited.
  if (!stack_->buffers().Contains(message.buffer, room)) {
    return Finish(&receive_, UDP_BUFFER_INVALID);
  }
  const NetworkEvent datagram = std::move(waiting_.front());
  waiting_.pop_front();
  const size_t count = std::min(datagram.bytes.size(), static_cast<size_t>(room));
  std::memcpy(message.buffer, datagram.bytes.data(), count);
  message.address = datagram.remote.ip;
  message.port = datagram.remote.port;
  message.size = static_cast<int>(count);
  const byte* const data = message.buffer;
  Finish(&receive_, UDP_SUCCESS, data, count);
}

bool UdpEndpoint::WaitsForNetwork() const {
  return !dead_ && (receive_ || send_ || sent_in_frame_ > 0);
}

void UdpEndpoint::Drop() {
  if (socket_ != 0) stack_->ReturnUdpPort(port_);
  stack_->Drop(socket_, false);
  socket_ = 0;
  dead_ = true;
}

void UdpEndpoint::HashState(Hasher* hasher) const {
  hasher->Add(port_);
  hasher->Add(peer_.ip);
  hasher->Add(peer_.port);
  hasher->Add(error_);
  hasher->Add(asked_);
  hasher->Add(sent_in_frame_);
  for (const NetworkEvent& datagram : waiting_) {
    hasher->Add(datagram.remote.ip);
    hasher->Add(datagram.remote.port);
    hasher->AddText(datagram.bytes);
  }
  for (const auto* pending : {&send_, &receive_}) {
    hasher->Add(pending->has_value());
    if (*pending) hasher->Add(AntMessageHash((*pending)->message()));
  }
}

}  // namespace openr_host
