// DNS operations; numbers in answers are those of DNSEndpointError.
#include "runtime/ipstack/dns_endpoint.h"

#include "tests/runtime/ipstack/net_probe.h"

namespace openr_host {
namespace {

class DnsTest : public NetTest {
 protected:
  DnsTest() {
    hub->names["time.example.net"] = {"clock.example.net", {"time.example.net"}, {1, 2}};
    Do([this] { endpoint = probe->NewEndpoint(EndpointType_DNS, 16384); });
    probe->on_reply = [this](antEnvMsg* m) {
      if (m->GetOperation() == DNSEndpoint_Operation_GetHostByName) {
        answer = *static_cast<DNSEndpointGetHostByNameMsg*>(m);
      }
    };
  }
  void LookUp(const char* name) {
    Do([=, this] { probe->Send(DNSEndpointGetHostByNameMsg(endpoint, name)); });
    Frames();
  }
  void SetDomain(const char* domain) {
    Do([=, this] {
      DNSEndpointSetDefaultDomainNameMsg set(endpoint, domain);
      set.Call(probe->Stack(), sizeof set);
      EXPECT_EQ(set.error, DNS_SUCCESS);
    });
  }

  antModuleRef endpoint;
  DNSEndpointGetHostByNameMsg answer;
};

TEST_F(DnsTest, AnswerHasOfficialNameFirstAddressAndCounts) {
  LookUp("time.example.net.");
  EXPECT_EQ(answer.error, DNS_SUCCESS);
  EXPECT_STREQ(answer.name, "clock.example.net");
  EXPECT_EQ(answer.host_address, IPAddress(1));
  EXPECT_EQ(answer.n_address, 2);
  EXPECT_EQ(answer.n_alias, 2);
}

TEST_F(DnsTest, FurtherAddressesAndAliasesAreFetchedByIndex) {
  LookUp("time.example.net.");
  Do([&] {
    DNSEndpointGetAddressMsg address(endpoint, 1);
    address.Call(probe->Stack(), sizeof address);
    EXPECT_EQ(address.address, IPAddress(2));
    DNSEndpointGetAliasMsg official(endpoint, 0);
    official.Call(probe->Stack(), sizeof official);
    EXPECT_STREQ(official.name, "clock.example.net");
    DNSEndpointGetAliasMsg alias(endpoint, 1);
    alias.Call(probe->Stack(), sizeof alias);
    EXPECT_STREQ(alias.name, "time.example.net");
  });
}

TEST_F(DnsTest, IndicesBeyondTheCountsAreInvalid) {
  LookUp("time.example.net.");
  TakeReplies();
  Do([&] {
    probe->Send(DNSEndpointGetAddressMsg(endpoint, 2));
    probe->Send(DNSEndpointGetAddressMsg(endpoint, -1));
    probe->Send(DNSEndpointGetAliasMsg(endpoint, 2));
  });
  EXPECT_EQ(probe->replies, (Replies{"DNS GetAddress 8", "DNS GetAddress 8", "DNS GetAlias 8"}));
}

TEST_F(DnsTest, UnknownNameHasNoAddressesAndKeepsTheQuestion) {
  LookUp("nobody.example.net.");
  EXPECT_EQ(answer.error, DNS_HOST_NOT_FOUND);
  EXPECT_EQ(answer.n_address, 0);
  EXPECT_STREQ(answer.name, "nobody.example.net.");
}

TEST_F(DnsTest, NameWithoutFinalDotGetsTheDefaultDomain) {
  LookUp("time");
  EXPECT_EQ(answer.error, DNS_HOST_NOT_FOUND);
  SetDomain("example.net");
  LookUp("time");
  EXPECT_EQ(answer.error, DNS_SUCCESS);
  LookUp("time.example.net");
  EXPECT_EQ(answer.error, DNS_HOST_NOT_FOUND);
}

TEST_F(DnsTest, ReverseLookUpFindsTheName) {
  probe->on_reply = [](antEnvMsg* m) {
    EXPECT_STREQ(static_cast<DNSEndpointGetHostByAddrMsg*>(m)->name, "clock.example.net");
  };
  Do([&] { probe->Send(DNSEndpointGetHostByAddrMsg(endpoint, 2)); });
  Frames();
  EXPECT_EQ(probe->replies, Replies{"DNS GetHostByAddr 0"});
}

TEST_F(DnsTest, ServersAreSharedByAllEndpoints) {
  IPAddress list[2] = {kClientIp, 7};
  Do([&] {
    antModuleRef other = probe->NewEndpoint(EndpointType_DNS);
    DNSEndpointSetServerAddressesMsg set(other, 2, list);
    set.Call(probe->Stack(), sizeof set);
    DNSEndpointGetServerAddressesMsg get(endpoint);
    get.Call(probe->Stack(), sizeof get);
    EXPECT_EQ(get.nscount, 2);
    EXPECT_EQ(get.addrList[1], IPAddress(7));
  });
  LookUp("time.example.net.");
  EXPECT_EQ(answer.server_address, IPAddress(kClientIp));
}

TEST_F(DnsTest, DefaultDomainIsReadBack) {
  SetDomain("example.net");
  Do([&] {
    DNSEndpointGetDefaultDomainNameMsg get(endpoint);
    get.Call(probe->Stack(), sizeof get);
    EXPECT_STREQ(get.name, "example.net");
  });
}

TEST_F(DnsTest, SecondOperationWhileOneIsPendingIsBusy) {
  Do([&] {
    probe->Send(DNSEndpointGetHostByNameMsg(endpoint, "time.example.net."));
    probe->Send(DNSEndpointGetHostByNameMsg(endpoint, "time.example.net."));
    probe->Send(DNSEndpointGetServerAddressesMsg(endpoint));
  });
  EXPECT_EQ(probe->replies, (Replies{"DNS GetHostByName 7", "DNS GetServerAddresses 7"}));
  EXPECT_EQ(answer.n_address, 0);
}

TEST_F(DnsTest, CloseAnswersThePendingQuestionFirst) {
  Do([&] {
    probe->Send(DNSEndpointGetHostByNameMsg(endpoint, "time.example.net."));
    probe->Send(DNSEndpointCloseMsg(endpoint));
    probe->Send(DNSEndpointCloseMsg(endpoint));
  });
  Frames();
  EXPECT_EQ(probe->replies, (Replies{"DNS GetHostByName 6", "DNS Close 0", "DNS Close 6"}));
}

// Sony's sample DNSLookUp does this.
TEST_F(DnsTest, CallFromWithinAReplyHandlerWorks) {
  std::string domain;
  SetDomain("example.net");
  probe->on_reply = [&](antEnvMsg*) {
    DNSEndpointGetDefaultDomainNameMsg get(endpoint);
    get.Call(probe->Stack(), sizeof get);
    domain = get.name;
  };
  LookUp("time");
  EXPECT_EQ(domain, "example.net");
}

}  // namespace
}  // namespace openr_host
