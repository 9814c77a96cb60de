// Tests of the stack itself: references, messages, buffers, parameters, the card.
#include "runtime/ipstack/ip_stack.h"

#include <ERA201D1.h>
#include <IPEndpointMsg.h>

#include "runtime/base/hasher.h"
#include "runtime/core/stalls.h"
#include "tests/runtime/ipstack/net_probe.h"

namespace openr_host {
namespace {

class IpStackTest : public NetTest {};

TEST_F(IpStackTest, IsFoundByItsName) {
  Do([&] {
    EXPECT_TRUE(antStackRef("IPStack").IsValid());
    EXPECT_FALSE(antStackRef("IPStuck").IsValid());
    EXPECT_FALSE(antStackRef("ipstack").IsValid());
  });
}

TEST_F(IpStackTest, AnswersDuringDoInit) {
  System other;
  other.AddRobot("ERS-210", nullptr);
  AddIpStack(&other, 0, std::make_unique<LoopbackNetwork>());
  auto* const early = other.AddObject<NetProbe>(0, "early");
  bool done = false;
  early->on_init = [&] { done = early->NewBuffer(10) != nullptr; };
  other.Boot();
  other.RunFor(1000);
  EXPECT_TRUE(done);
}

TEST_F(IpStackTest, SendReturnsBeforeTheAnswerComes) {
  Do([&] {
    EXPECT_EQ(probe->Send(antEnvCreateSharedBufferMsg(1)), ANT_SUCCESS);
    EXPECT_TRUE(probe->replies.empty());
  });
  EXPECT_EQ(probe->replies, Replies{"CreateSharedBuffer 0"});
}

TEST_F(IpStackTest, ContinuationComesBackBitForBit) {
  void* const continuation = reinterpret_cast<void*>(uintptr_t{0xdeadbeef12345678});
  probe->on_reply = [&](antEnvMsg* m) { EXPECT_EQ(m->continuation, continuation); };
  Do([&] {
    antEnvCreateSharedBufferMsg create(1);
    create.continuation = continuation;
    probe->Send(create);
    create.Call(probe->Stack(), sizeof create);
    EXPECT_EQ(create.continuation, continuation);
  });
  EXPECT_EQ(probe->replies.size(), 1u);
}

TEST_F(IpStackTest, ReplyCarriesSenderAndOperationAndMayBeWrittenTo) {
  probe->on_reply = [&](antEnvMsg* m) {
    EXPECT_EQ(m->GetSender(), probe->oid());
    EXPECT_EQ(m->GetOperation(), antEnv_Operation_CreateSharedBuffer);
    EXPECT_EQ(m->invocationType, ANTENVMSG_SEND);
    EXPECT_EQ(m->dstSelector, Entry_antEnv_External);
    static_cast<antEnvCreateSharedBufferMsg*>(m)->size = 0;
  };
  Do([&] { probe->Send(antEnvCreateSharedBufferMsg(1)); });
  EXPECT_EQ(probe->replies.size(), 1u);
}

TEST_F(IpStackTest, RepliesGoToTheObjectAndEntryNamed) {
  auto* const other = system.AddObject<NetProbe>(0, "other");
  Do([&] {
    antEnvCreateSharedBufferMsg create(1);
    OID oid = other->oid();
    create.Send(probe->Stack(), oid, static_cast<int32>(other->reply_selector()), sizeof create);
  });
  EXPECT_TRUE(probe->replies.empty());
  EXPECT_EQ(other->replies, Replies{"CreateSharedBuffer 0"});
}

TEST_F(IpStackTest, CallBlocksOnlyItsCaller) {
  auto* const other = system.AddObject<NetProbe>(0, "other");
  bool returned = false, other_ran = false;
  Do([&] {
    antModuleRef endpoint = probe->NewEndpoint(EndpointType_TCP);
    TCPEndpointListenMsg listen(endpoint, IP_ADDR_ANY, kPort);
    EXPECT_EQ(listen.Call(probe->Stack(), sizeof listen), ANT_SUCCESS);
    EXPECT_EQ(listen.error, TCP_SUCCESS);
    EXPECT_EQ(listen.fAddress, IPAddress(kClientIp));
    returned = true;
  });
  EXPECT_FALSE(returned);
  EXPECT_EQ(DescribeWaits(system),
            std::vector<std::string>{
                "probe waits for the answer of IPStack (TCP Listen) since t=0.001 s"});
  other->Do([&] { other_ran = true; });
  Frames();
  EXPECT_TRUE(other_ran);
  peer.Connect(kPort);
  Frames();
  EXPECT_TRUE(returned);
}

TEST_F(IpStackTest, CallToNobodyFailsAndSetsTheError) {
  Do([&] {
    antEnvCreateSharedBufferMsg create(1);
    create.error = ANT_SUCCESS;
    EXPECT_EQ(create.Call(antStackRef("nobody"), sizeof create), ANT_FAIL);
    EXPECT_EQ(create.error, ANT_FAIL);
    EXPECT_EQ(probe->Send(antEnvCreateSharedBufferMsg(1)), ANT_SUCCESS);
    OID oid = probe->oid();
    EXPECT_EQ(create.Send(antStackRef(), oid, 4, sizeof create), ANT_FAIL);
  });
}

TEST_F(IpStackTest, CallOutsideOfAHandlerFailsInsteadOfWaiting) {
  const CurrentScope scope(&system, &probe->host());
  antEnvCreateSharedBufferMsg create(1);
  EXPECT_EQ(create.Call(probe->Stack(), sizeof create), ANT_FAIL);
  EXPECT_TRUE(system.findings().HasError());
}

TEST_F(IpStackTest, EndpointTypesWithoutMessagesHaveNoFactory) {
  Do([&] {
    for (const int32 type : {EndpointType_IP, EndpointType_TFTP, 0, -3, 99}) {
      antEnvCreateEndpointMsg create(type);
      create.Call(probe->Stack(), sizeof create);
      EXPECT_EQ(create.error, ANT_ENDPOINT_NOFACTORY) << type;
      EXPECT_TRUE(create.moduleRef.IsNull());
    }
  });
}

TEST_F(IpStackTest, PoolsThatCannotBeAreRefused) {
  Do([&] {
    antEnvCreateEndpointMsg negative(EndpointType_TCP, -1);
    negative.Call(probe->Stack(), sizeof negative);
    EXPECT_EQ(negative.error, ANT_FAIL);
    antEnvCreateEndpointMsg huge(EndpointType_TCP, 0x7fffffff);
    huge.Call(probe->Stack(), sizeof huge);
    EXPECT_EQ(huge.error, ANT_NOMEMORY);
  });
}

TEST_F(IpStackTest, EndpointsAreBounded) {
  Do([&] {
    for (size_t i = 0; i < IpStack::kEndpointsMax; ++i) probe->NewEndpoint(EndpointType_TCP);
    antEnvCreateEndpointMsg create(EndpointType_TCP);
    create.Call(probe->Stack(), sizeof create);
    EXPECT_EQ(create.error, ANT_NOMEMORY);
  });
}

TEST_F(IpStackTest, OperationsOnEndpointsThatNeverWereAreInvalid) {
  Do([&] {
    antModuleRef never = MakeModuleRef(EndpointType_UDP, 12345);
    probe->Send(UDPEndpointCloseMsg(never));
    antModuleRef dns = probe->NewEndpoint(EndpointType_DNS);
    antModuleRef other_type = MakeModuleRef(EndpointType_TCP, dns.index);
    probe->Send(TCPEndpointCloseMsg(other_type));
    antModuleRef null;
    probe->Send(TCPEndpointCloseMsg(null));
  });
  EXPECT_EQ(probe->replies, (Replies{"UDP Close 14", "TCP Close 17", "unknown operation 1"}));
}

TEST_F(IpStackTest, RawBytesSentToItsEntriesAreRefused) {
  Do([&] {
    char bytes[20] = {};
    ::Send(OID(probe->Stack().get_oid()), stack->EntryFor(2), bytes, sizeof bytes);
  });
  ASSERT_EQ(system.findings().all().size(), 1u);
  EXPECT_EQ(system.findings().all()[0].object, "probe");
}

TEST_F(IpStackTest, DoesNotPollWhenNothingWaits) {
  Do([&] { probe->NewEndpoint(EndpointType_TCP); });
  const uint64_t before = system.message_count();
  Frames(100);
  EXPECT_EQ(system.message_count(), before);
}

TEST_F(IpStackTest, StateHashFollowsEndpointsAndBufferedBytes) {
  antModuleRef endpoint;
  Do([&] {
    endpoint = probe->NewEndpoint(EndpointType_TCP);
    byte* const buffer = probe->NewBuffer(100);
    probe->Send(TCPEndpointListenMsg(endpoint, IP_ADDR_ANY, kPort));
    probe->on_reply = [this, endpoint, buffer](antEnvMsg*) mutable {
      probe->Send(TCPEndpointReceiveMsg(endpoint, buffer, 50, 100));
      probe->on_reply = {};
    };
  });
  const auto stack_hash = [&] {
    Hasher hasher;
    stack->HashState(&hasher);
    return hasher.Digest();
  };
  peer.Connect(kPort);
  Frames(2);
  const uint64_t before = stack_hash();
  EXPECT_EQ(stack_hash(), before);
  peer.Say("partial");
  Frames();
  EXPECT_NE(stack_hash(), before);
}

TEST_F(IpStackTest, SharedBufferSizesAreRoundedUpToPages) {
  Do([&] {
    antEnvCreateSharedBufferMsg create(4097);
    create.Call(probe->Stack(), sizeof create);
    EXPECT_EQ(create.buffer.GetSize(), 8192u);
    EXPECT_EQ(create.buffer.GetAddress(), nullptr);
    EXPECT_EQ(create.buffer.Map(), ANT_SUCCESS);
    EXPECT_NE(create.buffer.GetAddress(), nullptr);
    EXPECT_EQ(create.buffer.UnMap(), ANT_SUCCESS);
    EXPECT_EQ(create.buffer.GetAddress(), nullptr);
  });
}

TEST_F(IpStackTest, SharedBuffersThatCannotBeAreRefused) {
  Do([&] {
    antEnvCreateSharedBufferMsg none(0), huge(0xffffffff);
    none.Call(probe->Stack(), sizeof none);
    EXPECT_EQ(none.error, ANT_FAIL);
    huge.Call(probe->Stack(), sizeof huge);
    EXPECT_EQ(huge.error, ANT_NOMEMORY);
    antSharedBuffer never;
    EXPECT_EQ(never.Map(), ANT_INVALIDPTR);
    EXPECT_EQ(never.UnMap(), ANT_INVALIDPTR);
  });
}

TEST_F(IpStackTest, MappedBufferIsNotDestroyedAndNoBufferTwice) {
  Do([&] {
    probe->NewBuffer(10);
    antEnvDestroySharedBufferMsg destroy(probe->buffers[0]);
    destroy.Call(probe->Stack(), sizeof destroy);
    EXPECT_EQ(destroy.error, ANT_FAIL);
    probe->buffers[0].UnMap();
    destroy.Call(probe->Stack(), sizeof destroy);
    EXPECT_EQ(destroy.error, ANT_SUCCESS);
    destroy.Call(probe->Stack(), sizeof destroy);
    EXPECT_EQ(destroy.error, ANT_INVALIDPTR);
  });
}

TEST_F(IpStackTest, EtherIpIsReadAsText) {
  Do([&] {
    antEnvInitGetParamMsg get("ETHER_IP");
    EXPECT_EQ(get.Call(probe->Stack(), sizeof get), ANT_SUCCESS);
    EXPECT_EQ(get.error, ANT_SUCCESS);
    EXPECT_EQ(get.paramType, antEnv_InitParam_String);
    EXPECT_STREQ(get.value.str, "10.0.1.100");
    antEnvInitGetParamMsg channel("CHANNEL");
    channel.Call(probe->Stack(), sizeof channel);
    EXPECT_EQ(channel.paramType, antEnv_InitParam_Int32);
    EXPECT_EQ(channel.value.i32, 3);
    antEnvInitGetParamMsg unknown("NO_SUCH_KEY");
    unknown.Call(probe->Stack(), sizeof unknown);
    EXPECT_EQ(unknown.error, ANT_REGISTRY_NO_KEY);
  });
}

TEST_F(IpStackTest, OnlySystemObjectsSetParameters) {
  Do([&] {
    antEnvInitSetParamMsg set("ETHER_IP", "1.2.3.4");
    set.Call(probe->Stack(), sizeof set);
    EXPECT_EQ(set.error, ANT_FAIL);
    probe->host().set_system(true);
    set.Call(probe->Stack(), sizeof set);
    EXPECT_EQ(set.error, ANT_SUCCESS);
    antEnvInitGetParamMsg get("ETHER_IP");
    get.Call(probe->Stack(), sizeof get);
    EXPECT_STREQ(get.value.str, "1.2.3.4");
    probe->host().set_system(false);
  });
}

TEST_F(IpStackTest, CardAnswersWithTheSettingsOfTheRobot) {
  Do([&] {
    EtherDriverGetWLANSettingsMsg settings;
    EXPECT_EQ(ERA201D1_GetWLANSettings(&settings), ETHER_OK);
    EXPECT_STREQ(settings.essid, "AIBONET");
    EXPECT_STREQ(settings.stationName, "AIBO");
    EXPECT_EQ(settings.channel, 3);
    EtherDriverGetMACAddressMsg mac;
    EXPECT_EQ(ERA201D1_GetMACAddress(&mac), ETHER_OK);
    EXPECT_EQ(mac.address.octet[5], 1);
    EtherDriverGetStatisticsMsg ether;
    EXPECT_EQ(ERA201D1_GetEtherStatistics(&ether), ETHER_OK);
    EtherDriverGetWLANStatisticsMsg wlan;
    EXPECT_EQ(ERA201D1_GetWLANStatistics(&wlan), ETHER_OK);
    EXPECT_EQ(wlan.statistics.link, 100);
  });
}

TEST_F(IpStackTest, RobotWithoutANetworkHasNeitherStackNorCard) {
  System other;
  other.AddRobot("ERS-210", nullptr);
  auto* const lonely = other.AddObject<NetProbe>(0, "lonely");
  bool done = false;
  lonely->Do([&] {
    EXPECT_FALSE(antStackRef("IPStack").IsValid());
    EtherDriverGetMACAddressMsg mac;
    EXPECT_EQ(ERA201D1_GetMACAddress(&mac), ETHER_INVALID_PORT);
    EXPECT_EQ(mac.status, ETHER_INVALID_PORT);
    done = true;
  });
  other.RunFor(1);
  EXPECT_TRUE(done);
}

TEST_F(IpStackTest, CardWithoutADriverIsUnsupported) {
  System other;
  other.AddRobot("ERS-210", nullptr);
  AddIpStack(&other, 0, std::make_unique<LoopbackNetwork>(),
             {.address = "", .card = IpStackOptions::Card::kNoDriver});
  auto* const user = other.AddObject<NetProbe>(0, "user");
  EtherDriverGetMACAddressMsg mac;
  user->Do([&] { ERA201D1_GetMACAddress(&mac); });
  other.RunFor(1);
  EXPECT_EQ(mac.status, ETHER_UNSUPPORTED);
}

}  // namespace
}  // namespace openr_host
