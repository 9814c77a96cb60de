// Access: decides which requests and WebSockets the server of the panel refuses.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "openr/panel/web_loop.h"

namespace openr_host {

// Returns a new random token, the secret that clients of the panel must send: 128 bits as 32
// hexadecimal digits.
std::string NewToken();

// Returns whether the secrets `a` and `b` (tokens that clients must send) are equal.  The time of
// the comparison does not depend on the place of the first difference, so nobody can find a secret
// digit by digit.
bool IsSameSecret(std::string_view a, std::string_view b);

class Access {
 public:
  // Makes the rules by which a server refuses requests.  The server listens at `port` of the IPv4
  // address `address`, which may be kAnyAddress (listen.h).
  Access(std::string token, std::string address, uint16_t port);

  // Returns the WebSocket subprotocol by which a page shows that it knows the token, a secret.
  std::string protocol() const { return "openr." + token_; }
  // Returns the address of the panel to open in a browser, with `token`, a secret, in it.
  std::string Url(const std::string& token) const;
  const std::string& token() const { return token_; }

  // Returns the address of WebSockets, "ws://HOST", that the content security policy of a page
  // allows; "" if `host`, the header Host of the request, is not an address of the panel.
  std::string SocketSource(const std::string& host) const;

  // Returns the reason why a request for a file is refused; "" if it is allowed.  Checks the header
  // Host, because a foreign host name can be made to lead to this computer (DNS rebinding).
  std::string FileRefusal(const WebRequest& request) const;
  // Returns the reason why a request for a WebSocket is refused; "" if it is allowed.  The request
  // must have the token, a secret.  Checks the header Origin, in which a browser names the site
  // that makes the request; other programs send no such header.
  std::string SocketRefusal(const WebRequest& request) const;

 private:
  bool IsPanelAddress(std::string_view host) const;

  const std::string token_;
  const std::string address_;
  const std::string port_;  // port with a colon in front, such as ":8210"
};

}  // namespace openr_host
