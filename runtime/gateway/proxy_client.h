// Sends OPEN-R calls (calls of OPENR:: functions) of objects that run on a PC to the robot.  The
// stick of the PC names the robot in the line !ROBOT_PROXY of its HOSTGW.CFG.
//
// An object makes a call by a message to the gateway and waits for the reply; other objects run on.
// The class ProxyClient sends a call to the robot only after the answer to the call before, because
// answers from the robot have no number that identifies their call.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <string_view>

#include "runtime/core/requests.h"
#include "runtime/gateway/gateway_channel.h"
#include "runtime/gateway/proxy_wire.h"

namespace openr_host {

// The head of the message by which an object asks the gateway to call a system object of the robot,
// such as OVirtualRobot.  The bytes of the call follow this head.
struct ProxyRequest {
  char object[16];      // name of the system object to call
  uint32_t selector;    // selector of the entry to call
  uint32_t reply_size;  // largest size of the reply in bytes
  uint32_t size;        // number of bytes that follow this head
};

class ProxyClient : public GatewayChannel {
 public:
  // The time limit for the robot's answer to a call, the same as in SelectProxyPort() of Sony's
  // TCPGateway (core.md, 5.4).
  static constexpr int64_t kPatienceUs = 10'000'000;

  ProxyClient(TcpGateway* gateway, int index, const GatewayRecord& record)
      : GatewayChannel(gateway, index, record), gateway_(gateway) {}

  // Queues the request that the running handler has received.  `payload` holds the request: a
  // ProxyRequest, then the bytes of the call.  The reply to the request is a word with an sError,
  // then the bytes of the robot's reply.
  void AddRequest(const void* payload, size_t size);
  // Fails all requests if the oldest request has waited for the robot's answer for kPatienceUs.
  // The other requests fail too, because they are sent only after the answer to the oldest.  If the
  // connection to the robot is open, closes it, and the error is sFAIL.  Otherwise the error is
  // sTIMEOUT.
  void Expire();

  void Up() override;
  void Received(std::string_view bytes) override;
  void Sent() override {}
  void Down() override;
  void HashState(Hasher* hasher) const override;

 private:
  struct Request {
    int64_t since_us = 0;
    ReplyTicket ticket;
    std::string object;
    uint32_t selector = 0;
    uint32_t reply_size = 0;
    std::string bytes;
  };

  void WatchTime();
  void SendNext();
  void HandleAnswer(const ProxyFrame& frame);
  // Answers and removes the oldest request, a call that waits for the robot's answer.  REQUIRES:
  // there is a request.
  void Answer(int32_t error, const std::string& bytes = "");
  void AnswerAll(int32_t error);

  TcpGateway* const gateway_;
  std::deque<Request> requests_;
  std::map<std::string, uint32_t> oids_;  // OIDs of robot objects by name; valid for one connection
  bool is_request_sent_ = false;          // the oldest request was sent and is not answered yet
  // True after the robot has not answered a call in time.  Then a new call fails at once if there
  // is no connection, and does not wait for another kPatienceUs.
  bool has_timed_out_ = false;
  bool is_expire_posted_ = false;  // whether a message that will call Expire() is posted
};

}  // namespace openr_host
