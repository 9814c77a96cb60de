// Constants for addresses and protocols, and the internal errors of the robot's IPv4 stack.
#ifndef OPENR_IPV4TYPES_H_INCLUDED
#define OPENR_IPV4TYPES_H_INCLUDED

#include <IPAddress.h>
#include <antTypes.h>

typedef uint16 Protocol;

extern const IPAddress IP_ADDR_ANY;        // 0.0.0.0
extern const IPAddress IP_ADDR_BROADCAST;  // 255.255.255.255
const Port IP_PORT_ANY = 0;

// Internal errors of the robot's IPv4 stack; programs never get them.
enum IPv4Error {
  IPV4_SUCCESS = 0,
  IPV4_FAIL = 1,
  IPV4_NOMEMORY = 2,
  IPV4_ADDRESSINUSE = 3,
  IPV4_ADDRESSERROR = 4,
  IPV4_INVALID_REQUEST = 5,
  IPV4_CONNECTION_CLOSED = 6,
  IPV4_CONNECTION_BUSY = 7,
  IPV4_CONNECTION_RESET = 8,
  IPV4_CONNECTION_TIMEOUT = 9,
  IPV4_NETWORK_UNREACHABLE = 10,
  IPV4_HOST_UNREACHABLE = 11,
  IPV4_PROTOCOL_UNREACHABLE = 12,
  IPV4_PORT_UNREACHABLE = 13,
  IPV4_MESSAGE_TOO_LONG = 14,
  IPV4_TIME_EXCEEDED = 15,
  IPV4_TTL_EXCEEDED = 16
};

// Writes the name of the error's constant, such as "IPV4_FAIL".  Writes "unknown IPv4Error" for a
// number that belongs to no constant.
std::ostream& operator<<(std::ostream& out, IPv4Error error);

#endif  // OPENR_IPV4TYPES_H_INCLUDED
