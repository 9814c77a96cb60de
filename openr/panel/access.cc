#include "openr/panel/access.h"

#include <fmt/format.h>
#include <sys/random.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace openr_host {

std::string NewToken() {
  std::array<unsigned char, 16> bytes;
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw std::runtime_error(fmt::format("no random numbers: {}", std::strerror(errno)));
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

bool IsSameSecret(std::string_view a, std::string_view b) {
  // Returns early, because the length of a token is no secret.
  if (a.size() != b.size()) return false;
  // Declares `difference` volatile, so that the compiler does not end the loop at the first
  // difference.
  volatile unsigned char difference = 0;
  for (size_t i = 0; i < a.size(); ++i)
    difference = static_cast<unsigned char>(difference | (a[i] ^ b[i]));
  return difference == 0;
}

Access::Access(std::string token, uint16_t port) : token_(std::move(token)), port_(port) {}

std::string Access::Url() const {
  return fmt::format("http://127.0.0.1:{}/?token={}", port_, token_);
}

bool Access::IsOurs(std::string_view host) const {
  return host == fmt::format("127.0.0.1:{}", port_) || host == fmt::format("localhost:{}", port_);
}

std::string Access::WhyNoFile(const WebRequest& request) const {
  if (IsOurs(request.host)) return "";
  return fmt::format("this is the panel of openr; open it as http://127.0.0.1:{}/", port_);
}

std::string Access::WhyNoSocket(const WebRequest& request) const {
  if (const std::string why = WhyNoFile(request); !why.empty()) return why;
  const std::string_view origin = request.origin;
  constexpr std::string_view kScheme = "http://";
  if (!origin.empty() && !(origin.starts_with(kScheme) && IsOurs(origin.substr(kScheme.size()))))
    return "a page of another site may not use the panel";
  if (IsSameSecret(request.protocol, protocol())) return "";
  return "the token is wrong or missing; open the address that openr has printed";
}

}  // namespace openr_host
