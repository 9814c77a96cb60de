// Sizes and hashes of messages.
#include "runtime/ipstack/ant_message.h"

#include <DNSEndpointMsg.h>
#include <EndpointTypes.h>
#include <TCPEndpointMsg.h>
#include <UDPEndpointMsg.h>
#include <gtest/gtest.h>

namespace openr_host {
namespace {

antModuleRef tcp = MakeModuleRef(EndpointType_TCP, 3);
antModuleRef udp = MakeModuleRef(EndpointType_UDP, 4);
antModuleRef dns = MakeModuleRef(EndpointType_DNS, 5);

TEST(AntMessageTest, SizeIsThatOfTheOperationsStruct) {
  EXPECT_EQ(AntMessageSize(TCPEndpointListenMsg(tcp)), sizeof(TCPEndpointListenMsg));
  EXPECT_EQ(AntMessageSize(TCPEndpointReceiveMsg(tcp, nullptr, 0, 0)),
            sizeof(TCPEndpointReceiveMsg));
  EXPECT_EQ(AntMessageSize(UDPEndpointBindMsg(udp, 0, 0)), sizeof(UDPEndpointBindMsg));
  EXPECT_EQ(AntMessageSize(DNSEndpointGetHostByNameMsg(dns, "x")),
            sizeof(DNSEndpointGetHostByNameMsg));
  EXPECT_EQ(AntMessageSize(antEnvCreateEndpointMsg()), sizeof(antEnvCreateEndpointMsg));
  EXPECT_EQ(AntMessageSize(antEnvInitGetParamMsg("x")), sizeof(antEnvInitGetParamMsg));
}

TEST(AntMessageTest, SizeOfAnUnknownOperationIsTheCommonPart) {
  TCPEndpointListenMsg message(tcp);
  message.dstOperation = 1000;
  EXPECT_EQ(AntMessageSize(message), sizeof(TCPEndpointBaseMsg));
  message.dstModule.module = &message;  // not a reference that a stack has made
  EXPECT_EQ(AntMessageSize(message), sizeof(TCPEndpointBaseMsg));
}

TEST(AntMessageTest, HashSeesFieldsAndData) {
  TCPEndpointSendMsg message(tcp, nullptr, 3);
  const uint64_t hash = AntMessageHash(message, "abc", 3);
  EXPECT_EQ(AntMessageHash(message, "abc", 3), hash);
  EXPECT_NE(AntMessageHash(message, "abd", 3), hash);
  message.size = 4;
  EXPECT_NE(AntMessageHash(message, "abc", 3), hash);
  message.size = 3;
  message.error = TCP_SUCCESS;
  EXPECT_NE(AntMessageHash(message, "abc", 3), hash);
}

TEST(AntMessageTest, HashSeesNoAddresses) {
  byte here[4], there[4];
  TCPEndpointSendMsg a(tcp, here, 3), b(tcp, there, 3);
  b.continuation = there;
  b.sender = OID(there);
  EXPECT_EQ(AntMessageHash(a), AntMessageHash(b));
}

TEST(AntMessageTest, HashOfTextEndsAtItsNul) {
  DNSEndpointGetHostByNameMsg a(dns, "host"), b(dns, "host");
  b.name[50] = 'x';
  EXPECT_EQ(AntMessageHash(a), AntMessageHash(b));
}

TEST(AntMessageTest, ClearCountsLeavesTheQuestion) {
  TCPEndpointReceiveMsg receive(tcp, nullptr, 5, 6);
  ClearCounts(&receive);
  EXPECT_EQ(receive.sizeMin, 0);
  EXPECT_EQ(receive.sizeMax, 0);
  DNSEndpointGetHostByNameMsg query(dns, "host");
  query.n_address = 7;
  ClearCounts(&query);
  EXPECT_EQ(query.n_address, 0);
  EXPECT_STREQ(query.name, "host");
}

}  // namespace
}  // namespace openr_host
