// Connection: a line of CONNECT.CFG, from which the object manager connects two services.
#pragma once

#include <string>

namespace openr_host {

// A connection between a subject and an observer that a line of CONNECT.CFG, or code, has made.
struct Connection {
  int robot = 0;
  std::string subject;  // full name of the subject's service: "RCServer.Move.MoveCommand.S"
  std::string observer;
  std::string where;  // the place of the connection's line, for messages to users: "CONNECT.CFG:4"
};

}  // namespace openr_host
