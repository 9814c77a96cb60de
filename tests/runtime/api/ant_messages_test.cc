#include <DNSEndpointMsg.h>
#include <EndpointTypes.h>
#include <EtherTypes.h>
#include <IPEndpointMsg.h>
#include <TCPEndpointMsg.h>
#include <UDPEndpointMsg.h>
#include <ant.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace {

antModuleRef Endpoint() {
  antModuleRef ref;
  ref.index = 5;
  return ref;
}

TEST(AntModuleRefTest, TheDefaultIsNull) {
  EXPECT_TRUE(antModuleRef().IsNull());
  EXPECT_FALSE(Endpoint().IsNull());
  EXPECT_TRUE(Endpoint() == Endpoint());
  EXPECT_TRUE(Endpoint() != antModuleRef());
}

TEST(AntModuleRefTest, StreamsItsIndex) {
  std::ostringstream out;
  out << Endpoint();
  EXPECT_EQ(out.str(), "module 5");
}

TEST(AntStackRefTest, TheDefaultIsInvalidAndAnOidMakesItValid) {
  EXPECT_FALSE(antStackRef().IsValid());
  const OID oid(reinterpret_cast<void*>(0x80000040));
  EXPECT_TRUE(antStackRef(oid).IsValid());
  EXPECT_TRUE(antStackRef(oid).get_oid() == oid);
}

TEST(AntMessagesTest, AMessageKnowsEndpointOperationAndFailureBeforeItIsSent) {
  antModuleRef endpoint = Endpoint();
  byte data[4];
  const TCPEndpointReceiveMsg receive(endpoint, data, 1, 4);
  EXPECT_EQ(receive.dstSelector, Entry_antEnv_External);
  EXPECT_TRUE(receive.dstModule == endpoint);
  EXPECT_EQ(receive.GetOperation(), 5);
  EXPECT_EQ(receive.error, TCP_FAIL);
  EXPECT_EQ(receive.buffer, data);
  EXPECT_EQ(receive.sizeMin, 1);
  EXPECT_EQ(receive.sizeMax, 4);
  EXPECT_EQ(receive.queueNr, 0);
  EXPECT_EQ(receive.continuation, nullptr);
}

TEST(AntMessagesTest, AMessageWithoutArgumentsAsksForNothing) {
  antEnvMsg messages[2] = {};
  EXPECT_EQ(messages[1].GetOperation(), 0);
  EXPECT_EQ(messages[1].dstSelector, Entry_antEnv_External);
  EXPECT_TRUE(messages[1].dstModule.IsNull());
  EXPECT_FALSE(messages[1].contInfo.GetOID().IsValid());
  EXPECT_EQ(messages[1].contInfo.GetSelector(), UNDEF);
}

TEST(AntMessagesTest, MessagesToTheStackItselfHaveNoEndpoint) {
  const antEnvCreateEndpointMsg create(EndpointType_TCP, 8192);
  EXPECT_TRUE(create.dstModule.IsNull());
  EXPECT_EQ(create.GetOperation(), -1);
  EXPECT_EQ(create.protocol, 1);
  EXPECT_EQ(create.poolSize, 8192);
  EXPECT_EQ(antEnvCreateSharedBufferMsg(512).size, 512u);
  EXPECT_EQ(antEnvCreateSharedBufferMsg(512).GetOperation(), -2);
}

TEST(AntMessagesTest, ListenDefaultsToAnyAddressAndPort) {
  antModuleRef endpoint = Endpoint();
  const TCPEndpointListenMsg listen(endpoint, IP_ADDR_ANY, 54321);
  EXPECT_EQ(listen.lPort, 54321);
  EXPECT_TRUE(listen.fAddress == IP_ADDR_ANY);
  EXPECT_EQ(listen.fPort, IP_PORT_ANY);
}

// The guide shows the arguments (module, abort), but programs are compiled with the header.
TEST(AntMessagesTest, TheArgumentAfterTheModuleOfCloseIsLinger) {
  antModuleRef endpoint = Endpoint();
  const TCPEndpointCloseMsg close(endpoint, true);
  EXPECT_TRUE(close.linger);
  EXPECT_FALSE(close.abort);
  EXPECT_EQ(close.queueNr, -100);
}

TEST(AntMessagesTest, UdpSendComesWithAndWithoutAnAddress) {
  antModuleRef endpoint = Endpoint();
  byte data[4];
  EXPECT_EQ(UDPEndpointSendMsg(endpoint, data, 4).port, 0);
  const UDPEndpointSendMsg send(endpoint, "10.0.1.2", 123, data, 4);
  EXPECT_EQ(send.address.Address(), 0x0a000102u);
  EXPECT_EQ(send.port, 123);
  EXPECT_EQ(send.size, 4);
}

