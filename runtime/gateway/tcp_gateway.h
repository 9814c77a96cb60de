// TCPGateway: the system object that carries subjects and observers over TCP.
//
// On a robot it is the image TCPGW.BIN, which OBJECT.CFG names; here it is part of the runtime.
// Its services are those of ROBOTGW.CFG, each with a port to listen on, and of HOSTGW.CFG, each
// with an address to connect to.  The wire is that of the original, as measured.  Not there: the
// OPEN-R calls of remote programs, whose protocol is not known.
#pragma once

#include <antStackRef.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "runtime/config/gateway_config.h"
#include "runtime/core/code_object.h"
#include "runtime/core/system.h"
#include "runtime/gateway/gateway_channel.h"

namespace openr_host {

class TcpGateway : public CodeObject {
 public:
  static constexpr char kName[] = "tcpGateway";

  explicit TcpGateway(const std::vector<GatewayRecord>& services);
  ~TcpGateway() override;

  OStatus DoStart(const OSystemEvent& event) override;
  void HashState(Hasher* hasher) const override;

  // ---- for channels

  const antStackRef& stack() const { return stack_; }
  // The answer comes to the channel whose number is the message's continuation.
  void PostToStack(antEnvMsg* message, int size);
  void OpenLater(int channel, int64_t delay_us);
  void Warn(const std::string& text);

 private:
  void AddChannel(const GatewayRecord& record);

  antStackRef stack_;
  Selector answer_ = 0;
  Selector open_ = 0;
  std::vector<std::unique_ptr<GatewayChannel>> channels_;
};

// System::LoadStick(), with the gateway where the stick asks for one: OBJECT.CFG names TCPGW.BIN,
// or CONNECT.CFG a service of TCPGateway.
bool LoadStickAndGateway(System* system, int robot, System::StandIns stand_ins = {});

}  // namespace openr_host
