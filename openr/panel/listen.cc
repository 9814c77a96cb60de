#include "openr/panel/listen.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>

#include "cli/install_paths.h"
#include "openr/panel/access.h"
#include "openr/remote/token_file.h"

namespace openr_host {
namespace {

// The largest number of ports that are tried, beginning with the port that the user wants.
constexpr int kPortsMax = 100;

}  // namespace

std::string ListenAddressProblem(const std::string& address) {
  in_addr number{};
  if (inet_pton(AF_INET, address.c_str(), &number) == 1) return "";
  return fmt::format(
      "'{}' is no IPv4 address; write one of this computer, such as 192.168.0.5, or {} for all of "
      "them",
      address, kAnyAddress);
}

void CheckListen(const ListenOptions& options) {
  if (!std::filesystem::path(PanelLibrary()).is_absolute()) {
    throw std::runtime_error(
        "this openr was built without libwebsockets (Debian package libwebsockets-dev), which "
        "serves other computers");
  }
  ReadOrMakeToken(options.token_file);
  // Listens at any free port of options.address for a moment, only to find out whether this
  // computer has this address.
  uint16_t port = 0;
  close(Listen(options.address, &port));
}

std::string ReadOrMakeToken(const std::string& file) {
  const std::string line = NewToken() + "\n";
  const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (descriptor >= 0) {
    const ssize_t written = write(descriptor, line.data(), line.size());
    const int error = written < 0 ? errno : ENOSPC;
    close(descriptor);
    if (written != static_cast<ssize_t>(line.size())) {
      unlink(file.c_str());
      throw std::runtime_error(
          fmt::format("{}: the token cannot be written: {}", file, std::strerror(error)));
    }
  } else if (errno != EEXIST) {
    throw std::runtime_error(
        fmt::format("{}: the token cannot be written: {}", file, std::strerror(errno)));
  }
  return openr::remote::ReadTokenFile(file);
}

int Listen(const std::string& address, uint16_t* port) {
  const int first = *port;
  for (int number = first; number < first + kPortsMax && number <= 65535; ++number) {
    const int listener = socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
    if (listener < 0) throw std::runtime_error(fmt::format("no socket: {}", std::strerror(errno)));
    // Allows a port that old connections still occupy (state TIME_WAIT), so that a new panel gets
    // the same port as the panel before.
    const int on = 1;
    setsockopt(listener, SOL_SOCKET, SO_REUSEADDR, &on, sizeof on);
    sockaddr_in place{};
    place.sin_family = AF_INET;
    place.sin_port = htons(static_cast<uint16_t>(number));
    socklen_t size = sizeof place;
    auto* const any = reinterpret_cast<sockaddr*>(&place);
    // Sets errno, because inet_pton() does not set it when the text is no address.
    errno = EINVAL;
    if (inet_pton(AF_INET, address.c_str(), &place.sin_addr) == 1 &&
        bind(listener, any, size) == 0 && listen(listener, 64) == 0 &&
        getsockname(listener, any, &size) == 0) {
      *port = ntohs(place.sin_port);
      return listener;
    }
    const int error = errno;
    close(listener);
    if (error == EADDRNOTAVAIL) {
      throw std::runtime_error(
          fmt::format("nothing can listen at {}: this computer has no such address (ip address "
                      "lists those that it has)",
                      address));
    }
    if (error != EADDRINUSE)
      throw std::runtime_error(
          fmt::format("port {} of {}: {}", number, address, std::strerror(error)));
  }
  throw std::runtime_error(
      fmt::format("the {} ports of {} from {} on are taken; give another one "
                  "(--panel-port, --listen-rc-port; openr panel: --port)",
                  kPortsMax, address, first));
}

}  // namespace openr_host
