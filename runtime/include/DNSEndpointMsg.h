// Messages to a DNS endpoint.  Only one question may wait for its answer at a time.
//
// A name without a dot at its end gets the default domain appended.  All objects share one list of
// servers.
#ifndef OPENR_DNSENDPOINTMSG_H_INCLUDED
#define OPENR_DNSENDPOINTMSG_H_INCLUDED

#include <DNSEndpointErr.h>
#include <IPv4Types.h>
#include <antEnvMsg.h>

// The largest number of servers, and the size of a name with its closing NUL.  With these limits a
// message has less than 256 bytes.
#define MAXNS 3
#define MAXDNAME 100

// Values of dstOperation; the numbers are those of the robot, the names are our choice.
const int32 DNSEndpoint_Operation_SetServerAddresses = 0;
const int32 DNSEndpoint_Operation_GetServerAddresses = 1;
const int32 DNSEndpoint_Operation_SetDefaultDomainName = 2;
const int32 DNSEndpoint_Operation_GetDefaultDomainName = 3;
const int32 DNSEndpoint_Operation_GetHostByName = 4;
const int32 DNSEndpoint_Operation_GetHostByAddr = 5;
const int32 DNSEndpoint_Operation_GetAddress = 6;
const int32 DNSEndpoint_Operation_GetAlias = 7;
const int32 DNSEndpoint_Operation_Close = 8;

// The base of the messages below.
struct DNSEndpointBaseMsg : public antOperationMsg<DNSEndpointError> {
  DNSEndpointBaseMsg(int32 operation = 0) : antOperationMsg<DNSEndpointError>(operation) {}
  DNSEndpointBaseMsg(antModuleRef& module, int32 operation)
      : antOperationMsg<DNSEndpointError>(module, operation) {}
};

// Sets the list of servers; servers after the first MAXNS are ignored.
struct DNSEndpointSetServerAddressesMsg : public DNSEndpointBaseMsg {
  int32 nscount;
  IPAddress addrList[MAXNS];

  DNSEndpointSetServerAddressesMsg();
  DNSEndpointSetServerAddressesMsg(antModuleRef& module, int32 count, IPAddress* list);
};

struct DNSEndpointGetServerAddressesMsg : public DNSEndpointBaseMsg {
  int32 nscount;              // set in the answer
  IPAddress addrList[MAXNS];  // set in the answer

  DNSEndpointGetServerAddressesMsg();
  explicit DNSEndpointGetServerAddressesMsg(antModuleRef& module);
};

struct DNSEndpointSetDefaultDomainNameMsg : public DNSEndpointBaseMsg {
  char name[MAXDNAME];

  DNSEndpointSetDefaultDomainNameMsg();
  DNSEndpointSetDefaultDomainNameMsg(antModuleRef& module, const char* domain);
};

struct DNSEndpointGetDefaultDomainNameMsg : public DNSEndpointBaseMsg {
  char name[MAXDNAME];  // set in the answer

  DNSEndpointGetDefaultDomainNameMsg();
  explicit DNSEndpointGetDefaultDomainNameMsg(antModuleRef& module);
};

// Asks for the addresses of a host.  On failure n_address is 0 and name keeps its value; the same
// holds for DNSEndpointGetHostByAddrMsg.
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
  char name[MAXDNAME];       // set in the answer
  IPAddress server_address;  // set in the answer
  IPAddress host_address;
  int32 n_address;  // set in the answer
  int32 n_alias;    // set in the answer

  DNSEndpointGetHostByAddrMsg();
  DNSEndpointGetHostByAddrMsg(antModuleRef& module, IPAddress address);
};

// Asks for an address of the host that was found last, by the index of the address; the error is
// DNS_INDEX_INVALID if no address has this index.
struct DNSEndpointGetAddressMsg : public DNSEndpointBaseMsg {
  int32 index;
  IPAddress address;  // set in the answer

  DNSEndpointGetAddressMsg();
  DNSEndpointGetAddressMsg(antModuleRef& module, int number);
};

// Asks for an alias of the host that was found last, by the index of the alias.  Alias 0 is the
// official name.
struct DNSEndpointGetAliasMsg : public DNSEndpointBaseMsg {
  int32 index;
  char name[MAXDNAME];  // set in the answer

  DNSEndpointGetAliasMsg();
  DNSEndpointGetAliasMsg(antModuleRef& module, int number);
};

struct DNSEndpointCloseMsg : public DNSEndpointBaseMsg {
  DNSEndpointCloseMsg();
  explicit DNSEndpointCloseMsg(antModuleRef& module);
};

#endif  // OPENR_DNSENDPOINTMSG_H_INCLUDED
