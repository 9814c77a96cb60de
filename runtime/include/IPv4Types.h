// Addresses, ports and the errors inside the IPv4 stack.
#ifndef OPENR_IPV4TYPES_H_INCLUDED
#define OPENR_IPV4TYPES_H_INCLUDED

#include <IPAddress.h>
#include <antTypes.h>

typedef uint16 Port;  // in the order of the host
typedef uint16 Protocol;

extern const IPAddress IP_ADDR_ANY;        // 0.0.0.0
extern const IPAddress IP_ADDR_BROADCAST;  // 255.255.255.255
const Port IP_PORT_ANY = 0;

// Not seen by programs.
enum IPv4Error {
  IPv4_SUCCESS = 0,
  IPv4_FAIL = 1,
  IPv4_NOMEMORY = 2,
  IPv4_ADDRESSINUSE = 3,
  IPv4_ADDRESSERROR = 4,
  IPv4_INVALID_REQUEST = 5,
  IPv4_CONNECTION_CLOSED = 6,
  IPv4_CONNECTION_BUSY = 7,
  IPv4_CONNECTION_RESET = 8,
  IPv4_CONNECTION_TIMEOUT = 9,
  IPv4_NETWORK_UNREACHABLE = 10,
  IPv4_HOST_UNREACHABLE = 11,
  IPv4_PROTOCOL_UNREACHABLE = 12,
  IPv4_PORT_UNREACHABLE = 13,
  IPv4_MESSAGE_TOO_LONG = 14,
  IPv4_TIME_EXCEEDED = 15,
  IPv4_TTL_EXCEEDED = 16
};

#endif  // OPENR_IPV4TYPES_H_INCLUDED
