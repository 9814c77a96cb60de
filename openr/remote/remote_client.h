// The client's end of the remote control: docs/remote-control.md over a TCP connection.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "RemoteProtocol.h"

namespace openr_host {

// "HOST" or "HOST:PORT", the port being that of the robot if none is given.
struct RemoteAddress {
  std::string host;
  uint16_t port = RC_PORT;

  std::string Text() const { return host + ":" + std::to_string(port); }
};

// Returns "" or what is wrong.  The network of a robot is IPv4: addresses of IPv6 are refused.
std::string ParseRemoteAddress(const std::string& text, RemoteAddress* address);

// The robot refused a request.
class RemoteRefusal : public std::runtime_error {
 public:
  RemoteRefusal(int the_status, uint32_t the_frame, const std::string& why)
      : std::runtime_error(why), status(the_status), frame(the_frame) {}
  const int status;      // RcStatus
  const uint32_t frame;  // of the answer
};

// What a request brought back.
struct RemoteAnswer {
  uint32_t frame = 0;  // 8 ms each; 0xffffffff before the first sensor values
  std::vector<uint8_t> payload;
};

// Robots answer in the order of the requests.  What goes wrong is thrown: std::runtime_error with a
// remedy when the robot cannot be reached or does not answer in time, RemoteRefusal when it says
// no.
class RemoteClient {
 public:
  RemoteClient(const RemoteAddress& address, int timeout_ms)
      : RemoteClient(address, timeout_ms, false) {}
  ~RemoteClient();
  RemoteClient(const RemoteClient&) = delete;
  RemoteClient& operator=(const RemoteClient&) = delete;

  RemoteAnswer Request(int command, const std::vector<uint8_t>& payload = {});

  // Sends all requests, then waits for all answers: one round trip instead of many.
  std::vector<RemoteAnswer> RequestAll(int command,
                                       const std::vector<std::vector<uint8_t>>& payloads);

  // A request made of any struct of RemoteProtocol.h that has Write().
  template <typename Payload>
  RemoteAnswer RequestWith(int command, const Payload& payload) {
    uint8_t bytes[RC_MAX_PACKET];
    RcWriter writer(bytes, sizeof bytes);
    payload.Write(&writer);
    return Request(command, {bytes, bytes + writer.Size()});
  }

  // Reads a struct of RemoteProtocol.h out of an answer.
  template <typename Payload>
  Payload Read(const RemoteAnswer& answer) const {
    Payload payload{};
    RcReader reader(answer.payload.data(), static_cast<int>(answer.payload.size()));
    if (!payload.Read(&reader)) ThrowMalformed();
    return payload;
  }

 private:
  RemoteClient(const RemoteAddress& address, int timeout_ms, bool is_probe);
  void Connect();
  // Whether the robot answers another client, now that this connection is lost.
  bool RobotGoesOn() const;
  int WaitForConnection() const;  // an errno
  uint16_t SendRequest(int command, const std::vector<uint8_t>& payload);
  RemoteAnswer ReceiveAnswer(uint16_t tag);
  void Send(const std::vector<uint8_t>& bytes);
  void ReceivePacket();
  bool WaitFor(short events) const;
  [[noreturn]] void ThrowMalformed() const;
  [[noreturn]] void ThrowSilent() const;
  [[noreturn]] void ThrowLost(int error) const;  // an errno; 0: closed by the other end
  [[noreturn]] void Throw(const std::string& why) const;

  const RemoteAddress address_;
  const int timeout_ms_;
  const bool is_probe_;  // made by RobotGoesOn() of another one
  int socket_ = -1;
  uint16_t tag_ = 0;
  RcFramer framer_;
};

// Devices of the robot by name, title, locator or number.
class RemoteDevices {
 public:
  RemoteDevices(RemoteClient* client, RcDeviceKind kind);

  const std::vector<RcDescription>& all() const { return all_; }

  // Index of the device.  Throws std::runtime_error that lists the names there are.
  int Find(const std::string& name) const;

 private:
  std::vector<RcDescription> all_;
};

}  // namespace openr_host
