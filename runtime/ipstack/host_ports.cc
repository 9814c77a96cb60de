#include "runtime/ipstack/host_ports.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

namespace openr_host {

int HostPorts::Bind(uint16_t port, const std::function<int(uint16_t)>& try_bind,
                    const std::function<uint16_t()>& bound, std::string* note) {
  const auto before = chosen_.find(port);
  const auto wish = wished_.find(port);
  const uint16_t first = before != chosen_.end() ? before->second
                         : wish != wished_.end() ? wish->second
                                                 : port;
  const char* const protocol = protocol_ == NetProtocol::kTcp ? "TCP" : "UDP";
  const int first_error = try_bind(first);
  int error = first_error;
  if (error != 0 && wish != wished_.end() && wish->second != 0) {
    *note = fmt::format(
        "{} port {} of the robot is nowhere: port {} of this computer, which was asked for, cannot "
        "be had ({})",
        protocol, port, first, std::strerror(error));
    return error;
  }
  // If the wanted port of the host is in use, tries the port numbers above `port`, so that the user
  // finds the port near the number that the program uses.  Takes any free port only if all these
  // numbers are in use.
  for (int next = port + 1; error == EADDRINUSE && next <= port + kNextPorts && next <= 65535;
       ++next)
    error = try_bind(static_cast<uint16_t>(next));
  if (error != 0 && first != 0) error = try_bind(0);
  if (error != 0) return error;
  chosen_[port] = bound();
  if (first_error != 0) {
    *note = fmt::format(
        "{} port {} of the robot is port {} of this computer: port {} cannot be had ({}{})",
        protocol, port, chosen_[port], first, std::strerror(first_error),
        first_error == EADDRINUSE ? "; another openr-host running?" : "");
  }
  return 0;
}

uint16_t HostPorts::HostPort(uint16_t port) const {
  const auto found = chosen_.find(port);
  return found == chosen_.end() ? 0 : found->second;
}

uint16_t HostPorts::RobotPort(uint16_t host_port) const {
  for (const auto& [port, chosen] : chosen_) {
    if (chosen == host_port) return port;
  }
  return 0;
}

}  // namespace openr_host
