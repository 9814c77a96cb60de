// network.md and field-notes.md section 11: mistakes with the network stack that the robot does
// not report.  What the stack answers is in tests/runtime/ipstack.
#include "tests/runtime/ipstack/net_probe.h"

namespace openr_host {
namespace {

class NetworkConformance : public ConnectedTest {
 protected:
  bool Found(const std::string& part) {
    for (const Finding& finding : system.findings().all()) {
      if (finding.text.find(part) != std::string::npos) return finding.object == "probe";
    }
    return false;
  }
};

// field-notes.md, 11.2: the buffer belongs to the stack until the answer
TEST_F(NetworkConformance, ABufferWrittenWhileItsSendIsUnderWayIsReported) {
  Do([&] {
    std::memcpy(buffer, "good", 4);
    probe->Send(TCPEndpointSendMsg(endpoint, buffer, 4));
    std::memcpy(buffer, "evil", 4);
  });
  EXPECT_TRUE(Found("TCP Send: the buffer was written between Send() and its answer"));
  Frames();
  EXPECT_EQ(peer.heard, "evil");  // as on the robot, perhaps
}

TEST_F(NetworkConformance, ABufferWrittenWhileThePoolIsFullIsReported) {
  StopPeerReading();
  Send(std::string(4096, 'a'));
  Send("later");
  Do([&] { std::memcpy(buffer + 4096, "LATER", 5); });
  EXPECT_FALSE(Found("was written between"));
  peer.reading = true;
  Frames(4);
  EXPECT_TRUE(Found("was written between"));
}

TEST_F(NetworkConformance, ABufferWrittenAfterTheAnswerIsNot) {
  Send("first");
  Send("second");
  Frames();
  EXPECT_FALSE(Found("was written between"));
}

// network.md, 4.3; field-notes.md, 11.4: 1024 bytes go at once, the rest 200 ms later
TEST_F(NetworkConformance, ASendThatTheRobotSplitsIsReported) {
  Send(std::string(1024, 'a'));
  Frames();
  Send(std::string(3073, 'a'));
  Frames();
  EXPECT_FALSE(Found("the robot sends 1024 at once"));
  Send(std::string(1025, 'a'));
  EXPECT_TRUE(
      Found("TCP Send of 1025 to 3072 bytes: the robot sends 1024 at once and the rest up "
            "to 200 ms later"));
}

// network.md, 4.3: no option switches Nagle's algorithm off
TEST_F(NetworkConformance, SmallSendsThatTheRobotHoldsBackAreReported) {
  for (int i = 0; i < 3; ++i) {
    Send("question");
    Frames();
    peer.Say("answer");
    Receive(1, 6);
    Frames(2);
    TakeReplies();
  }
  Send("one");
  Frames();
  Send("two");
  Frames(26);  // 208 ms
  Send("three");
  EXPECT_FALSE(Found("Nagle"));
  Frames();
  Send("four");
  Frames();
  Send("five");
  EXPECT_TRUE(Found("3 small TCP Sends in a row with nothing received in between"));
}

// Each fills most of what the robot sends at once: joining them would gain nothing.
TEST_F(NetworkConformance, SendsThatAreNearlyFullAreNotSmall) {
  for (int i = 0; i < 5; ++i) {
    Send(std::string(769, 'a'));
    Frames();
  }
  EXPECT_FALSE(Found("Nagle"));
}

// network.md, 4.3; field-notes.md, 11.5
TEST_F(NetworkConformance, ASendTooLargeForTheRobotIsReported) {
  Do([&] { probe->Send(TCPEndpointCloseMsg(endpoint)); });
  Frames(4);
  TakeReplies();
  Accept(100'000);
  byte* data = nullptr;
  Do([&] { data = probe->NewBuffer(40'000); });
  Do([&] { probe->Send(TCPEndpointSendMsg(endpoint, data, 32'768)); });
  Frames(4);
  EXPECT_FALSE(Found("slow and often failing"));
  Do([&] { probe->Send(TCPEndpointSendMsg(endpoint, data, 32'769)); });
  EXPECT_TRUE(Found("TCP Send of more than 32768 bytes"));
}

// field-notes.md, 11.7
TEST_F(NetworkConformance, ASecondUdpSendInOneHandlerIsNoted) {
  antModuleRef udp, other;
  byte* data = nullptr;
  Do([&] {
    for (antModuleRef* ref : {&udp, &other}) {
      *ref = probe->NewEndpoint(EndpointType_UDP);
      probe->Send(UDPEndpointBindMsg(*ref, IP_ADDR_ANY, IP_PORT_ANY));
    }
    data = probe->NewBuffer(100);
  });
  const auto send = [&](antModuleRef& ref) {
    probe->Send(UDPEndpointSendMsg(ref, kClientIp, 9999, data, 10));
  };
  // Each after the answer to the one before, two endpoints, and a Call(), which waits.
  Do([&] { send(udp); });
  Do([&] {
    send(udp);
    send(other);
  });
  Do([&] {
    for (int i = 0; i < 2; ++i) {
      UDPEndpointSendMsg call(udp, kClientIp, 9999, data, 10);
      call.Call(probe->Stack(), sizeof call);
    }
  });
  EXPECT_FALSE(Found("before the answer to the last one"));
  Do([&] {
    send(udp);
    send(udp);
  });
  EXPECT_TRUE(
      Found("UDP Send before the answer to the last one: on the robot it may fail with "
            "UDP_CONNECTION_BUSY"));
  EXPECT_FALSE(system.findings().HasError());
}

// network.md, 5; field-notes.md, 11.7
TEST_F(NetworkConformance, ADatagramThatCrashedTheRobotsStackIsReported) {
  Do([&] {
    antModuleRef udp = probe->NewEndpoint(EndpointType_UDP, 100'000);
    byte* const data = probe->NewBuffer(20'000);
    probe->Send(UDPEndpointBindMsg(udp, IP_ADDR_ANY, IP_PORT_ANY));
    probe->Send(UDPEndpointSendMsg(udp, kClientIp, 9999, data, 18'500));
  });
  EXPECT_FALSE(Found("IPStack crashed"));
  Do([&] {
    antModuleRef udp = probe->NewEndpoint(EndpointType_UDP, 100'000);
    byte* const data = probe->NewBuffer(20'000);
    probe->Send(UDPEndpointBindMsg(udp, IP_ADDR_ANY, IP_PORT_ANY));
    probe->Send(UDPEndpointSendMsg(udp, kClientIp, 9999, data, 18'501));
  });
  EXPECT_TRUE(Found("a UDP datagram of more than 18500 bytes is sent"));
}

}  // namespace
}  // namespace openr_host
