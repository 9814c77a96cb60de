// Probe objects for the network stack, a peer outside of the robot, and a fixture with both at one
// LoopbackHub.
#pragma once

#include <EndpointTypes.h>
#include <TCPEndpointMsg.h>
#include <UDPEndpointMsg.h>
#include <ant.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cstring>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "runtime/core/code_object.h"
#include "runtime/core/system.h"
#include "runtime/ipstack/ant_message.h"
#include "runtime/ipstack/ip_stack.h"
#include "runtime/ipstack/loopback_network.h"

namespace openr_host {

constexpr uint32_t kRobotIp = 0x0a000164;   // 10.0.1.100, the default of WLANCONF.TXT
constexpr uint32_t kClientIp = 0x0a000102;  // 10.0.1.2
constexpr uint16_t kPort = 54321;

// An object that uses the stack: code given to Do() runs in its handlers, and answers to Send() are
// recorded.
class NetProbe : public CodeObject {
 public:
  NetProbe() {
    do_ = AddExtra("Do", [this](void*) {
      const std::function<void()> body = std::move(todo_.front());
      todo_.pop_front();
      body();
    });
    reply_ = AddExtra("Reply", [this](void* payload) {
      antEnvMsg* const message = antEnvMsg::Receive(payload);
      EXPECT_EQ(static_cast<void*>(message), payload);
      const std::string text = Describe(*message);
      replies.push_back(text);
      reply_times_us.push_back(system().now_us());
      if (on_reply) on_reply(message);
    });
  }

  OStatus DoInit(const OSystemEvent&) override {
    if (on_init) on_init();
    return oSUCCESS;
  }
  OStatus DoStop(const OSystemEvent&) override {
    if (on_stop) on_stop();
    return oSUCCESS;
  }

  // Lets `body` run in a handler as soon as the system runs.
  void Do(std::function<void()> body) {
    todo_.push_back(std::move(body));
    system().Post(system().NewMessage(host().id, do_));
  }

  // ---- in handlers

  antStackRef Stack() { return antStackRef("IPStack"); }

  template <typename M>
  antError Send(M message) {
    return message.Send(Stack(), myOID_, static_cast<int32>(reply_), sizeof message);
  }

  antModuleRef NewEndpoint(int32 protocol, int32 pool = 4096) {
    antEnvCreateEndpointMsg create(protocol, pool);
    EXPECT_EQ(create.Call(Stack(), sizeof create), ANT_SUCCESS);
    EXPECT_EQ(create.error, ANT_SUCCESS);
    return create.moduleRef;
  }

  // Makes a mapped buffer; returns its address.
  byte* NewBuffer(uint32 size) {
    antEnvCreateSharedBufferMsg create(size);
    EXPECT_EQ(create.Call(Stack(), sizeof create), ANT_SUCCESS);
    EXPECT_EQ(create.error, ANT_SUCCESS);
    EXPECT_EQ(create.buffer.Map(), ANT_SUCCESS);
    buffers.push_back(create.buffer);
    return static_cast<byte*>(create.buffer.GetAddress());
  }

  // Returns a text such as "TCP Receive 0 'abc'": name, error, and the received bytes.
  static std::string Describe(const antEnvMsg& message) {
    const std::string name = AntMessageName(message);
    const auto& any = static_cast<const antOperationMsg<antError>&>(message);
    std::string text = fmt::format("{} {}", name, static_cast<int>(any.error));
    if (name == "TCP Receive") {
      const auto& receive = static_cast<const TCPEndpointReceiveMsg&>(message);
      EXPECT_EQ(receive.sizeMin, receive.sizeMax);
      text += fmt::format(" '{}'", std::string(reinterpret_cast<const char*>(receive.buffer),
                                               static_cast<size_t>(receive.sizeMax)));
    } else if (name == "UDP Receive" && any.error == ANT_SUCCESS) {
      const auto& receive = static_cast<const UDPEndpointReceiveMsg&>(message);
      text += fmt::format(" '{}'", std::string(reinterpret_cast<const char*>(receive.buffer),
                                               static_cast<size_t>(receive.size)));
    }
    return text;
  }

  OID oid() const { return myOID_; }
  Selector reply_selector() const { return reply_; }

  std::vector<std::string> replies;
  std::vector<int64_t> reply_times_us;
  std::function<void(antEnvMsg*)> on_reply;
  std::function<void()> on_init;
  std::function<void()> on_stop;
  std::vector<antSharedBuffer> buffers;

