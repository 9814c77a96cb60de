// One service of the gateway: what is notified on one side is notified on the other.
//
// Ready goes against the data, as measured: with the connection up, the gateway asserts ready to
// the local subject, holds one set of data until the peer is ready, then asserts again; what the
// local observer asserts goes to the peer.
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
  GatewayStream stream_;  // what came in
};

// An observer here: data of a local subject go out.
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
  std::string held_;  // one set, as it goes out; "": none
};

// A subject here: data of the peer go to a local observer.
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
  void Tell(uint32_t word);

  TcpGateway* const gateway_;
  OSubject* subject_ = nullptr;
  uint32_t waiting_word_ = 0;  // to be sent; 0: none.  Ready is a flag: the last one counts
  bool asked_ = false;         // the peer was told that we are ready, and has not sent since
};

}  // namespace openr_host
