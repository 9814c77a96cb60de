#include "runtime/gateway/gateway_channel.h"

#include <fmt/format.h>

#include <utility>

#include "runtime/base/hasher.h"
#include "runtime/gateway/tcp_gateway.h"

namespace openr_host {

void GatewayChannel::HashState(Hasher* hasher) const {
  connection_.HashState(hasher);
  hasher->AddText(stream_.bytes());
}

void OutgoingChannel::Up() { observer_->AssertReady(); }

void OutgoingChannel::Notify(const ONotifyEvent& event) {
  // Drops data that the subject sends while the gateway has no connection to the other computer.
  // The subject may have sent them before it received the "not ready" that Down() sends.
  if (!connection_.is_up()) {
    gateway_->host().statistics().NoteDropped();
    return;
  }
  GatewaySet set;
  for (int i = 0; i < event.NumOfData(); ++i) {
    RCRegion* const region = event.RCData(i);
    set.emplace_back(region->Base(), region->Size());
  }
  held_ = EncodeSet(set);
  SendHeld();
}

void OutgoingChannel::SendHeld() {
  if (!peer_is_ready_ || held_.empty() || connection_.is_sending()) return;
  peer_is_ready_ = false;  // each ready of the peer is valid for one notification only
  const std::string bytes = std::exchange(held_, "");
  connection_.Send(bytes);
  observer_->AssertReady();
}

void OutgoingChannel::Received(std::string_view bytes) {
  stream_.Feed(bytes);
  uint32_t word = 0;
  while (stream_.NextWord(&word) == GatewayStream::Result::kTaken) {
    if (word > kGatewayDeassert) {
      return connection_.Refuse(
          fmt::format("has the word {:#x} where ready ({}) is expected; data go out here, they do "
                      "not come in: is the port that of another service?",
                      word, kGatewayAssert));
    }
    if (word < kGatewayAssert) {
      gateway_->Warn(
          fmt::format("the peer says ready with {}, which means nothing; 3 is ready", word));
      continue;
    }
    peer_is_ready_ = word == kGatewayAssert;
  }
  SendHeld();
}

// Called when the connection to the other computer has ended.  Tells the local subject that the
// gateway is not ready, because without a connection the subject's data would be lost.
void OutgoingChannel::Down() {
  stream_ = {};
  peer_is_ready_ = false;
  if (!held_.empty()) gateway_->host().statistics().NoteDropped();
  held_.clear();
  observer_->DeassertReady();
}

void OutgoingChannel::HashState(Hasher* hasher) const {
  GatewayChannel::HashState(hasher);
  hasher->Add(peer_is_ready_);
  hasher->AddText(held_);
}

void IncomingChannel::Up() {
  waiting_word_ = 0;
  peer_may_send_ = false;
  if (subject_->IsReady() > 0) SendWord(kGatewayAssert);
}

void IncomingChannel::Ready(const OReadyEvent& event) {
  if (connection_.is_up()) SendWord(event.IsAssert() ? kGatewayAssert : kGatewayDeassert);
}

void IncomingChannel::SendWord(uint32_t word) {
  waiting_word_ = word;
  if (!connection_.is_sending()) Sent();
}

void IncomingChannel::Sent() {
  if (waiting_word_ == 0) return;
  const uint32_t word = std::exchange(waiting_word_, 0);
  peer_may_send_ = word == kGatewayAssert;
  connection_.Send(EncodeWord(word));
}

void IncomingChannel::Received(std::string_view bytes) {
  stream_.Feed(bytes);
  GatewaySet set;
  GatewayStream::Result result;
  while ((result = stream_.NextSet(&set)) == GatewayStream::Result::kTaken) {
    // The peer (the gateway on the other computer) must wait for a ready before it sends data.  If
    // the peer has not waited, adds only a warning and keeps the connection, because the data can
    // still be used: the data wait in the local subject until its observer is ready, or until newer
    // data replace them.
    if (!std::exchange(peer_may_send_, false)) {
      gateway_->Warn(
          "the peer sends data before it was told that the observer is ready; they wait, and newer "
          "ones replace them");
    }
    for (const std::string& item : set) subject_->SetData(item.data(), item.size());
    subject_->NotifyObservers();
  }
  if (result == GatewayStream::Result::kBroken) connection_.Refuse(stream_.error());
}

void IncomingChannel::HashState(Hasher* hasher) const {
  GatewayChannel::HashState(hasher);
  hasher->Add(waiting_word_);
  hasher->Add(peer_may_send_);
}

}  // namespace openr_host
