#include "runtime/gateway/gateway_connection.h"

#include <EndpointTypes.h>
#include <IPAddress.h>
#include <antEnvMsg.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "runtime/core/system.h"
#include "runtime/gateway/tcp_gateway.h"
#include "runtime/ipstack/ip_stack.h"

namespace openr_host {
namespace {

constexpr int kReceiveBytes = 8192;
constexpr int kSendBytes = 32768;

// Returns advice for the user: a robot that is a run on this computer has the address 127.0.0.1,
// but an old HOSTGW.CFG still has the address of a real robot.  Returns "" if `address` is already
// an address of this computer (127.x.x.x), or if --ip replaces `address` by another address.
std::string HintFor(const IPAddress& address) {
  const IpStack* const stack = IpStack::OfCurrent();
  if (address.InLoop() || stack == nullptr) return "";
  for (const AddressPair& pair : stack->options().addresses)
    if (pair.robot == address.Address()) return "";
  return fmt::format(
      "; a robot that openr runs on this computer is 127.0.0.1: write that, or run with --ip "
      "{}=127.0.0.1",
      AddressText(address.Address()));
}

}  // namespace

GatewayConnection::GatewayConnection(TcpGateway* gateway, int index, const GatewayRecord& record,
                                     Owner* owner)
    : gateway_(gateway), index_(index), record_(record), owner_(owner) {}

void GatewayConnection::Warn(const std::string& text) {
  gateway_->system().AddFindingAbout(
      &gateway_->host(), Severity::kWarning,
      fmt::format("{} (port {}): {}", record_.Name(), record_.port, text));
}

template <typename M>
void GatewayConnection::Post(M message) {
  message.continuation = reinterpret_cast<void*>(static_cast<intptr_t>(index_));
  gateway_->PostToStack(&message, sizeof message);
}

bool GatewayConnection::NewBuffer() {
  antEnvCreateSharedBufferMsg create(kReceiveBytes + kSendBytes);
  if (create.Call(gateway_->stack(), sizeof create) != ANT_SUCCESS) return false;
  if (create.error != ANT_SUCCESS || create.buffer.Map() != ANT_SUCCESS) return false;
  shared_buffer_ = static_cast<byte*>(create.buffer.GetAddress());
  return true;
}

antModuleRef GatewayConnection::NewEndpoint() {
  antEnvCreateEndpointMsg create(EndpointType_TCP, 2 * kSendBytes);
  create.Call(gateway_->stack(), sizeof create);
  if (create.error == ANT_SUCCESS) return create.moduleRef;
  Warn(fmt::format("no endpoint, error {}; the service is not connected",
                   static_cast<int>(create.error)));
  return {};
}

void GatewayConnection::Open() {
  if (shared_buffer_ == nullptr && !NewBuffer()) {
    Warn("no shared buffer; the service is not connected");
    return;
  }
  if (record_.host.empty()) {
    Listen();
  } else {
    Connect();
    if (!had_answer_) gateway_->CheckForAnswerLater(index_, kHintUs);
  }
}

// Warns that the peer does not answer.  The warning comes before the connect itself fails, because
// a connect to an address that drops packets fails only after minutes.
void GatewayConnection::WarnIfNoAnswer() {
  const std::string hint = HintFor(IPAddress(record_.host.c_str()));
  if (had_answer_ || hint.empty()) return;
  Warn(fmt::format("no answer from {} within {} s{}", record_.host, kHintUs / 1'000'000, hint));
}

void GatewayConnection::Listen() {
  listener_ = NewEndpoint();
  if (!listener_.IsNull()) Post(TCPEndpointListenMsg(listener_, IP_ADDR_ANY, record_.port));
}

void GatewayConnection::HandleListenAnswer(const TCPEndpointListenMsg& answer) {
  if (answer.dstModule != listener_) return;
  if (answer.error != TCP_SUCCESS) {
    Warn(fmt::format("cannot listen, error {}", static_cast<int>(answer.error)));
    return;
  }
  // Listens with a new endpoint, because the endpoint that listened has become the connection to
  // `client`.
  const antModuleRef client = listener_;
  Listen();
  if (is_up_) {
    Warn("a second connection is refused; a service of the gateway carries one");
    Close(client);
  } else {
    UseConnection(client);
  }
}

void GatewayConnection::Connect() {
  endpoint_ = NewEndpoint();
  if (endpoint_.IsNull()) return;
  Post(TCPEndpointConnectMsg(endpoint_, IP_ADDR_ANY, IP_PORT_ANY, IPAddress(record_.host.c_str()),
                             record_.port));
}

void GatewayConnection::HandleConnectAnswer(const TCPEndpointConnectMsg& answer) {
  if (answer.dstModule != endpoint_) return;
  had_answer_ = true;
  if (answer.error == TCP_SUCCESS) return UseConnection(endpoint_);
  Warn(fmt::format("cannot connect to {}, error {}; tried again every second{}", record_.host,
                   static_cast<int>(answer.error), HintFor(IPAddress(record_.host.c_str()))));
  Close(endpoint_);
  endpoint_ = antModuleRef();
  gateway_->OpenLater(index_, kRetryUs);
}

void GatewayConnection::UseConnection(const antModuleRef& endpoint) {
  endpoint_ = endpoint;
  is_up_ = true;
  Receive();
  owner_->Up();
}

void GatewayConnection::Receive() {
  ASSERT(is_up_ && shared_buffer_ != nullptr, "service {}", index_);
  Post(TCPEndpointReceiveMsg(endpoint_, shared_buffer_, 1, kReceiveBytes));
}

void GatewayConnection::Send(std::string_view bytes) {
  ASSERT(is_up_, "service {}", index_);
  out_ += bytes;
  if (!is_sending_) SendNext();
}

void GatewayConnection::SendNext() {
  const size_t size = std::min<size_t>(out_.size(), kSendBytes);
  is_sending_ = size > 0;
  if (size == 0) return owner_->Sent();
  byte* const data = shared_buffer_ + kReceiveBytes;
  std::memcpy(data, out_.data(), size);
  out_.erase(0, size);
  Post(TCPEndpointSendMsg(endpoint_, data, static_cast<int>(size)));
}

void GatewayConnection::Close(antModuleRef endpoint) { Post(TCPEndpointCloseMsg(endpoint)); }

void GatewayConnection::Refuse(const std::string& why) {
  Warn(fmt::format("the connection is closed: the stream {}", why));
  Lose();
}

// Closes the connection to the peer, the gateway of another computer, after an error.  If this is
// the robot's side, another endpoint listens already; the host's side tries to connect again after
// kRetryUs.
void GatewayConnection::Lose() {
  ASSERT(is_up_, "service {}", index_);
  Close(endpoint_);
  endpoint_ = antModuleRef();
  is_up_ = is_sending_ = false;
  out_.clear();
  owner_->Down();
  if (!record_.host.empty()) gateway_->OpenLater(index_, kRetryUs);
}

void GatewayConnection::HandleAnswer(const antEnvMsg& answer) {
  switch (answer.dstOperation) {
    case TCPEndpoint_Operation_Listen:
      return HandleListenAnswer(static_cast<const TCPEndpointListenMsg&>(answer));
    case TCPEndpoint_Operation_Connect:
      return HandleConnectAnswer(static_cast<const TCPEndpointConnectMsg&>(answer));
    case TCPEndpoint_Operation_Close:
      return;
    default:
      break;
  }
  // Ignores an answer of the network stack that belongs to a connection which has ended.
  if (!is_up_ || answer.dstModule != endpoint_) return;
  if (static_cast<const TCPEndpointBaseMsg&>(answer).error != TCP_SUCCESS) return Lose();
  if (answer.dstOperation == TCPEndpoint_Operation_Send) return SendNext();
  const auto& receive = static_cast<const TCPEndpointReceiveMsg&>(answer);
  owner_->Received(
      {reinterpret_cast<const char*>(receive.buffer), static_cast<size_t>(receive.sizeMin)});
  if (is_up_) Receive();
}

void GatewayConnection::HashState(Hasher* hasher) const {
  hasher->Add(listener_.index);
  hasher->Add(endpoint_.index);
  hasher->Add(is_up_);
  hasher->Add(is_sending_);
  hasher->AddText(out_);
}

}  // namespace openr_host
