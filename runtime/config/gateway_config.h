// Parses ROBOTGW.CFG and HOSTGW.CFG, which list the services that TCPGateway connects over the
// network.
//
// Each service has a port and carries exactly one connection; the robot's side listens, the host's
// side connects.  An observer (.O) on one side and a subject (.S) on the other side belong together
// if they have the same port.  Data that arrive at the observer go over the network to the other
// side, where the subject sends them to its own observer.  (core.md, 5.4)
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

inline constexpr char kGatewayImage[] = "TCPGW.BIN";  // the gateway's file, as in OBJECT.CFG
inline constexpr char kGatewayPrefix[] = "TCPGateway.";
inline constexpr char kProxyService[] = "TCPGateway.Proxy.AperiosMessage.P";
inline constexpr char kProxyRecord[] = "!ROBOT_PROXY";
inline constexpr char kRobotGatewayFile[] = "ROBOTGW.CFG";
inline constexpr char kHostGatewayFile[] = "HOSTGW.CFG";

enum class GatewaySide { kRobot, kHost };

struct GatewayRecord {
  ServiceName service;
  uint16_t port = 0;
  std::string host;     // address of the robot to connect to; "" if this side listens
  std::string section;  // the robot design for which the line is valid; "" for every robot
  // True for the configuration line for OPEN-R calls (calls of remote programs), false for a line
  // with a service.
  bool is_proxy = false;
  FilePosition place;

  std::string Name() const;  // returns the first word of the line
};

struct GatewayConfig {
  std::vector<GatewayRecord> services;  // in the order of the lines of ROBOTGW.CFG or HOSTGW.CFG
  // The configuration line for OPEN-R calls (calls by which programs on a PC use functions of the
  // robot); nullopt if the file has no such line.  The line begins with
  // TCPGateway.Proxy.AperiosMessage.P in the robot's file (ROBOTGW.CFG), and with !ROBOT_PROXY in
  // the PC's file (HOSTGW.CFG).
  std::optional<GatewayRecord> proxy;
  std::vector<Diagnostic> diagnostics;
};

// Parses ROBOTGW.CFG (`side` is kRobot), with one "SERVICE PORT" per line, or HOSTGW.CFG (kHost),
// with one "SERVICE PORT HOST" per line.  A bad line is reported and skipped.  A line with the port
// or service of an earlier line is bad, too.
GatewayConfig ParseGatewayConfig(const std::string& file, std::string_view text,
                                 std::string_view design, GatewaySide side);

// Reports wires (lines of CONNECT.CFG) that do not fit the gateway: a wire to a service that the
// gateway does not have, or a second wire to the same service.  `file` is the name of the gateway's
// configuration file in the messages.
std::vector<Diagnostic> CheckGatewayWires(const ConnectConfig& wires, const GatewayConfig& gateway,
                                          const std::string& file);

}  // namespace openr_host
