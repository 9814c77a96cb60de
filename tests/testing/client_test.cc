// Scripted clients on the bench's own network.
#include "tests/runtime/ipstack/echo_server.h"
#include "tests/testing/doubler.h"

namespace openr::testing {
namespace {

class ClientTest : public ::testing::Test {
 protected:
  ClientTest() {
    server_ = &bench.Add<openr_host::EchoServer>("server", openr_host::kPort, 2);
    bench.Boot();
  }
  Bench bench;
  openr_host::EchoServer* server_;
};

TEST_F(ClientTest, AScriptIsPlayedToItsEnd) {
  TcpClient& client = bench.AddClient();
  client.Connect(openr_host::kPort).Send("PING").Hear("PING").Send("again").HearBytes(5).Close();
  EXPECT_TRUE(bench.RunUntil([&] { return client.done(); }, 1s));
  EXPECT_EQ(client.heard(), "PINGagain");
  EXPECT_FALSE(client.connected());
}

TEST_F(ClientTest, TwoClientsAtATime) {
  TcpClient& a = bench.AddClient();
  TcpClient& b = bench.AddClient();
  a.Connect(openr_host::kPort).Send("from a").Hear("from a");
  b.Connect(openr_host::kPort).Send("from b").Hear("from b");
  bench.RunFor(200ms);
  EXPECT_TRUE(a.done());
  EXPECT_TRUE(b.done());
}

TEST_F(ClientTest, ItWaitsUntilSomebodyListens) {
  TcpClient& a = bench.AddClient();
  a.Connect(1234);
  bench.RunFor(1s);
  EXPECT_FALSE(a.connected());
  EXPECT_EQ(a.WaitsFor(), "for somebody to listen on port 1234");
  EXPECT_NONFATAL_FAILURE(bench.Verify(),
                          "client1 still waits for somebody to listen on port 1234\n");
}

TEST_F(ClientTest, AnUnfinishedScriptFailsTheTest) {
  TcpClient& client = bench.AddClient();
  client.Connect(openr_host::kPort).Send("PING").Hear("PONG");
  bench.RunFor(1s);
  EXPECT_NONFATAL_FAILURE(bench.Verify(),
                          "client1 still waits to hear \"PONG\", has heard \"PING\"\n");
}

TEST_F(ClientTest, AClientMayDisappear) {
  TcpClient& client = bench.AddClient();
  client.Connect(openr_host::kPort).Send("x").Hear("x").Reset();
  bench.RunFor(1s);
  client.Connect(openr_host::kPort).Send("y").Hear("y").Close();
  bench.RunFor(1s);
  EXPECT_TRUE(client.done());
}

TEST_F(ClientTest, SlicingChangesNothing) {
  const auto run = [](int slices) {
    Bench bench;
    bench.Add<openr_host::EchoServer>("server", openr_host::kPort, 1);
    bench.AddClient().Connect(openr_host::kPort).Send("PING").Hear("PING").Close();
    bench.Boot();
    for (int i = 0; i < slices; ++i) bench.RunFor(Duration(200'000 / slices));
    return std::pair(bench.trace_hash(), bench.state_hash());
  };
  EXPECT_EQ(run(1), run(100));
}

}  // namespace
}  // namespace openr::testing
