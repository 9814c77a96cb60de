#include "runtime/ipstack/tcp_endpoint.h"

#include <EndpointTypes.h>
#include <fmt/format.h>

#include <algorithm>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "runtime/core/system.h"
#include "runtime/ipstack/ant_message.h"
#include "runtime/ipstack/ip_stack.h"

namespace openr_host {

TCPEndpointError TcpErrorOf(NetError error) {
  switch (error) {
    case NetError::kNone:
      return TCP_SUCCESS;
    case NetError::kFailed:
      return TCP_FAIL;
    case NetError::kClosed:
      return TCP_CONNECTION_CLOSED;
    case NetError::kReset:
      return TCP_CONNECTION_RESET;
    case NetError::kTimeout:
      return TCP_CONNECTION_TIMEOUT;
    case NetError::kAddressInUse:
      return TCP_ADDRESSINUSE;
    case NetError::kBadAddress:
      return TCP_ADDRESSERROR;
    case NetError::kRefused:
      return TCP_PORT_UNREACHABLE;
    case NetError::kHostUnreachable:
      return TCP_HOST_UNREACHABLE;
    case NetError::kNetworkUnreachable:
      return TCP_NETWORK_UNREACHABLE;
    case NetError::kTooLong:
      return TCP_MESSAGE_TOO_LONG;
  }
  return TCP_FAIL;
}

TcpEndpoint::TcpEndpoint(IpStack* stack, ObjectId owner, int32_t pool_bytes)
    : Endpoint(stack, EndpointType_TCP, owner, pool_bytes) {}

void TcpEndpoint::Start(const Operation& operation) {
  switch (operation.message().dstOperation) {
    case TCPEndpoint_Operation_Bind:
      return Bind(operation);
    case TCPEndpoint_Operation_Listen:
      return Listen(operation);
    case TCPEndpoint_Operation_Connect:
      return Connect(operation);
    case TCPEndpoint_Operation_Send:
      return Send(operation);
    case TCPEndpoint_Operation_Receive:
      return Receive(operation);
    case TCPEndpoint_Operation_Close:
      return Close(operation);
    case TCPEndpoint_Operation_Address:
      return Address(operation);
    default:
      return Refuse(operation, TCP_OPERATION_UNKNOWN);
  }
}

void TcpEndpoint::Refuse(Operation operation, TCPEndpointError error) {
  stack_->Answer(&operation, error);
}

void TcpEndpoint::Finish(std::optional<Operation>* operation, TCPEndpointError error,
                         const void* data, size_t size) {
  ASSERT(operation->has_value());
  stack_->Answer(&**operation, error, data, size);
  operation->reset();
}

void TcpEndpoint::Bind(Operation operation) {
  const auto& message = operation.As<TCPEndpointBindMsg>();
  if (RefuseOpen(operation, message.lAddress)) return;
  local_port_ = message.lPort;
  stack_->Answer(&operation, TCP_SUCCESS);
}

// If a Bind, Listen or Connect cannot be executed, answers it with an error and returns true.
// Otherwise returns false.  The operation can be executed if the endpoint is new, no Listen or
// Connect is pending, and `local` is an address of the robot.
bool TcpEndpoint::RefuseOpen(const Operation& operation, const IPAddress& local) {
  TCPEndpointError error = TCP_SUCCESS;
  if (opening_) {
    error = TCP_CONNECTION_BUSY;
  } else if (state_ != State::kNew) {
    error = TCP_OPERATION_INVALID;
  } else if (!stack_->IsOwnAddress(local.Address())) {
    error = TCP_ADDRESSERROR;
  }
  if (error != TCP_SUCCESS) Refuse(operation, error);
  return error != TCP_SUCCESS;
}

void TcpEndpoint::Listen(const Operation& operation) {
  Operation accepted = operation;
  const auto& message = accepted.As<TCPEndpointListenMsg>();
  if (RefuseOpen(operation, message.lAddress)) return;
  if (message.lAddress.Address() != 0) local_ip_ = message.lAddress.Address();
  if (message.lPort != 0) local_port_ = message.lPort;
  stack_chose_port_ = local_port_ == 0;
  if (stack_chose_port_) local_port_ = stack_->ChoosePort();
  wanted_ = {message.fAddress.Address(), message.fPort};
  socket_ = stack_->Open(this);
  if (!stack_->tcp_ports().Accept(local_port_, stack_->FurtherAddress(local_ip_), socket_, this)) {
    stack_->Drop(socket_, false);
    socket_ = 0;
    stack_->Warn(operation,
                 fmt::format("TCP Listen on port {} refused: the stack listens on {} ports already",
                             local_port_, TcpPorts::kPortsMax));
    return Refuse(operation, TCP_FAIL);
  }
  opening_ = accepted;
  state_ = State::kListening;
}

void TcpEndpoint::Connect(const Operation& operation) {
  Operation accepted = operation;
  const auto& message = accepted.As<TCPEndpointConnectMsg>();
  if (RefuseOpen(operation, message.lAddress)) return;
  if (message.lAddress.Address() != 0) local_ip_ = message.lAddress.Address();
  const NetAddress remote{message.fAddress.Address(), message.fPort};
  if (remote.ip == 0 || remote.ip == 0xffffffffu || message.fAddress.InMulticast() ||
      remote.port == 0) {
    return Refuse(operation, TCP_ADDRESSERROR);
  }
  if (message.lPort != 0) local_port_ = message.lPort;
  if (local_port_ == 0) local_port_ = stack_->ChoosePort();
  remote_ = remote;
  socket_ = stack_->Open(this);
  stack_->network().Connect(socket_, local_port_, remote);
  opening_ = accepted;
  state_ = State::kConnecting;
}

// If a Send or Receive cannot be executed, answers it with an error and returns true.  Otherwise
// returns false.  The operation can be executed if the connection is open and no operation of the
// same kind is pending (`busy`).
bool TcpEndpoint::RefuseTransfer(const Operation& operation, bool busy) {
  TCPEndpointError error = TCP_SUCCESS;
  switch (state_) {
    case State::kNew:
    case State::kListening:
    case State::kConnecting:
      error = TCP_OPERATION_INVALID;
      break;
    case State::kActive:
      error = busy ? TCP_CONNECTION_BUSY : TCP_SUCCESS;
      break;
    case State::kClosing:
      error = TCP_CONNECTION_CLOSED;
      break;
    case State::kFailed:
      error = error_;
      break;
  }
  if (error != TCP_SUCCESS) Refuse(operation, error);
  return error != TCP_SUCCESS;
}

void TcpEndpoint::Send(const Operation& operation) {
  if (RefuseTransfer(operation, send_.has_value())) return;
  Operation accepted = operation;
  const auto& message = accepted.As<TCPEndpointSendMsg>();
  if (!stack_->buffers().Contains(message.buffer, message.size)) {
    return Refuse(operation, TCP_BUFFER_INVALID);
  }
  if (message.size > pool_bytes_) {
    stack_->Warn(
        operation,
        fmt::format("TCP Send of {} bytes fails: the endpoint was created with a pool of {} "
                    "bytes; a pool holds a little more than the largest send",
                    message.size, pool_bytes_));
    return Refuse(operation, TCP_FAIL);
  }
  const Object* const sender = stack_->system().object(operation.sender);
  if (sender != nullptr && !sender->is_system()) {
    WarnOfRobotTiming(operation, message.size);
    WarnOfSmallSends(operation, message.size);
  }
  send_ = accepted;
}

// Adds a finding if a Send of `size` bytes is slow on the robot.  On the host the same Send is
// fast: the host does not imitate the delay, because programs must not depend on the delay.
void TcpEndpoint::WarnOfRobotTiming(const Operation& operation, int size) {
  if (size > kRobotFastBytes && size <= kRobotSplitBytes) {
    stack_->Warn(
        operation,
        fmt::format("TCP Send of {} to {} bytes: the robot sends {} at once and the rest up "
                    "to 200 ms later; send fewer bytes or more at a time",
                    kRobotFastBytes + 1, kRobotSplitBytes, kRobotFastBytes));
  }
  if (size > kRobotSendBytes) {
    stack_->Warn(operation,
                 fmt::format("TCP Send of more than {} bytes: slow and often failing on the robot; "
                             "2 to 32 kB at a time were found best",
                             kRobotSendBytes));
  }
}

void TcpEndpoint::WarnOfSmallSends(const Operation& operation, int size) {
  const int64_t now_us = stack_->system().now_us();
  const bool goes_on = small_row_ > 0 && now_us - last_send_us_ < kRobotAcknowledgeUs;
  small_row_ = size > kRobotSmallBytes ? 0 : goes_on ? small_row_ + 1 : 1;
  ASSERT(small_row_ >= 0, "{}", small_row_);
  last_send_us_ = now_us;
  if (small_row_ != kRobotRow) return;
  stack_->Warn(operation,
               fmt::format("{} small TCP Sends in a row with nothing received in between: on the "
                           "robot Nagle's algorithm holds them back, up to 200 ms each; put them "
                           "into one Send",
                           kRobotRow));
}

void TcpEndpoint::Receive(const Operation& operation) {
  if (RefuseTransfer(operation, receive_.has_value())) return;
  Operation accepted = operation;
  const auto& message = accepted.As<TCPEndpointReceiveMsg>();
  if (message.sizeMin <= 0 || message.sizeMin > message.sizeMax ||
      !stack_->buffers().Contains(message.buffer, message.sizeMax)) {
    return Refuse(operation, TCP_BUFFER_INVALID);
  }
  receive_ = accepted;
}

void TcpEndpoint::Close(const Operation& operation) {
  if (close_) return Refuse(operation, TCP_CONNECTION_BUSY);
  for (std::optional<Operation>* pending : {&opening_, &send_, &receive_}) {
    if (!*pending) continue;
    Refuse(**pending, TCP_CONNECTION_CLOSED);
    pending->reset();
  }
  Operation accepted = operation;
  const bool abort = IsAbort(accepted.As<TCPEndpointCloseMsg>());
  if (state_ == State::kActive && !abort) {
    stack_->network().Close(socket_);
    state_ = State::kClosing;
    closing_since_us_ = stack_->system().now_us();
    close_ = accepted;
    return;
  }
  LeavePort();
  stack_->Drop(socket_, state_ == State::kActive);
  dead_ = true;
  stack_->Answer(&accepted, TCP_SUCCESS);
}

void TcpEndpoint::Address(Operation operation) {
  auto& message = operation.As<TCPEndpointAddressMsg>();
  message.lAddress = stack_->LocalAddress(local_ip_);
  message.lPort = local_port_;
  message.fAddress = remote_.ip;
  message.fPort = remote_.port;
  stack_->Answer(&operation, TCP_SUCCESS);
}

void TcpEndpoint::StoreEvent(const NetworkEvent& event) {
  switch (event.kind) {
    case NetworkEvent::Kind::kAccepted:
      return Accepted(event);
    case NetworkEvent::Kind::kConnected:
      if (state_ == State::kConnecting) state_ = State::kActive;
      return;
    case NetworkEvent::Kind::kSent:
      unsent_ -=
          static_cast<int64_t>(std::min<uint64_t>(event.count, static_cast<uint64_t>(unsent_)));
      if (state_ == State::kClosing) closing_since_us_ = stack_->system().now_us();
      return;
    case NetworkEvent::Kind::kReceived:
      asked_ = false;
      in_ += event.bytes;
      return;
    case NetworkEvent::Kind::kEnd:
      asked_ = false;
      ended_ = true;
      return;
    case NetworkEvent::Kind::kClosed:
      closed_ = true;
      return;
    case NetworkEvent::Kind::kFailed:
      return Fail(event.error);
    default:
      return;
  }
}

void TcpEndpoint::Accepted(const NetworkEvent& event) {
  if (state_ != State::kListening) return;
  const bool welcome = (wanted_.ip == 0 || wanted_.ip == event.remote.ip) &&
                       (wanted_.port == 0 || wanted_.port == event.remote.port);
  stack_->tcp_ports().Forget(local_port_, this);
  // Resets the connection if it comes from another peer than the one for which the program's Listen
  // waits (wanted_).  Then the endpoint waits for the next connection.
  if (!welcome) {
    stack_->Drop(socket_, true);
    socket_ = stack_->Open(this);
    stack_->tcp_ports().Accept(local_port_, stack_->FurtherAddress(local_ip_), socket_, this);
    return;
  }
  remote_ = event.remote;
  state_ = State::kActive;
}

void TcpEndpoint::Fail(NetError error) {
  if (state_ == State::kFailed) return;
  asked_ = false;
  unsent_ = 0;
  in_.clear();
  if (state_ == State::kClosing) {
    closed_ = true;
    return;
  }
  error_ = TcpErrorOf(error);
  ASSERT(error_ != TCP_SUCCESS, "the network reported a failure without an error");
  state_ = State::kFailed;
}

// Ends the wait of this endpoint for a connection to its local port.  If the network stack has
// chosen the port for this Listen, also closes the port, because no other endpoint listens on it.
void TcpEndpoint::LeavePort() {
  stack_->tcp_ports().Forget(local_port_, this);
  if (stack_chose_port_) stack_->tcp_ports().Close(local_port_);
  stack_chose_port_ = false;
}

bool TcpEndpoint::WaitsForNetwork() const {
  return !dead_ && (opening_ || receive_ || close_ || (state_ == State::kActive && unsent_ > 0));
}

void TcpEndpoint::Drop() {
  if (state_ == State::kListening) LeavePort();
  stack_->Drop(socket_, state_ == State::kActive || state_ == State::kClosing);
  dead_ = true;
}

void TcpEndpoint::HashState(Hasher* hasher) const {
  hasher->Add(state_);
  hasher->Add(local_port_);
  hasher->Add(remote_.ip);
  hasher->Add(remote_.port);
  hasher->Add(error_);
  hasher->AddText(in_);
  hasher->Add(asked_);
  hasher->Add(ended_);
  hasher->Add(closed_);
  hasher->Add(unsent_);
  hasher->Add(sent_hash_);
  for (const auto* pending : {&opening_, &send_, &receive_, &close_}) {
    hasher->Add(pending->has_value());
    if (*pending) hasher->Add(AntMessageHash((*pending)->message()));
  }
}

}  // namespace openr_host
