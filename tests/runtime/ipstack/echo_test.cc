// Tests of whole conversations between an echo server and clients, in and outside of the robot.
#include "tests/runtime/ipstack/echo_server.h"

namespace openr_host {
namespace {

class EchoTest : public testing::Test {
 protected:
  void Start(int connections) {
    system.AddRobot("ERS-210", nullptr);
    stack = AddIpStack(&system, 0, std::make_unique<LoopbackNetwork>(hub));
    server = system.AddObject<EchoServer>(0, "server", kPort, connections);
    system.Boot();
    system.RunFor(1000);
  }
  void Frames(int count, std::initializer_list<Peer*> peers) {
    for (int i = 0; i < count; ++i) {
      system.RunFor(kFrameUs);
      for (Peer* peer : peers) peer->Poll();
    }
  }

  std::shared_ptr<LoopbackHub> hub = std::make_shared<LoopbackHub>();
  System system;
  IpStack* stack = nullptr;
  EchoServer* server = nullptr;
};

TEST_F(EchoTest, TwoClientsOneAfterTheOther) {
  Start(1);
  Peer a(hub);
  for (const char* text : {"first", "second"}) {
    a.heard.clear();
    a.Connect(kPort);
    a.Say(text);
    Frames(5, {&a});
    EXPECT_EQ(a.heard, text);
    a.net.Close(a.handle);
    Frames(5, {&a});
  }
  EXPECT_EQ(server->accepted_by, (std::vector<int>{0, 0}));
}

TEST_F(EchoTest, ClientThatComesWhileNobodyListensWaitsForTheNextListen) {
  Start(1);
  Peer a(hub), b(hub, 0x0a000103);
  a.Connect(kPort);
  Frames(2, {&a, &b});
  b.Connect(kPort);
  b.Say("patience");
  Frames(20, {&a, &b});
  EXPECT_TRUE(b.connected);
  EXPECT_EQ(b.heard, "");
  a.net.Drop(a.handle, true);  // a client that disappears
  Frames(5, {&b});
  EXPECT_EQ(b.heard, "patience");
}

TEST_F(EchoTest, SeveralEndpointsOnOnePortServeAsManyClientsInOrderOfListening) {
  Start(3);
  Peer a(hub), b(hub, 0x0a000103), c(hub, 0x0a000104);
  for (Peer* peer : {&a, &b, &c}) {
    peer->Connect(kPort);
    Frames(2, {peer});
  }
  a.Say("from a");
  b.Say("from b");
  c.Say("from c");
  Frames(5, {&a, &b, &c});
  EXPECT_EQ(a.heard + b.heard + c.heard, "from afrom bfrom c");
  EXPECT_EQ(server->accepted_by, (std::vector<int>{0, 1, 2}));
}

TEST_F(EchoTest, ArbitraryFragmentsComeBackInOrder) {
  Start(1);
  Peer a(hub);
  a.Connect(kPort);
  std::string all;
  uint32_t random = 1;
  for (int i = 0; i < 200; ++i) {
    random = random * 1664525 + 1013904223;
    const std::string piece(random >> 22, static_cast<char>('a' + i % 26));  // 0..1023 bytes
    a.Say(piece);
    all += piece;
    Frames(static_cast<int>(random >> 8 & 3), {&a});
  }
  Frames(1000, {&a});
  EXPECT_EQ(a.heard, all);
}

// The hashes of a run in which two clients on the robot have talked to a server.
struct Hashes {
  uint64_t trace;
  uint64_t state;
  bool operator==(const Hashes&) const = default;
};

Hashes RunInside(int64_t slice_us, size_t shift = 0) {
  const std::string elsewhere(shift, 'x');  // shifts the addresses of later allocations
  System system;
  system.AddRobot("ERS-210", nullptr);
  AddIpStack(&system, 0, std::make_unique<LoopbackNetwork>());
  system.AddObject<EchoServer>(0, "server", kPort, 2);
  auto* const a = system.AddObject<EchoClient>(0, "a", kRobotIp, kPort, 20);
  auto* const b = system.AddObject<EchoClient>(0, "b", 0x7f000001, kPort, 30);
  system.Boot();
  while (system.now_us() < 1'200'000) system.RunFor(slice_us);
  EXPECT_EQ(a->bounced, 20);
  EXPECT_EQ(b->bounced, 30);
  EXPECT_TRUE(a->closed && b->closed);
  return {system.trace_hash(), system.state_hash()};
}

TEST(EchoDeterminismTest, ObjectsTalkInsideTheRobotWithoutHostSockets) { RunInside(8000); }

TEST(EchoDeterminismTest, RunsAreEqualHoweverTheyAreSliced) {
  const Hashes whole = RunInside(1'200'000);
  EXPECT_EQ(RunInside(8000), whole);
  EXPECT_EQ(RunInside(1000), whole);
}

TEST(EchoDeterminismTest, AddressesDoNotShow) {
  EXPECT_EQ(RunInside(8000, 0), RunInside(8000, 1 << 20));
}

TEST(EchoDeterminismTest, TwoRobotsTalkOverOneWire) {
  auto hub = std::make_shared<LoopbackHub>();
  System system;
  for (const char* address : {"10.0.1.100", "10.0.1.101"}) {
    const int robot = system.AddRobot("ERS-210", nullptr);
    AddIpStack(&system, robot, std::make_unique<LoopbackNetwork>(hub),
               {.address = address, .card = {}});
  }
  system.AddObject<EchoServer>(0, "server", kPort, 1);
  auto* const client = system.AddObject<EchoClient>(1, "client", kRobotIp, kPort, 3);
  system.Boot();
  system.RunFor(1'000'000);
  EXPECT_EQ(client->bounced, 3);
}

}  // namespace
}  // namespace openr_host
