// A UDP endpoint: one port that exchanges datagrams with one peer or with all peers.
#pragma once

#include <UDPEndpointMsg.h>

#include <cstdint>
#include <deque>
#include <optional>

#include "runtime/ipstack/endpoint.h"

namespace openr_host {

class UdpEndpoint : public Endpoint {
 public:
  UdpEndpoint(IpStack* stack, ObjectId owner, int32_t pool_bytes);

  // The size of the largest datagram that the robot survives; a larger datagram crashes the robot
  // (field-notes.md, 11.7).
  static constexpr int kRobotDatagramMax = 18'500;
  static constexpr int kDatagramMax = 65507;  // bytes of data in the largest IPv4 packet
  static constexpr size_t kReadAhead = 16;    // number of datagrams read at a time

  void Start(const Operation& operation) override;
  void StoreEvent(const NetworkEvent& event) override;
  void AnswerReady() override;
  bool WaitsForNetwork() const override;
  void BeginFrame() override { sent_in_frame_ = 0; }
  void Drop() override;
  void HashState(Hasher* hasher) const override;

 private:
  void Bind(Operation operation);
  void Connect(Operation operation);
  void ResetConnect(Operation operation);
  void Send(const Operation& operation);
  void Receive(const Operation& operation);
  void Close(Operation operation);
  void Address(Operation operation);

  // Returns the address to which a Send goes.  Its ip is 0 if the Send has no valid destination;
  // such a Send is refused.
  NetAddress DestinationOf(const UDPEndpointSendMsg& message) const;
  bool RefuseTransfer(const Operation& operation, bool busy, const byte* buffer, int size);
  void NoteSecondSend(const Operation& operation);
  void Refuse(Operation operation, UDPEndpointError error);
  void FinishSend();
  bool IsFromPeer(const NetAddress& sender) const;
  bool DropFromOtherSenders();
  void FinishReceive();
  void Finish(std::optional<Operation>* operation, UDPEndpointError error,
              const void* data = nullptr, size_t size = 0);

  NetHandle socket_ = 0;   // handle of the bound socket; 0 if no socket is bound
  uint32_t local_ip_ = 0;  // the address that the program gave; 0 for any address
  uint16_t port_ = 0;
  NetAddress peer_;  // the peer that Connect has set; its ip is 0 if there is no peer
  // The error that broke the socket, so that this endpoint cannot use it any more; UDP_SUCCESS
  // while the socket works.
  UDPEndpointError error_ = UDP_SUCCESS;
  // True while the endpoint waits for the answer to Network::ReceiveFrom(), its request for
  // datagrams.
  bool asked_ = false;
  std::deque<NetworkEvent> waiting_;  // received datagrams that are not delivered yet
  int64_t sent_in_frame_ = 0;         // bytes sent in this frame; the pool limits their number

  std::optional<Operation> send_;
  // The number of the message in whose handler the program has last sent a datagram through this
  // endpoint with antEnvMsg::Send().  0 if the program used antEnvMsg::Call(), which waits for the
  // answer: then the next datagram cannot come too early, and NoteSecondSend() adds no note.
  uint64_t last_send_cause_ = 0;
  std::optional<Operation> receive_;
};

UDPEndpointError UdpErrorOf(NetError error);

}  // namespace openr_host
