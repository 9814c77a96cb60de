// Messages to a DNS endpoint, which looks up names and addresses of hosts.  Only one query may wait
// for its answer at a time.
//
// The network stack appends the default domain to a host name without a dot at its end.  All
// objects share one list of DNS servers.
#ifndef OPENR_DNSENDPOINTMSG_H_INCLUDED
#define OPENR_DNSENDPOINTMSG_H_INCLUDED

#include <DNSEndpointErr.h>
#include <IPv4Types.h>
#include <antEnvMsg.h>

// The largest number of DNS servers, and the size in bytes of a host name with its closing NUL.
// These limits keep every message below 256 bytes, the limit of the robot for a message.
#define MAXNS 3
#define MAXDNAME 100

// The operations that a message to a DNS endpoint can request (field dstOperation).  The numbers
// are those of the robot, the names are our choice.
const int32 DNSEndpoint_Operation_SetServerAddresses = 0;
const int32 DNSEndpoint_Operation_GetServerAddresses = 1;
const int32 DNSEndpoint_Operation_SetDefaultDomainName = 2;
const int32 DNSEndpoint_Operation_GetDefaultDomainName = 3;
const int32 DNSEndpoint_Operation_GetHostByName = 4;
const int32 DNSEndpoint_Operation_GetHostByAddr = 5;
const int32 DNSEndpoint_Operation_GetAddress = 6;
const int32 DNSEndpoint_Operation_GetAlias = 7;
const int32 DNSEndpoint_Operation_Close = 8;

// The base class of all messages to a DNS endpoint.
struct DNSEndpointBaseMsg : public antOperationMsg<DNSEndpointError> {
  DNSEndpointBaseMsg(int32 operation = 0) : antOperationMsg<DNSEndpointError>(operation) {}
  DNSEndpointBaseMsg(antModuleRef& module, int32 operation)
      : antOperationMsg<DNSEndpointError>(module, operation) {}
};

// Sets the list of DNS servers; servers after the first MAXNS are ignored.
struct DNSEndpointSetServerAddressesMsg : public DNSEndpointBaseMsg {
  int32 nscount;
  IPAddress addrList[MAXNS];

  DNSEndpointSetServerAddressesMsg();
  DNSEndpointSetServerAddressesMsg(antModuleRef& module, int32 count, IPAddress* list);
};

struct DNSEndpointGetServerAddressesMsg : public DNSEndpointBaseMsg {
  int32 nscount;              // set by the network stack in its answer
  IPAddress addrList[MAXNS];  // set by the network stack in its answer

  DNSEndpointGetServerAddressesMsg();
  explicit DNSEndpointGetServerAddressesMsg(antModuleRef& module);
};

struct DNSEndpointSetDefaultDomainNameMsg : public DNSEndpointBaseMsg {
  char name[MAXDNAME];

  DNSEndpointSetDefaultDomainNameMsg();
  DNSEndpointSetDefaultDomainNameMsg(antModuleRef& module, const char* domain);
};

struct DNSEndpointGetDefaultDomainNameMsg : public DNSEndpointBaseMsg {
  char name[MAXDNAME];  // set by the network stack in its answer

  DNSEndpointGetDefaultDomainNameMsg();
  explicit DNSEndpointGetDefaultDomainNameMsg(antModuleRef& module);
};

// Asks for the addresses of the host `name`.  If the query fails, n_address is 0 and `name` keeps
// its value in the answer; the same holds for DNSEndpointGetHostByAddrMsg.
struct DNSEndpointGetHostByNameMsg : public DNSEndpointBaseMsg {
  char name[MAXDNAME];       // in the answer: the official name
  IPAddress server_address;  // in the answer: the server that answered
  IPAddress host_address;    // in the answer: the first address
  int32 n_address;           // in the answer: number of addresses
  int32 n_alias;             // in the answer: number of aliases

  DNSEndpointGetHostByNameMsg();
  DNSEndpointGetHostByNameMsg(antModuleRef& module, const char* host);
};

struct DNSEndpointGetHostByAddrMsg : public DNSEndpointBaseMsg {
  char name[MAXDNAME];       // set by the network stack in its answer
  IPAddress server_address;  // set by the network stack in its answer
  IPAddress host_address;
  int32 n_address;  // set by the network stack in its answer
  int32 n_alias;    // set by the network stack in its answer

  DNSEndpointGetHostByAddrMsg();
  DNSEndpointGetHostByAddrMsg(antModuleRef& module, IPAddress address);
};

// Asks for one address of the host that the last query has found, by the index of the address.  The
// error is DNS_INDEX_INVALID if no address has this index.
struct DNSEndpointGetAddressMsg : public DNSEndpointBaseMsg {
  int32 index;
  IPAddress address;  // set by the network stack in its answer

  DNSEndpointGetAddressMsg();
  DNSEndpointGetAddressMsg(antModuleRef& module, int number);
};

// Asks for one alias of the host that the last query has found, by the index of the alias.  Alias 0
// is the official name.
struct DNSEndpointGetAliasMsg : public DNSEndpointBaseMsg {
  int32 index;
  char name[MAXDNAME];  // set by the network stack in its answer

  DNSEndpointGetAliasMsg();
  DNSEndpointGetAliasMsg(antModuleRef& module, int number);
};

struct DNSEndpointCloseMsg : public DNSEndpointBaseMsg {
  DNSEndpointCloseMsg();
  explicit DNSEndpointCloseMsg(antModuleRef& module);
};

#endif  // OPENR_DNSENDPOINTMSG_H_INCLUDED
