// The address at which the server of the panel listens, and what other computers may do at this
// address.
#pragma once

#include <cstdint>
#include <string>

namespace openr_host {

// The value of --listen for all addresses of this computer.
inline constexpr char kAnyAddress[] = "0.0.0.0";

// Values of the flag --listen, and of the flags that can be given only with it.
struct ListenOptions {
  // IPv4 address of this computer, or kAnyAddress; "": the panel listens at 127.0.0.1, and the
  // remote control is not forwarded.
  std::string address;
  std::string token_file;  // file with the token, the secret that clients must send
  // First port that is tried for the remote control of the first robot.  It is not the robot's own
  // port, which the run opens on 127.0.0.1 at the same time.
  uint16_t rc_port = 54100;
  bool allows_controllers = false;  // whether clients may upload controllers, which are code

  bool is_on() const { return !address.empty(); }
};

// Returns the reason why nothing can listen at `address`; "" if it is an IPv4 address.
std::string ListenAddressProblem(const std::string& address);

// Throws std::runtime_error if the panel's server cannot do what `options` say: the token file has
// no token (the secret that clients must send), this computer does not have the address, or this
// openr was built without the server.  A run calls this function before it begins.  The server is
// another process, so the run would not see later that the server has failed.
void CheckListen(const ListenOptions& options);

// Returns the token, the secret that clients must send, from the file `file`, as
// remote::ReadTokenFile() does.  If there is no such file, first makes a file with a new token that
// only this user may read.
std::string ReadOrMakeToken(const std::string& file);

// Returns a socket that listens at the IPv4 address `address`, on the first free port from `*port`
// on.  Sets `*port` to this port.  Throws std::runtime_error if no socket can listen at the
// address.
int Listen(const std::string& address, uint16_t* port);

}  // namespace openr_host
