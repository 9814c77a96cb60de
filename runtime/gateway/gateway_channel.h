// A channel is one service of the gateway: it carries the notifications of a subject on one
// computer to an observer on another computer.  The peer is the gateway of the other computer.
//
// The observer sends a ready when it can accept data, and this ready goes to the subject's
// computer, as measured on Sony's gateway.  On the subject's side, the gateway asserts ready to the
// subject when the connection is made.  When the subject has sent a notification, the gateway keeps
// its data (a set) until the peer is ready.  Then the gateway sends the set to the peer and asserts
// ready to the subject again.  On the observer's side, the gateway sends the observer's readies to
// the peer.
#pragma once

#include <OPENR/OObserver.h>
#include <OPENR/OSubject.h>

#include <string>
#include <string_view>

#include "runtime/gateway/gateway_connection.h"
#include "runtime/gateway/gateway_stream.h"

namespace openr_host {

class GatewayChannel : public GatewayConnection::Owner {
 public:
  GatewayChannel(TcpGateway* gateway, int index, const GatewayRecord& record)
      : connection_(gateway, index, record, this) {}

  GatewayConnection& connection() { return connection_; }
  virtual void HashState(Hasher* hasher) const;

 protected:
  GatewayConnection connection_;
  GatewayStream stream_;  // received bytes that are not decoded yet
};

// A service of the gateway that observes a subject of this computer, and sends the subject's data
// to the gateway of another computer (the peer).
class OutgoingChannel : public GatewayChannel {
 public:
  OutgoingChannel(TcpGateway* gateway, int index, const GatewayRecord& record)
      : GatewayChannel(gateway, index, record), gateway_(gateway) {}

  void set_observer(OObserver* observer) { observer_ = observer; }
  void Notify(const ONotifyEvent& event);

  void Up() override;
  void Received(std::string_view bytes) override;
  void Sent() override { SendHeld(); }
  void Down() override;
  void HashState(Hasher* hasher) const override;

 private:
  void SendHeld();

  TcpGateway* const gateway_;
  OObserver* observer_ = nullptr;
  bool peer_is_ready_ = false;
  std::string held_;  // the encoded set that waits for the peer's ready; "" if no set waits
};

// A service of the gateway that receives data of the peer, the gateway of another computer, and, as
// a subject, sends the data to an observer of this computer.
class IncomingChannel : public GatewayChannel {
 public:
  IncomingChannel(TcpGateway* gateway, int index, const GatewayRecord& record)
      : GatewayChannel(gateway, index, record), gateway_(gateway) {}

  void set_subject(OSubject* subject) { subject_ = subject; }
  void Ready(const OReadyEvent& event);

  void Up() override;
  void Received(std::string_view bytes) override;
  void Sent() override;
  void Down() override { stream_ = {}; }
  void HashState(Hasher* hasher) const override;

 private:
  // Sends `word`, kGatewayAssert (ready) or kGatewayDeassert (not ready), to the peer, the gateway
  // of the other computer.  If an earlier word is still being sent, sends `word` after it.
  void SendWord(uint32_t word);

  TcpGateway* const gateway_;
  OSubject* subject_ = nullptr;
  // The word (ready or not ready) to send to the peer, the gateway of the other computer, when the
  // earlier word has been sent; 0 if no word waits.  There is no queue, because only the newest
  // state of the observer matters.
  uint32_t waiting_word_ = 0;
  // True if "ready" was sent to the peer (the gateway of the other computer), and the peer has not
  // sent data since then.  If false, the peer must not send data, so data from the peer cause a
  // warning.
  bool peer_may_send_ = false;
};

}  // namespace openr_host
