// Decides which WebSockets the panel's server opens.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "openr/panel/web_loop.h"

namespace openr_host {

// Returns a new random token: 128 bits as 32 hexadecimal digits.
std::string NewToken();

// Returns whether the texts are equal.  The time that this takes tells nothing about the place of
// the first difference, so nobody can find a token digit by digit.
bool IsSameSecret(std::string_view a, std::string_view b);

class Access {
 public:
  Access(std::string token, uint16_t port);

  // Returns the WebSocket subprotocol by which a page shows that it knows the token.
  std::string protocol() const { return "openr." + token_; }
  // Returns the address to open in a browser.
  std::string Url() const;

  // Returns the reason why the request is refused; "" if it is not.  A name of a host that is not
  // this one can lead here (DNS rebinding), so the header Host is checked, for files as well.
  std::string WhyNoFile(const WebRequest& request) const;
  // Returns the same for a WebSocket, which needs the token.  A browser says in Origin which site
  // has made the request; programs that are no browsers say nothing, and need the token only.
  std::string WhyNoSocket(const WebRequest& request) const;

 private:
  bool IsOurs(std::string_view host) const;

  const std::string token_;
  const uint16_t port_;
};

}  // namespace openr_host