 private:
  Selector do_ = 0;
  Selector reply_ = 0;
  std::deque<std::function<void()>> todo_;
};

// A program on another computer, with one TCP connection and one UDP port.
class Peer {
 public:
  static constexpr NetHandle kListener = 1, kUdp = 2;

  explicit Peer(std::shared_ptr<LoopbackHub> hub, uint32_t ip = kClientIp) : net(std::move(hub)) {
    net.Attach(ip);
  }

  void Connect(uint16_t port, uint16_t local_port = 40000) {
    net.Connect(++handle, local_port, {kRobotIp, port});
  }
  void Say(const std::string& text) { net.Send(handle, text.data(), text.size()); }

  // Handles all events of the network.
  void Poll() {
    if (reading) net.Receive(handle, 1 << 20);
    for (const NetworkEvent& event : net.Poll()) {
      using Kind = NetworkEvent::Kind;
      if (event.kind == Kind::kDatagram) datagrams.push_back(event);
      if (event.handle != handle) continue;
      if (event.kind == Kind::kConnected || event.kind == Kind::kAccepted) connected = true;
      if (event.kind == Kind::kReceived) heard += event.bytes;
      if (event.kind == Kind::kEnd) ended = true;
      if (event.kind == Kind::kFailed) error = event.error;
    }
  }

  LoopbackNetwork net;
  NetHandle handle = 10;  // handle of the connection
  bool reading = true;
  bool connected = false;
  bool ended = false;
  NetError error = NetError::kNone;
  std::string heard;
  std::vector<NetworkEvent> datagrams;
};

class NetTest : public testing::Test {
 protected:
  NetTest() : peer(hub) {
    system.AddRobot("ERS-210", nullptr);
    stack = AddIpStack(&system, 0, std::make_unique<LoopbackNetwork>(hub));
    probe = system.AddObject<NetProbe>(0, "probe");
    system.Boot();
    system.RunFor(1000);
  }

  // Runs `body` in a handler of the probe at once.
  void Do(std::function<void()> body) {
    probe->Do(std::move(body));
    system.RunFor(1);
  }

  // Runs to the next frame boundary and polls the peer, `count` times.
  void Frames(int count = 1) {
    for (int i = 0; i < count; ++i) {
      system.RunUntil((system.now_us() / kFrameUs + 1) * kFrameUs);
      peer.Poll();
    }
  }

  std::vector<std::string> TakeReplies() { return std::exchange(probe->replies, {}); }

  std::shared_ptr<LoopbackHub> hub = std::make_shared<LoopbackHub>();
  System system;
  Peer peer;
  IpStack* stack;
  NetProbe* probe;
};

// An endpoint with a connection to the peer, and a buffer of 8192 bytes.
class ConnectedTest : public NetTest {
 protected:
  ConnectedTest() { Accept(4096); }

  void Accept(int32 pool) {
    Do([this, pool] {
      endpoint = probe->NewEndpoint(EndpointType_TCP, pool);
      buffer = probe->NewBuffer(8192);
      probe->Send(TCPEndpointListenMsg(endpoint, IP_ADDR_ANY, kPort));
    });
    peer.Connect(kPort);
    Frames(2);
    EXPECT_EQ(TakeReplies(), std::vector<std::string>{"TCP Listen 0"});
    EXPECT_TRUE(peer.connected);
  }

  void Receive(int min, int max) {
    Do([=, this] { probe->Send(TCPEndpointReceiveMsg(endpoint, buffer, min, max)); });
  }
  void Send(const std::string& text) {
    Do([=, this] {
      std::memcpy(buffer + 4096, text.data(), text.size());
      probe->Send(TCPEndpointSendMsg(endpoint, buffer + 4096, static_cast<int>(text.size())));
    });
  }
  // Answers the pending Receive() of the peer with one byte, so that it reads no more.
  void StopPeerReading() {
    peer.reading = false;
    Send("x");
    Frames();
    TakeReplies();
  }
  void Close(bool abort = false) {
    Do([=, this] { probe->Send(TCPEndpointCloseMsg(endpoint, false, 0, abort)); });
  }

  antModuleRef endpoint;
  byte* buffer = nullptr;
};

using Replies = std::vector<std::string>;

}  // namespace openr_host
