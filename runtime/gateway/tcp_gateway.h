// TCPGateway: the system object that connects subjects and observers of different computers over
// TCP.
//
// On a robot the gateway is the image TCPGW.BIN, which OBJECT.CFG names; here it is part of the
// runtime.  Its services come from ROBOTGW.CFG, each with a port to listen on, and from HOSTGW.CFG,
// each with an address to connect to.  The bytes on the wire are those that were measured on Sony's
// gateway (measured.md, "TCPGateway wire format").  The gateway also carries OPEN-R calls, that is,
// calls of OPENR:: functions by a program on a PC, if their form is known (proxy_wire.h).
#pragma once

#include <antStackRef.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "runtime/base/assert.h"
#include "runtime/config/gateway_config.h"
#include "runtime/core/code_object.h"
#include "runtime/core/load_stick.h"
#include "runtime/gateway/gateway_channel.h"

namespace openr_host {

class ProxyClient;
class System;

class TcpGateway : public CodeObject {
 public:
  static constexpr char kName[] = "tcpGateway";

  explicit TcpGateway(const GatewayConfig& config);
  ~TcpGateway() override;

  OStatus DoInit(const OSystemEvent& event) override;
  OStatus DoStart(const OSystemEvent& event) override;
  void HashState(Hasher* hasher) const override;

  // Returns the selector of the gateway's entry for OPEN-R calls, that is, for calls of OPENR::
  // functions by a program on a PC.  Each message to this entry is a ProxyRequest (proxy_client.h),
  // which the gateway sends to the robot over TCP.  REQUIRES: HOSTGW.CFG has the line !ROBOT_PROXY,
  // which names that robot.
  Selector call_entry() const {
    ASSERT(proxy_client_ != nullptr);
    return call_;
  }

  // ---- Functions for the channels (services) of this gateway

  const antStackRef& stack() const { return stack_; }
  // Sends `message` to the network stack, the object IPStack.  The caller has stored the number of
  // a channel (service of the gateway) in the field `continuation`.  IPStack copies this field into
  // its answer, so the answer goes to that channel.
  void PostToStack(antEnvMsg* message, int size);
  // Posts a message that is due after `delay_us` and calls GatewayConnection::Open() of the service
  // `channel`, so that the host's side tries again to connect.
  void OpenLater(int channel, int64_t delay_us);
  // Posts a message that is due after `delay_us`.  It then calls
  // GatewayConnection::WarnIfNoAnswer() for the connection of service number `channel`, which warns
  // the user if the peer does not answer.
  void CheckForAnswerLater(int channel, int64_t delay_us);
  // Posts a message that is due after `delay_us` and calls ProxyClient::Expire(), which makes a
  // call fail to which the robot gives no answer.
  void ExpireLater(int64_t delay_us);
  void Warn(const std::string& text);

 private:
  void AddChannel(const GatewayRecord& record);
  void AddProxies(const GatewayConfig& config);
  void PostLater(Selector entry, int channel, int64_t delay_us);

  antStackRef stack_;
  Selector answer_ = 0;
  Selector open_ = 0;
  Selector look_ = 0;
  Selector call_ = 0;
  Selector expire_ = 0;
  ProxyClient* proxy_client_ = nullptr;
  std::vector<std::unique_ptr<GatewayChannel>> channels_;
};

// Returns the gateway of `robot` for LoadStick().  The gateway is added to the System if OBJECT.CFG
// names TCPGW.BIN, CONNECT.CFG names a service of TCPGateway, or HOSTGW.CFG names a robot to which
// calls of OPENR:: functions are sent.  REQUIRES: the robot has its stick.
SystemImage GatewayImage(System* system, int robot);

}  // namespace openr_host
