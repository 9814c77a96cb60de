#include "openr/panel/access.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <sys/random.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "openr/panel/listen.h"

namespace openr_host {
namespace {

constexpr char kLoopback[] = "127.0.0.1";

}  // namespace

std::string NewToken() {
  std::array<unsigned char, 16> bytes;
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw std::runtime_error(fmt::format("no random numbers: {}", std::strerror(errno)));
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

bool IsSameSecret(std::string_view a, std::string_view b) {
  // Returns false at once for texts of different lengths, because everybody may know the length of
  // the token, the secret that clients must send.
  if (a.size() != b.size()) return false;
  // Declares `difference` volatile, so that the compiler does not end the loop at the first
  // difference.
  volatile unsigned char difference = 0;
  for (size_t i = 0; i < a.size(); ++i)
    difference = static_cast<unsigned char>(difference | (a[i] ^ b[i]));
  return difference == 0;
}

Access::Access(std::string token, std::string address, uint16_t port)
    : token_(std::move(token)), address_(std::move(address)), port_(fmt::format(":{}", port)) {}

std::string Access::Url(const std::string& token) const {
  return fmt::format("http://{}{}/?token={}", address_ == kAnyAddress ? "ADDRESS" : address_, port_,
                     token);
}

bool Access::IsPanelAddress(std::string_view host) const {
  if (host.ends_with(port_)) {
    host.remove_suffix(port_.size());
  } else if (port_ != ":80") {  // only port 80 may be missing, because browsers leave it out
    return false;
  }
  const std::string name(host);
  // Accepts "localhost" and no other name, because the name of another site can be made to lead to
  // this computer.
  if (name == "localhost") return address_ == kLoopback || address_ == kAnyAddress;
  in_addr number{};
  return address_ == kAnyAddress ? inet_pton(AF_INET, name.c_str(), &number) == 1
                                 : name == address_;
}

std::string Access::SocketSource(const std::string& host) const {
  return IsPanelAddress(host) ? "ws://" + host : "";
}

std::string Access::FileRefusal(const WebRequest& request) const {
  if (IsPanelAddress(request.host)) return "";
  return address_ == kAnyAddress
             ? fmt::format(
                   "this is the panel of openr; open it by an address of this computer, as "
                   "http://192.168.0.5{}/, names are refused",
                   port_)
             : fmt::format("this is the panel of openr; open it as http://{}{}/", address_, port_);
}

std::string Access::SocketRefusal(const WebRequest& request) const {
  if (const std::string why = FileRefusal(request); !why.empty()) return why;
  const std::string_view origin = request.origin;
  // Refuses a page that does not come from this server.  The header Origin names the server of the
  // page, and the header Host names this server.
  if (!origin.empty() && origin != "http://" + request.host)
    return "a page of another site may not use the panel";
  if (IsSameSecret(request.protocol, protocol())) return "";
  return "the token is wrong or missing; open the address that openr has printed";
}

}  // namespace openr_host
