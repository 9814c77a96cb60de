// A TCP endpoint: one connection, from Listen or Connect to Close.
#pragma once

#include <TCPEndpointMsg.h>

#include <cstdint>
#include <optional>
#include <string>

#include "runtime/ipstack/endpoint.h"

namespace openr_host {

class TcpEndpoint : public Endpoint {
 public:
  TcpEndpoint(IpStack* stack, ObjectId owner, int32_t pool_bytes);

  // The largest virtual time that Close waits for the peer to end its side, after all bytes were
  // sent.  Our choice: a peer that keeps its side open delays the program by 1 s only.
  static constexpr int64_t kPeerEndUs = 1'000'000;
  // The largest virtual time that Close waits, while bytes are still to be sent, for a peer that
  // does not read them.  The time starts again with each byte that the peer accepts.  Our choice.
  static constexpr int64_t kUnsentUs = 60'000'000;

  // The number of bytes that the endpoint reads from the network at a time, even if a Receive asks
  // for fewer bytes.  A program often receives the header of a message and then its body.  Because
  // the endpoint reads ahead, it has usually read the body already.  Otherwise header and body
  // would take a frame (8 ms) each.
  static constexpr size_t kReadAheadBytes = 16384;

  // Limits of the two kinds of Send that are slow on the robot and cause a warning.  If a Send has
  // more than kRobotFastBytes and at most kRobotSplitBytes, the robot sends two pieces, the second
  // piece up to 200 ms after the first (network.md, 4.3).  A Send of more than kRobotSendBytes is
  // slow, too (BBS 254, a message of Sony's developer board).
  static constexpr int kRobotFastBytes = 1024;
  static constexpr int kRobotSplitBytes = 3072;
  static constexpr int kRobotSendBytes = 32 * 1024;
  // A small send has at most kRobotSmallBytes.  This limit is our choice: two small sends together
  // still fit into the kRobotFastBytes that the robot sends at once.  On the robot Nagle's
  // algorithm holds a small send back until the peer has acknowledged the previous send, and the
  // peer may delay its acknowledgement by kRobotAcknowledgeUs.  So kRobotRow small sends in a row
  // cause a warning.  A send continues the row if it comes within kRobotAcknowledgeUs after the
  // previous send and the program has received nothing in between.
  static constexpr int kRobotSmallBytes = kRobotFastBytes / 2;
  static constexpr int kRobotRow = 3;
  static constexpr int64_t kRobotAcknowledgeUs = 200'000;

  void Start(const Operation& operation) override;
  void StoreEvent(const NetworkEvent& event) override;
  void AnswerReady() override;
  bool WaitsForNetwork() const override;
  void Drop() override;
  void HashState(Hasher* hasher) const override;

 private:
  enum class State : uint8_t { kNew, kListening, kConnecting, kActive, kClosing, kFailed };

  void Bind(Operation operation);
  void Listen(const Operation& operation);
  void Connect(const Operation& operation);
  void Send(const Operation& operation);
  void WarnOfRobotTiming(const Operation& operation, int size);
  void WarnOfSmallSends(const Operation& operation, int size);
  void Receive(const Operation& operation);
  void Close(const Operation& operation);
  void Address(Operation operation);

  bool RefuseOpen(const Operation& operation, const IPAddress& local);
  bool RefuseTransfer(const Operation& operation, bool busy);
  void Refuse(Operation operation, TCPEndpointError error);
  void Fail(NetError error);
  void Accepted(const NetworkEvent& event);
  void LeavePort();
  void FinishOpening();
  void FinishSend();
  void FinishReceive();
  void FinishClose();
  // Answers the pending `operation`, a message of the program, with `error` and removes the
  // operation.  `data` are the transferred bytes.
  void Finish(std::optional<Operation>* operation, TCPEndpointError error,
              const void* data = nullptr, size_t size = 0);

  State state_ = State::kNew;
  NetHandle socket_ = 0;
  uint32_t local_ip_ = 0;  // the local address that the program gave; 0 if it gave none
  uint16_t local_port_ = 0;
  bool stack_chose_port_ = false;  // true if the stack has chosen local_port_ for a Listen
  NetAddress remote_;
  NetAddress wanted_;  // the only peer that a Listen accepts; 0 if it accepts any peer
  TCPEndpointError error_ = TCP_SUCCESS;  // the error that broke the connection

  std::string in_;       // received bytes that no Receive has taken yet
  bool asked_ = false;   // whether a Network::Receive() waits for its answer
  bool ended_ = false;   // whether the peer has ended the stream
  bool closed_ = false;  // whether both sides have ended the stream
  int64_t unsent_ = 0;   // number of bytes that were given to the network and are not accepted yet
  uint64_t sent_hash_ = 0;  // hash of all bytes that were sent
  int small_row_ = 0;       // number of small sends since the object last received something
  int64_t last_send_us_ = 0;
  int64_t closing_since_us_ = 0;  // time of Close, or when the peer last accepted a byte after it

  std::optional<Operation> opening_;  // the pending Listen or Connect
  std::optional<Operation> send_;
  std::optional<Operation> receive_;
  std::optional<Operation> close_;
};

TCPEndpointError TcpErrorOf(NetError error);

}  // namespace openr_host
