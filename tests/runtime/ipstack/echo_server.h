// A server and a client in the style of programs for the robot: they use only Send(), with one
// entry for each kind of answer.
#pragma once

#include <string>
#include <vector>

#include "tests/runtime/ipstack/net_probe.h"

namespace openr_host {

// Sends received bytes back on each of its connections; listens again after each connection.
class EchoServer : public CodeObject {
 public:
  EchoServer(uint16_t port, int connections) : port_(port), connections_(connections) {
    listen_ = AddExtra("ListenCont", [this](void* m) { ListenCont(m); });
    receive_ = AddExtra("ReceiveCont", [this](void* m) { ReceiveCont(m); });
    send_ = AddExtra("SendCont", [this](void* m) { SendCont(m); });
    close_ = AddExtra("CloseCont", [this](void* m) { CloseCont(m); });
  }

  OStatus DoStart(const OSystemEvent&) override {
    for (uintptr_t i = 0; i < connections_.size(); ++i) {
      antEnvCreateSharedBufferMsg create(kBytes);
      create.Call(antStackRef("IPStack"), sizeof create);
      create.buffer.Map();
      connections_[i].buffer = static_cast<byte*>(create.buffer.GetAddress());
      Listen(reinterpret_cast<void*>(i));
    }
    return oSUCCESS;
  }

  std::vector<int> accepted_by;  // index of each connection that was accepted, in order

 private:
  static constexpr int kBytes = 512;

  struct Connection {
    antModuleRef endpoint;
    byte* buffer = nullptr;
  };

  Connection& Of(const antEnvMsg& message) {
    return connections_[reinterpret_cast<uintptr_t>(message.continuation)];
  }
  template <typename M>
  void Post(M message, void* continuation, Selector entry) {
    message.continuation = continuation;
    message.Send(antStackRef("IPStack"), myOID_, static_cast<int32>(entry), sizeof message);
  }

  void Listen(void* continuation) {
    Connection& connection = connections_[reinterpret_cast<uintptr_t>(continuation)];
    antEnvCreateEndpointMsg create(EndpointType_TCP, 2 * kBytes);
    create.Call(antStackRef("IPStack"), sizeof create);
    connection.endpoint = create.moduleRef;
    Post(TCPEndpointListenMsg(connection.endpoint, IP_ADDR_ANY, port_), continuation, listen_);
  }
  void ListenCont(void* m) {
    auto& message = *static_cast<TCPEndpointListenMsg*>(antEnvMsg::Receive(m));
    if (message.error != TCP_SUCCESS) return Close(message);
    accepted_by.push_back(static_cast<int>(reinterpret_cast<uintptr_t>(message.continuation)));
    Receive(message);
  }
  void Receive(const antEnvMsg& message) {
    Connection& connection = Of(message);
    Post(TCPEndpointReceiveMsg(connection.endpoint, connection.buffer, 1, kBytes),
         message.continuation, receive_);
  }
  void ReceiveCont(void* m) {
    auto& message = *static_cast<TCPEndpointReceiveMsg*>(antEnvMsg::Receive(m));
    if (message.error != TCP_SUCCESS) return Close(message);
    Connection& connection = Of(message);
    Post(TCPEndpointSendMsg(connection.endpoint, connection.buffer, message.sizeMin),
         message.continuation, send_);
  }
  void SendCont(void* m) {
    auto& message = *static_cast<TCPEndpointSendMsg*>(antEnvMsg::Receive(m));
    if (message.error != TCP_SUCCESS) return Close(message);
    Receive(message);
  }
  void Close(const antEnvMsg& message) {
    Post(TCPEndpointCloseMsg(Of(message).endpoint), message.continuation, close_);
  }
  void CloseCont(void* m) { Listen(static_cast<antEnvMsg*>(m)->continuation); }

  const uint16_t port_;
  std::vector<Connection> connections_;
  Selector listen_, receive_, send_, close_;
};

// Connects to `server`, sends one line and receives it back `rounds` times, then closes.
class EchoClient : public CodeObject {
 public:
  EchoClient(uint32_t server, uint16_t port, int rounds)
      : server_(server), port_(port), rounds_(rounds) {
    done_ = AddExtra("Cont", [this](void* m) { Cont(antEnvMsg::Receive(m)); });
  }

  OStatus DoStart(const OSystemEvent&) override {
    antEnvCreateSharedBufferMsg create(sizeof kLine);
    create.Call(antStackRef("IPStack"), sizeof create);
    create.buffer.Map();
    buffer_ = static_cast<byte*>(create.buffer.GetAddress());
    std::memcpy(buffer_, kLine, sizeof kLine);
    antEnvCreateEndpointMsg endpoint(EndpointType_TCP, 1024);
    endpoint.Call(antStackRef("IPStack"), sizeof endpoint);
    endpoint_ = endpoint.moduleRef;
    Post(TCPEndpointConnectMsg(endpoint_, IP_ADDR_ANY, IP_PORT_ANY, server_, port_));
    return oSUCCESS;
  }

  int bounced = 0;
  bool closed = false;

 private:
  static constexpr char kLine[] = "The quick brown fox";

  template <typename M>
  void Post(M message) {
    message.Send(antStackRef("IPStack"), myOID_, static_cast<int32>(done_), sizeof message);
  }
  void Cont(antEnvMsg* message) {
    EXPECT_EQ(static_cast<TCPEndpointBaseMsg*>(message)->error, TCP_SUCCESS);
    switch (message->GetOperation()) {
      case TCPEndpoint_Operation_Send:
        return Post(TCPEndpointReceiveMsg(endpoint_, buffer_, sizeof kLine, sizeof kLine));
      case TCPEndpoint_Operation_Close:
        closed = true;
        return;
      case TCPEndpoint_Operation_Receive:
        EXPECT_STREQ(reinterpret_cast<char*>(buffer_), kLine);
        if (++bounced == rounds_) return Post(TCPEndpointCloseMsg(endpoint_));
        break;
      default:
        break;
    }
    Post(TCPEndpointSendMsg(endpoint_, buffer_, sizeof kLine));
  }

  const uint32_t server_;
  const uint16_t port_;
  const int rounds_;
  antModuleRef endpoint_;
  byte* buffer_ = nullptr;
  Selector done_;
};

}  // namespace openr_host
