// The address at which the server of the panel listens, and what other computers may do there.
#pragma once

#include <cstdint>
#include <string>

namespace openr_host {

// The flags of --listen.
struct ListenOptions {
  // IPv4 address of this computer, or 0.0.0.0 for all of them; "": the panel listens at 127.0.0.1,
  // and the remote control is not forwarded.
  std::string address;
  std::string token_file;    // file with the token that clients need
  uint16_t rc_port = 54000;  // first port that is tried for the remote control of the first robot
  bool allows_controllers = false;  // whether clients may upload controllers, which are code

  bool is_on() const { return !address.empty(); }
};

// Returns the reason why nothing can listen at `address`; "" if it is an IPv4 address.
std::string WhyNoListenAddress(const std::string& address);

// Returns the token in the file `file`, as remote::ReadTokenFile() does.  If there is no such file,
// makes one that only this user may read, with a new token.
std::string ReadOrMakeToken(const std::string& file);

// Returns a socket that listens at the IPv4 address `address`, on the first free port from `*port`
// on.  Sets `*port` to this port.  Throws std::runtime_error if it cannot listen there.
int Listen(const std::string& address, uint16_t* port);

}  // namespace openr_host
