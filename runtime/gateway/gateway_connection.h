// The network end of one service of the gateway: one connection at a time.
//
// The robot's side listens on the service's port, the host's side connects and tries again every
// second.  It speaks to IPStack like any object (TCPEndpointMsg.h), so what comes from outside
// enters where it does for all.  A second client is told so by the end of its connection.
#pragma once

#include <TCPEndpointMsg.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "runtime/config/gateway_config.h"

namespace openr_host {

class Hasher;
class TcpGateway;

class GatewayConnection {
 public:
  class Owner {
   public:
    virtual ~Owner() = default;
    virtual void Up() = 0;
    virtual void Received(std::string_view bytes) = 0;
    virtual void Sent() = 0;  // everything that was given to Send()
    virtual void Down() = 0;
  };

  static constexpr int64_t kRetryUs = 1'000'000;
  // After so long without an answer from an address of another time, a warning names that of today.
  static constexpr int64_t kHintUs = 5'000'000;

  // Number `index` of the gateway.  `owner` hears in handlers of the gateway.
  GatewayConnection(TcpGateway* gateway, int index, const GatewayRecord& record, Owner* owner);

  bool is_up() const { return is_up_; }
  bool is_sending() const { return is_sending_; }

  // Listens, or connects.  REQUIRES: a handler of the gateway, like all below.
  void Open();
  void Send(std::string_view bytes);  // REQUIRES: is_up()
  // Ends the connection because of what the peer did, with a finding.
  void Refuse(const std::string& why);

  void TakeAnswer(const antEnvMsg& answer);
  // kHintUs after the first try.
  void LookForAnswer();

  void HashState(Hasher* hasher) const;

 private:
  bool NewBuffer();
  antModuleRef NewEndpoint();
  void Listen();
  void TakeListen(const TCPEndpointListenMsg& answer);
  void Connect();
  void TakeConnect(const TCPEndpointConnectMsg& answer);
  void TakeConnection(const antModuleRef& endpoint);
  void Receive();
  void SendNext();
  void Close(antModuleRef endpoint);
  void Lose();
  template <typename M>
  void Post(M message);
  void Warn(const std::string& text);

  TcpGateway* const gateway_;
  const int index_;
  const GatewayRecord record_;
  Owner* const owner_;
  byte* receive_bytes_ = nullptr;  // a shared buffer; what is sent follows what is received
  antModuleRef listener_;          // waits for the next client
  antModuleRef endpoint_;          // of the connection, or of the one that is being made
  bool is_up_ = false;
  bool had_answer_ = false;  // of a connect, good or bad
  bool is_sending_ = false;
  std::string out_;  // not yet given to the stack
};

}  // namespace openr_host
