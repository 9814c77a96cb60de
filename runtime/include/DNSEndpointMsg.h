// Messages to a DNS endpoint; one may be pending at a time.
//
// A name without a dot at its end gets the default domain appended.  The list of servers
// is shared by all objects.
#ifndef OPENR_DNSENDPOINTMSG_H_INCLUDED
#define OPENR_DNSENDPOINTMSG_H_INCLUDED

#include <DNSEndpointErr.h>
#include <IPv4Types.h>
#include <antEnvMsg.h>

// Room for servers, and for a name with its closing NUL: messages are below 256 bytes.
#define MAXNS 3
#define MAXDNAME 100

// Values of dstOperation; the numbers are the robot's, the names ours.
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

// More than MAXNS servers are cut to MAXNS; longer names are cut.
struct DNSEndpointSetServerAddressesMsg : public DNSEndpointBaseMsg {
  int32 nscount;
  IPAddress addrList[MAXNS];

  DNSEndpointSetServerAddressesMsg();
  DNSEndpointSetServerAddressesMsg(antModuleRef& module, int32 count, IPAddress* list);
};

struct DNSEndpointGetServerAddressesMsg : public DNSEndpointBaseMsg {
  int32 nscount;              // out
  IPAddress addrList[MAXNS];  // out

  DNSEndpointGetServerAddressesMsg();
  explicit DNSEndpointGetServerAddressesMsg(antModuleRef& module);
};

struct DNSEndpointSetDefaultDomainNameMsg : public DNSEndpointBaseMsg {
  char name[MAXDNAME];

  DNSEndpointSetDefaultDomainNameMsg();
  DNSEndpointSetDefaultDomainNameMsg(antModuleRef& module, const char* domain);
};

struct DNSEndpointGetDefaultDomainNameMsg : public DNSEndpointBaseMsg {
  char name[MAXDNAME];  // out

  DNSEndpointGetDefaultDomainNameMsg();
  explicit DNSEndpointGetDefaultDomainNameMsg(antModuleRef& module);
};

// The answer to both host questions; on failure n_address is 0 and name as it was.
struct DNSEndpointGetHostByNameMsg : public DNSEndpointBaseMsg {
  char name[MAXDNAME];       // out: the official name
  IPAddress server_address;  // out: who answered
  IPAddress host_address;    // out: the first address
  int32 n_address;           // out: how many addresses and aliases there are
  int32 n_alias;

  DNSEndpointGetHostByNameMsg();
  DNSEndpointGetHostByNameMsg(antModuleRef& module, const char* host);
};

struct DNSEndpointGetHostByAddrMsg : public DNSEndpointBaseMsg {
  char name[MAXDNAME];       // out
  IPAddress server_address;  // out
  IPAddress host_address;
  int32 n_address;  // out
  int32 n_alias;    // out

  DNSEndpointGetHostByAddrMsg();
  DNSEndpointGetHostByAddrMsg(antModuleRef& module, IPAddress address);
};

// Further addresses and aliases of the last host found; DNS_INDEX_INVALID beyond the last.
struct DNSEndpointGetAddressMsg : public DNSEndpointBaseMsg {
  int32 index;
  IPAddress address;  // out

  DNSEndpointGetAddressMsg();
  DNSEndpointGetAddressMsg(antModuleRef& module, int number);
};

// Alias 0 is the official name.
struct DNSEndpointGetAliasMsg : public DNSEndpointBaseMsg {
  int32 index;
  char name[MAXDNAME];  // out

  DNSEndpointGetAliasMsg();
  DNSEndpointGetAliasMsg(antModuleRef& module, int number);
};

struct DNSEndpointCloseMsg : public DNSEndpointBaseMsg {
  DNSEndpointCloseMsg();
  explicit DNSEndpointCloseMsg(antModuleRef& module);
};

#endif  // OPENR_DNSENDPOINTMSG_H_INCLUDED
