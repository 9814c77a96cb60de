#include "openr/simulation/network_setup.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <utility>

#include "RemotePacket.h"
#include "runtime/ipstack/host_network.h"
#include "runtime/ipstack/host_socket.h"
#include "runtime/ipstack/ip_stack.h"
#include "runtime/ipstack/loopback_network.h"

namespace openr_host {
namespace {

// Time between two checks whether clients have connected to a robot.  Clients do not notice such a
// short time, and with this pause a run at full speed saves a system call in nearly every frame.
constexpr int64_t kAcceptIntervalNs = 100'000;

}  // namespace

std::unique_ptr<Network> MakeHostNetwork(int rc_port, std::vector<AddressPair> addresses) {
  HostNetworkOptions options;
  options.addresses = std::move(addresses);
  options.accept_interval_ns = kAcceptIntervalNs;
  if (rc_port >= 0) options.tcp_ports[RC_PORT] = static_cast<uint16_t>(rc_port);
  return std::make_unique<HostNetwork>(std::move(options));
}

std::string PortProblem(int rc_port) {
  if (rc_port <= 0) return "";
  const Fd probe = OpenSocket(NetProtocol::kTcp);
  const NetAddress local{HostNetworkOptions().bind_ip, static_cast<uint16_t>(rc_port)};
  const int error = probe.valid() ? ListenOn(probe, local, 1) : errno;
  if (error == 0) return "";
  return fmt::format(
      "port {} of this computer cannot be had: {}{}", rc_port, std::strerror(error),
      error == EADDRINUSE ? "; without --rc-port the next free one after 54000 is taken" : "");
}

std::unique_ptr<Network> MakeIsolatedNetwork() { return std::make_unique<LoopbackNetwork>(); }

uint16_t HostPortOfRemoteControl(const IpStack& network) {
  return network.HostPort(NetProtocol::kTcp, RC_PORT);
}

}  // namespace openr_host