TEST(AntMessagesTest, ParameterMessagesGoToTheInitializeEntry) {
  const antEnvInitGetParamMsg get("ETHER_IP");
  EXPECT_EQ(get.dstSelector, Entry_antEnv_Initialize);
  EXPECT_EQ(get.GetOperation(), -3);
  EXPECT_STREQ(get.key, "ETHER_IP");
  const antEnvInitSetParamMsg number("MTU", 1500);
  EXPECT_EQ(number.paramType, antEnv_InitParam_Int32);
  EXPECT_EQ(number.value.i32, 1500);
  const antEnvInitSetParamMsg text("HOST", "AIBO");
  EXPECT_EQ(text.paramType, antEnv_InitParam_String);
  EXPECT_STREQ(text.value.str, "AIBO");
}

TEST(AntMessagesTest, LongTextsAreCutAndEndInNul) {
  antModuleRef endpoint = Endpoint();
  const DNSEndpointGetHostByNameMsg query(endpoint, std::string(200, 'a').c_str());
  EXPECT_EQ(std::string(query.name), std::string(MAXDNAME - 1, 'a'));
  EXPECT_EQ(std::string(antEnvInitGetParamMsg(std::string(50, 'k').c_str()).key),
            std::string(ANTENV_KEY_LENGTH_MAX - 1, 'k'));
}

TEST(AntMessagesTest, MoreServersThanThereIsRoomForAreLeftOut) {
  antModuleRef endpoint = Endpoint();
  IPAddress servers[5] = {1, 2, 3, 4, 5};
  const DNSEndpointSetServerAddressesMsg set(endpoint, 5, servers);
  EXPECT_EQ(set.nscount, MAXNS);
  EXPECT_EQ(set.addrList[2].Address(), 3u);
  EXPECT_EQ(DNSEndpointSetServerAddressesMsg(endpoint, -1, servers).nscount, 0);
}

TEST(AntMessagesTest, AQuestionByAddressCarriesTheAddress) {
  antModuleRef endpoint = Endpoint();
  const DNSEndpointGetHostByAddrMsg query(endpoint, "10.0.1.1");
  EXPECT_EQ(query.host_address.Address(), 0x0a000101u);
  EXPECT_STREQ(query.name, "");
  EXPECT_EQ(query.n_address, 0);
}

TEST(AntSharedBufferTest, ABufferOfTheStackHasItsSize) {
  const antSharedBuffer buffer(17, 8192, 3);
  EXPECT_EQ(buffer.GetRegion(), 17u);
  EXPECT_EQ(buffer.GetSize(), 8192u);
  EXPECT_EQ(buffer.GetCookie(), 3u);
}

TEST(ErrorNamesTest, AResultIsNamedAsItsConstant) {
  EXPECT_STREQ(antErrorString(ANT_SUCCESS), "ANT_SUCCESS");
  EXPECT_STREQ(antErrorString(ANT_QUEUE_REJECTED), "ANT_QUEUE_REJECTED");
  EXPECT_STREQ(antErrorString(ANT_INITIALIZING), "ANT_INITIALIZING");
  EXPECT_STREQ(etherStatusStr(ETHER_INVALID_PORT), "ETHER_INVALID_PORT");
}

template <typename Error>
std::string Streamed(Error error) {
  std::ostringstream out;
  out << error;
  return out.str();
}

TEST(ErrorNamesTest, AResultIsStreamedAsItsName) {
  EXPECT_EQ(Streamed(ANT_QUEUE_CLOSED), "ANT_QUEUE_CLOSED");
  EXPECT_EQ(Streamed(ETHER_NO_DEVICE), "ETHER_NO_DEVICE");
  EXPECT_EQ(Streamed(IPV4_TTL_EXCEEDED), "IPV4_TTL_EXCEEDED");
  EXPECT_EQ(Streamed(TCP_SUCCESS), "TCP_SUCCESS");
  EXPECT_EQ(Streamed(TCP_OPERATION_UNKNOWN), "TCP_OPERATION_UNKNOWN");
  EXPECT_EQ(Streamed(UDP_WOULDBLOCK), "UDP_WOULDBLOCK");
  EXPECT_EQ(Streamed(IP_OPERATION_UNKNOWN), "IP_OPERATION_UNKNOWN");
  EXPECT_EQ(Streamed(DNS_HOST_NOT_FOUND), "DNS_HOST_NOT_FOUND");
  EXPECT_EQ(Streamed(DNS_OPERATION_UNKNOWN), "DNS_OPERATION_UNKNOWN");
}

TEST(ErrorNamesTest, NumbersWithoutANameAreStreamedAsUnknown) {
  EXPECT_EQ(Streamed(static_cast<TCPEndpointError>(19)), "unknown TCPEndpointError");
  EXPECT_EQ(Streamed(static_cast<UDPEndpointError>(17)), "unknown UDPEndpointError");
  EXPECT_EQ(Streamed(static_cast<IPEndpointError>(9)), "unknown IPEndpointError");
  EXPECT_EQ(Streamed(static_cast<DNSEndpointError>(12)), "unknown DNSEndpointError");
  EXPECT_EQ(Streamed(static_cast<IPv4Error>(17)), "unknown IPv4Error");
}

TEST(ErrorNamesTest, OtherNumbersAreUnknown) {
  EXPECT_STREQ(etherStatusStr(13), "unknown EtherStatus");
  EXPECT_STREQ(etherStatusStr(-1), "unknown EtherStatus");
}

}  // namespace
