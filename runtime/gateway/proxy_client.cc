#include "runtime/gateway/proxy_client.h"

#include <fmt/format.h>
#include <sError.h>

#include <cstring>
#include <utility>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "runtime/core/system.h"
#include "runtime/gateway/tcp_gateway.h"

namespace openr_host {

void ProxyClient::AddRequest(const void* payload, size_t size) {
  ProxyRequest head;
  Request request;
  request.ticket = gateway_->system().requests().TakeTicket();
  if (request.ticket.box == 0 || size < sizeof head) return;
  std::memcpy(&head, payload, sizeof head);
  if (head.size > size - sizeof head) return;
  request.since_us = gateway_->system().now_us();
  request.object.assign(head.object, strnlen(head.object, sizeof head.object));
  request.selector = head.selector;
  request.reply_size = head.reply_size;
  request.bytes.assign(static_cast<const char*>(payload) + sizeof head, head.size);
  requests_.push_back(std::move(request));
  if (has_timed_out_ && !connection_.is_up()) return AnswerAll(sTIMEOUT);
  WatchTime();
  SendNext();
}

// Posts a message that calls Expire() at the time limit of the oldest request (a call that waits
// for the robot's answer).  Posts only one such message at a time, because the other requests have
// later limits.  If the oldest request is answered before its limit, Expire() calls this function
// again for the next request.
void ProxyClient::WatchTime() {
  if (is_expire_posted_ || requests_.empty()) return;
  is_expire_posted_ = true;
  gateway_->ExpireLater(requests_.front().since_us + kPatienceUs - gateway_->system().now_us());
}

void ProxyClient::Expire() {
  is_expire_posted_ = false;
  if (requests_.empty() || gateway_->system().now_us() < requests_.front().since_us + kPatienceUs)
    return WatchTime();
  has_timed_out_ = true;
  gateway_->Warn(
      fmt::format("the robot has not answered an OPEN-R call within {} s; calls fail until it is "
                  "there (port and address of !ROBOT_PROXY in HOSTGW.CFG, "
                  "TCPGateway.Proxy.AperiosMessage.P in the robot's ROBOTGW.CFG)",
                  kPatienceUs / 1'000'000));
  // Closes an open connection to the robot if the robot has not answered an OPEN-R call in time,
  // because a late answer would be taken for the answer to the next call.  Refuse() closes the
  // connection and also makes all waiting calls fail.
  if (connection_.is_up()) return connection_.Refuse("has no answer to a call");
  AnswerAll(sTIMEOUT);
}

void ProxyClient::Up() {
  has_timed_out_ = false;
  SendNext();
}

void ProxyClient::Down() {
  stream_ = {};
  oids_.clear();
  is_request_sent_ = false;
  AnswerAll(sFAIL);
}

void ProxyClient::SendNext() {
  if (is_request_sent_ || requests_.empty() || !connection_.is_up()) return;
  is_request_sent_ = true;
  // A call needs the OID of a system object of the robot, but the caller has given only the
  // object's name.  So before the first call to an object, asks the robot for the OID of this
  // object.
  const Request& request = requests_.front();
  ProxyFrame frame;
  if (const auto known = oids_.find(request.object); known == oids_.end()) {
    frame.command = ProxyCommand::kFind;
    frame.name = request.object;
  } else {
    frame.command = ProxyCommand::kCall;
    frame.oid = known->second;
    frame.selector = request.selector;
    frame.reply_size = request.reply_size;
    frame.bytes = request.bytes;
  }
  connection_.Send(EncodeProxyFrame(frame));
}

void ProxyClient::Received(std::string_view bytes) {
  stream_.Feed(bytes);
  GatewaySet set;
  GatewayStream::Result result;
  while ((result = stream_.NextSet(&set)) == GatewayStream::Result::kTaken) {
    ProxyFrame frame;
    std::string problem = set.size() == 1
                              ? DecodeProxyFrame(set[0], &frame)
                              : fmt::format("has {} items; an answer has one", set.size());
    if (problem.empty() && !is_request_sent_) problem = "has an answer that nobody asked for";
    if (!problem.empty()) return connection_.Refuse(problem);
    HandleAnswer(frame);
    if (!connection_.is_up()) return;
  }
  if (result == GatewayStream::Result::kBroken) connection_.Refuse(stream_.error());
}

void ProxyClient::HandleAnswer(const ProxyFrame& frame) {
  ASSERT(is_request_sent_ && !requests_.empty());
  const std::string object = requests_.front().object;
  const bool is_found = oids_.contains(object);
  if (frame.command != (is_found ? ProxyCommand::kCallReply : ProxyCommand::kFindReply))
    return connection_.Refuse("has the answer to another command than was sent");
  is_request_sent_ = false;
  if (is_found) {
    Answer(static_cast<int32_t>(frame.error), frame.bytes);
  } else if (frame.error == sSUCCESS) {
    oids_[object] = frame.oid;
  } else {
    gateway_->Warn(fmt::format("the robot has no object {}, error {}", object, frame.error));
    Answer(static_cast<int32_t>(frame.error));
  }
  SendNext();
}

void ProxyClient::Answer(int32_t error, const std::string& bytes) {
  ASSERT(!requests_.empty());
  const Request request = std::move(requests_.front());
  requests_.pop_front();
  std::string reply =
      EncodeWord(static_cast<uint32_t>(error)) + bytes.substr(0, request.reply_size);
  gateway_->system().requests().Reply(request.ticket, reply.data(), reply.size());
}

void ProxyClient::AnswerAll(int32_t error) {
  while (!requests_.empty()) Answer(error);
}

void ProxyClient::HashState(Hasher* hasher) const {
  GatewayChannel::HashState(hasher);
  hasher->Add(is_request_sent_);
  hasher->Add(has_timed_out_);
  hasher->Add(is_expire_posted_);
  for (const Request& request : requests_) {
    hasher->Add(request.since_us);
    hasher->AddText(request.bytes);
  }
  for (const auto& [name, oid] : oids_) {
    hasher->AddText(name);
    hasher->Add(oid);
  }
}

}  // namespace openr_host
