// ROBOTGW.CFG and HOSTGW.CFG: the services that TCPGateway carries over the network.
//
// Each service has a port and carries exactly one connection; the robot's side listens, the host's
// side connects.  The two sides pair by port: a robot-side observer (.O) sends what robot subjects
// notify to a host-side subject (.S), and the other way round.  (core.md, 5.4)
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/config/connect_config.h"
#include "runtime/config/diagnostic.h"
#include "runtime/config/service_name.h"

namespace openr_host {

inline constexpr char kGatewayImage[] = "TCPGW.BIN";  // as OBJECT.CFG of a robot names it
inline constexpr char kGatewayPrefix[] = "TCPGateway.";
inline constexpr char kProxyService[] = "TCPGateway.Proxy.AperiosMessage.P";
inline constexpr char kProxyRecord[] = "!ROBOT_PROXY";
inline constexpr char kRobotGatewayFile[] = "ROBOTGW.CFG";
inline constexpr char kHostGatewayFile[] = "HOSTGW.CFG";

enum class GatewaySide { kRobot, kHost };

struct GatewayRecord {
  ServiceName service;
  uint16_t port = 0;
  std::string host;       // address of the robot to connect to; "": this side listens
  std::string section;    // robot design the line is limited to; "" for every robot
  bool is_proxy = false;  // no service, but the OPEN-R calls of remote programs
  FilePosition place;

  std::string Name() const;  // of its service, as in the file
};

struct GatewayConfig {
  std::vector<GatewayRecord> services;  // in file order
  // TCPGateway.Proxy.AperiosMessage.P (robot) or !ROBOT_PROXY (host).
  std::optional<GatewayRecord> proxy;
  std::vector<Diagnostic> diagnostics;
};

// Parses "SERVICE PORT" (robot) or "SERVICE PORT HOST" (host) per line.  A bad line, a port or
// service named twice is reported and skipped.
GatewayConfig ParseGatewayConfig(const std::string& file, std::string_view text,
                                 std::string_view design, GatewaySide side);

// What does not fit between the wires and the services of the gateway: a wire to a service it does
// not have, a second wire of one service.  `file` is the gateway's, for messages.
std::vector<Diagnostic> CheckGatewayWires(const ConnectConfig& wires, const GatewayConfig& gateway,
                                          const std::string& file);

}  // namespace openr_host
