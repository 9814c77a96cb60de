// Answers OPEN-R calls: calls of OPENR:: functions that a program on a PC sends to this robot.
// ROBOTGW.CFG names the service for such calls: TCPGateway.Proxy.AperiosMessage.P.
//
// The program asks for a system object by name and then calls this object; system_messages.h makes
// the answers.  Objects of the stick cannot be called, because their messages contain addresses of
// memory, which mean nothing on another computer.
#pragma once

#include "runtime/gateway/gateway_channel.h"
#include "runtime/gateway/proxy_wire.h"

namespace openr_host {

class ProxyServer : public GatewayChannel {
 public:
  ProxyServer(TcpGateway* gateway, int index, const GatewayRecord& record)
      : GatewayChannel(gateway, index, record), gateway_(gateway) {}

  void Up() override {}
  void Received(std::string_view bytes) override;
  void Sent() override {}
  void Down() override { stream_ = {}; }

 private:
  // Returns the answer to `frame`, a call that a program on a PC has sent.  If `frame` is an answer
  // and not a call, the command of the returned frame is kUndefined.
  ProxyFrame AnswerTo(const ProxyFrame& frame);
  ProxyFrame AnswerCall(const ProxyFrame& frame);

  TcpGateway* const gateway_;
};

}  // namespace openr_host
