#include "openr/panel/endpoints.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <algorithm>
#include <cctype>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "openr/live/live_client.h"

namespace openr_host {
namespace {

constexpr int kPortTimeoutMs = 3000;
constexpr size_t kEndpointMax = 260;  // largest length of a host name with a port

// Returns whether `host` is a loopback address of this computer, 127.x.y.z.
bool IsLoopback(const std::string& host) {
  addrinfo hints{};
  hints.ai_family = AF_INET;
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (getaddrinfo(host.c_str(), nullptr, &hints, &found) != 0) return false;
  const auto* const address = reinterpret_cast<const sockaddr_in*>(found->ai_addr);
  const uint32_t number = ntohl(address->sin_addr.s_addr);
  freeaddrinfo(found);
  // Counts 0.0.0.0 as a loopback address, too, because a connection to it leads to this computer.
  return number >> 24 == 127 || number == INADDR_ANY;
}

}  // namespace

remote::Address ParseEndpoint(const std::string& text) {
  const bool is_plain = std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '.' || c == '-' || c == ':' || c == '_';
  });
  if (text.size() > kEndpointMax || !is_plain)
    throw std::runtime_error("the address of a robot is HOST:PORT, such as 127.0.0.1:54001");
  return remote::ParseAddress(text);
}

std::vector<int> RemotePorts(const LiveRun& run) {
  const auto status = LiveClient(run, kPortTimeoutMs).Ask({{"do", "status"}});
  const auto ports = status.find("rc_ports");
  return ports == status.end() ? std::vector<int>() : ports->get<std::vector<int>>();
}

remote::Address AddressInRun(const LiveRun& run, size_t robot) {
  const std::vector<int> ports = RemotePorts(run);
  if (robot >= ports.size())
    throw std::runtime_error(fmt::format("the run has no remote control of robot {}", robot));
  if (ports[robot] == 0) {
    throw std::runtime_error(
        "the robot does not listen yet, or has no object RCServer; try again soon");
  }
  return {"127.0.0.1", static_cast<uint16_t>(ports[robot])};
}

void RefuseOwnRobots(const LiveRun& run, const remote::Address& address) {
  const std::vector<int> ports = RemotePorts(run);
  if (std::find(ports.begin(), ports.end(), address.port) == ports.end()) return;
  if (!IsLoopback(address.host)) return;
  throw std::runtime_error(fmt::format(
      "{} is the remote control of this run itself; give the address of another run, or "
      "of a robot",
      address.Text()));
}

}  // namespace openr_host
