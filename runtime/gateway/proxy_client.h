// Sends OPEN-R calls of objects that run on a PC (a stick with !ROBOT_PROXY in HOSTGW.CFG) to the
// robot.
//
// A call is a message to the gateway; its sender, and only it, waits for the answer.  Calls go out
// one after the other, because the wire has no numbers for them.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>

#include "runtime/core/system.h"
#include "runtime/gateway/gateway_channel.h"
#include "runtime/gateway/proxy_wire.h"

namespace openr_host {

// A call, as a message to the gateway; `size` bytes follow.
struct ProxyRequest {
  char object[16];      // name of the system object
  uint32_t selector;    // its entry
  uint32_t reply_size;  // bytes wanted
  uint32_t size;
};

class ProxyClient : public GatewayChannel {
 public:
  // How long the robot has to answer, as with the original's SelectProxyPort() (core.md, 5.4).
  static constexpr int64_t kPatienceUs = 10'000'000;

  ProxyClient(TcpGateway* gateway, int index, const GatewayRecord& record)
      : GatewayChannel(gateway, index, record), gateway_(gateway) {}

  // Takes the request being handled.  Its answer is a word, an sError, and the bytes of the reply.
  void Take(const void* payload, size_t size);
  // Gives up when the first request has waited too long.
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
  void TakeAnswer(const ProxyFrame& frame);
  // Answers the first request.
  void Answer(int32_t error, const std::string& bytes = "");
  void AnswerAll(int32_t error);

  TcpGateway* const gateway_;
  std::deque<Request> requests_;
  std::map<std::string, uint32_t> oids_;  // of the robot, as long as the connection lasts
  bool waits_ = false;                    // the first request has gone out
  bool gave_up_ = false;                  // the robot did not answer; calls fail until it is there
  bool watches_ = false;                  // a message to Expire() is on its way
};

}  // namespace openr_host
