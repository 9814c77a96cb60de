// GatewayConnection: the TCP connection of one service of the gateway.  A service has at most one
// connection at a time.
//
// The robot's side listens on the service's port; it accepts a second client and closes that
// connection at once.  The host's side connects and tries again every second.  Both sides send
// messages to IPStack like any object (TCPEndpointMsg.h), so IPStack records and replays the input
// of the gateway like the input of all objects.
#pragma once

#include <TCPEndpointMsg.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "runtime/config/gateway_config.h"

namespace openr_host {

class Hasher;
class TcpGateway;

class GatewayConnection {
 public:
  class Owner {
   public:
    virtual ~Owner() = default;
    virtual void Up() = 0;
    virtual void Received(std::string_view bytes) = 0;
    virtual void Sent() = 0;  // called when all bytes given to Send() have been sent
    virtual void Down() = 0;
  };

  static constexpr int64_t kRetryUs = 1'000'000;
  // The time after which a connect without an answer causes a warning.  The warning advises the
  // user to write 127.0.0.1 into HOSTGW.CFG if the robot is a run on this computer, because an old
  // HOSTGW.CFG often has the address of a real robot.
  static constexpr int64_t kHintUs = 5'000'000;

  // `index` is the number of the service within the gateway, `record` its line of ROBOTGW.CFG or
  // HOSTGW.CFG.  `owner` handles the data; its functions are called in handlers of the gateway.
  GatewayConnection(TcpGateway* gateway, int index, const GatewayRecord& record, Owner* owner);

  bool is_up() const { return is_up_; }
  bool is_sending() const { return is_sending_; }

  // Begins to listen for a connection of the peer, the gateway of another computer.  If the
  // service's line of the configuration file has an address, connects to this address instead.
  // REQUIRES, for this function and all functions below: a handler of the gateway runs.
  void Open();
  void Send(std::string_view bytes);  // REQUIRES: is_up()
  // Ends the connection because the peer, the gateway of the other computer, broke the protocol,
  // and adds a finding.  REQUIRES: is_up()
  void Refuse(const std::string& why);

  void HandleAnswer(const antEnvMsg& answer);
  // Warns the user if the peer, the gateway of the other computer, has neither accepted nor refused
  // an attempt to connect.  Called when kHintUs have passed since an attempt.
  void WarnIfNoAnswer();

  void HashState(Hasher* hasher) const;

 private:
  bool NewBuffer();
  antModuleRef NewEndpoint();
  void Listen();
  void HandleListenAnswer(const TCPEndpointListenMsg& answer);
  void Connect();
  void HandleConnectAnswer(const TCPEndpointConnectMsg& answer);
  void UseConnection(const antModuleRef& endpoint);
  void Receive();
  void SendNext();
  void Close(antModuleRef endpoint);
  void Lose();
  template <typename M>
  void Post(M message);
  void Warn(const std::string& text);

  TcpGateway* const gateway_;
  const int index_;
  const GatewayRecord record_;
  Owner* const owner_;
  // The memory that the gateway shares with IPStack.  It begins with the received bytes; the bytes
  // to send follow.
  byte* shared_buffer_ = nullptr;
  antModuleRef listener_;  // the endpoint that waits for the next client
  antModuleRef endpoint_;  // the endpoint of the connection, also while a connect has no answer yet
  bool is_up_ = false;
  bool had_answer_ = false;  // true after a connect has succeeded or failed
  bool is_sending_ = false;
  std::string out_;  // bytes to send that were not given to IPStack yet
};

}  // namespace openr_host
