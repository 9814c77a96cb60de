// RcForwarder, through which other computers use the remote control of a robot (--listen).
#pragma once

#include <memory>
#include <string>

#include "openr/panel/rc_calls.h"

namespace openr_host {

// Forwards the packets of clients to the robot, and its answers to the clients.  The first packet
// of a client must be the command TOKEN with a secret, the token (docs/remote-control.md).  The
// robot gets no byte of a client that does not know the token.
class RcForwarder {
 public:
  // The largest number of clients of remote controls that this process serves at a time.  Clients
  // that have not shown the token, a secret, yet are not among them and have a limit of their own.
  // A robot itself serves eight clients.
  static constexpr int kClientsMax = 16;
  static constexpr int kWithoutTokenMax = 16;
  // Time limit for a new client to show the token, a secret.
  static constexpr int kTokenTimeoutMs = 10'000;
  // Time limit for sending a packet to a client or to the robot.
  static constexpr int kSendTimeoutMs = 30'000;

  // Makes a forwarder for the robot whose address `find_address` returns.  `find_address` is called
  // in threads of this class.
  RcForwarder(RcCalls::FindAddress find_address, std::string token, bool allows_controllers);

  // Serves the client at the other end of `connection`, a socket, in a thread of its own.  Owns the
  // socket from now on.
  void ServeClient(int connection);

  // Returns whether a thread of any RcForwarder of this process still runs.
  static bool HasThreads();

  // Data that the threads of an RcForwarder read: how to find the robot, the token (the secret that
  // clients must send), and whether clients may upload controllers.
  struct Rules;

 private:
  const std::shared_ptr<const Rules> rules_;
};

}  // namespace openr_host
