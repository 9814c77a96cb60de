// The address of a robot's remote control.
#pragma once

#include <cstdint>
#include <string>

#include "RemotePacket.h"

namespace openr::remote {

// A host name or an IPv4 address, and a TCP port.
struct Address {
  std::string host;
  uint16_t port = RC_PORT;

  // Returns the address as text: "HOST:PORT".
  std::string Text() const { return host + ":" + std::to_string(port); }
};

// Reads an address from "HOST" or "HOST:PORT"; without a port, the port is 54000. Throws Error
// (kAddress) for any other text.  Refuses IPv6 addresses, because the robot's network is IPv4.
Address ParseAddress(const std::string& text);

}  // namespace openr::remote
