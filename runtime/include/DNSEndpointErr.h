// Results of look-ups of host names and addresses: the errors in messages to a DNS endpoint of the
// network stack.
#ifndef OPENR_DNSENDPOINTERR_H_INCLUDED
#define OPENR_DNSENDPOINTERR_H_INCLUDED

#include <iostream>

enum DNSEndpointError {
  DNS_SUCCESS = 0,
  DNS_FAIL = 1,
  DNS_HOST_NOT_FOUND = 2,
  DNS_TRY_AGAIN = 3,
  DNS_NO_RECOVERY = 4,
  DNS_NO_DATA = 5,
  DNS_CONNECTION_CLOSED = 6,
  DNS_CONNECTION_BUSY = 7,
  DNS_INDEX_INVALID = 8,
  DNS_BUFFER_INVALID = 9,
  DNS_OPERATION_INVALID = 10,
  DNS_OPERATION_UNKNOWN = 11
};

// Writes the name of the error's constant, such as "DNS_FAIL".  Writes "unknown DNSEndpointError"
// for a number that belongs to no constant.
std::ostream& operator<<(std::ostream& out, DNSEndpointError error);

#endif  // OPENR_DNSENDPOINTERR_H_INCLUDED
