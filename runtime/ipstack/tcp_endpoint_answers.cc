// The functions of TcpEndpoint that answer pending operations (Listen, Connect, Send, Receive,
// Close) as soon as the network allows it.
#include <algorithm>
#include <cstring>

#include "runtime/base/hasher.h"
#include "runtime/core/system.h"
#include "runtime/ipstack/ip_stack.h"
#include "runtime/ipstack/tcp_endpoint.h"

namespace openr_host {

void TcpEndpoint::AnswerReady() {
  if (opening_) FinishOpening();
  if (send_) FinishSend();
  if (receive_) FinishReceive();
  if (close_) FinishClose();
}

void TcpEndpoint::FinishOpening() {
  if (state_ == State::kListening || state_ == State::kConnecting) return;
  LeavePort();
  if (state_ == State::kFailed) return Finish(&opening_, error_);
  // Uses a generic lambda, because the messages of Listen and Connect have the same fields but
  // different types.
  const auto fill = [this](auto& message) {
    message.lAddress = stack_->LocalAddress(local_ip_);
    message.lPort = local_port_;
    message.fAddress = remote_.ip;
    message.fPort = remote_.port;
  };
  if (opening_->message().dstOperation == TCPEndpoint_Operation_Listen) {
    fill(opening_->As<TCPEndpointListenMsg>());
  } else {
    fill(opening_->As<TCPEndpointConnectMsg>());
  }
  Finish(&opening_, TCP_SUCCESS);
}

void TcpEndpoint::FinishSend() {
  const auto& message = send_->As<TCPEndpointSendMsg>();
  if (state_ == State::kFailed) return Finish(&send_, error_);
  if (unsent_ + message.size > pool_bytes_) return;
  // Checks the shared buffer with the data again, because the program may have destroyed or
  // unmapped it while the Send waited.
  if (!stack_->buffers().Contains(message.buffer, message.size)) {
    return Finish(&send_, TCP_BUFFER_INVALID);
  }
  const auto size = static_cast<size_t>(message.size);
  const byte* const data = message.buffer;
  stack_->WarnIfChanged(*send_, data, size);
  stack_->network().Send(socket_, data, size);
  unsent_ += message.size;
  const uint64_t chain[2] = {sent_hash_, HashBytes(data, size)};
  sent_hash_ = HashBytes(chain, sizeof chain);
  Finish(&send_, TCP_SUCCESS, data, size);
}

void TcpEndpoint::FinishReceive() {
  auto& message = receive_->As<TCPEndpointReceiveMsg>();
  const auto min = static_cast<size_t>(message.sizeMin);
  const auto max = static_cast<size_t>(message.sizeMax);
  // If the peer has ended the stream, a Receive gets fewer bytes than its sizeMin, because no more
  // bytes come.
  const bool enough = in_.size() >= min || (ended_ && !in_.empty());
  if (!enough && state_ != State::kFailed && !ended_) {
    if (!asked_) {
      stack_->network().Receive(socket_, std::max(max, kReadAheadBytes) - in_.size());
    }
    asked_ = true;
    return;
  }
  if (!enough) return Finish(&receive_, state_ == State::kFailed ? error_ : TCP_CONNECTION_CLOSED);
  // Checks the shared buffer for the data again, because the program may have destroyed or unmapped
  // it while the Receive waited.
  if (!stack_->buffers().Contains(message.buffer, message.sizeMax)) {
    return Finish(&receive_, TCP_BUFFER_INVALID);
  }
  const size_t count = std::min(in_.size(), max);
  byte* const data = message.buffer;
  std::memcpy(data, in_.data(), count);
  message.sizeMin = message.sizeMax = static_cast<int>(count);
  in_.erase(0, count);
  small_row_ = 0;
  Finish(&receive_, TCP_SUCCESS, data, count);
}

void TcpEndpoint::FinishClose() {
  const int64_t waited_us = stack_->system().now_us() - closing_since_us_;
  if (!closed_ && waited_us < (unsent_ > 0 ? kUnsentUs : kPeerEndUs)) return;
  stack_->Drop(socket_, false);
  dead_ = true;
  Finish(&close_, TCP_SUCCESS);
}

}  // namespace openr_host
