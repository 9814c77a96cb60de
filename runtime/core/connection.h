// Connection: a line of CONNECT.CFG, from which the object manager connects two services.
#pragma once

#include <string>

namespace openr_host {

// A connection between a subject and an observer.  A line of CONNECT.CFG describes the connection,
// or code, such as a test, makes it with System::Connect().
struct Connection {
  int robot = 0;
  std::string subject;  // full name of the subject's service: "RCServer.Move.MoveCommand.S"
  std::string observer;
  std::string where;  // the place of the connection's line, for messages to users: "CONNECT.CFG:4"
};

}  // namespace openr_host
