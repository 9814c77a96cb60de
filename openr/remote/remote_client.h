// A client of the remote control: the protocol of docs/remote-control.md over a TCP connection.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "RemoteProtocol.h"

namespace openr_host {

// "HOST" or "HOST:PORT"; without a port, the robot's port is used.
struct RemoteAddress {
  std::string host;
  uint16_t port = RC_PORT;

  std::string Text() const { return host + ":" + std::to_string(port); }
};

// Returns "" or the error.  IPv6 addresses are refused, because the robot's network is IPv4.
std::string ParseRemoteAddress(const std::string& text, RemoteAddress* address);

// The exception that is thrown when the robot refuses a request.
class RemoteRefusal : public std::runtime_error {
 public:
  RemoteRefusal(int the_status, uint32_t the_frame, const std::string& why)
      : std::runtime_error(why), status(the_status), frame(the_frame) {}
  const int status;      // RcStatus
  const uint32_t frame;  // frame number in the answer
};

// The answer to a request.
struct RemoteAnswer {
  uint32_t frame = 0;  // number of the frame of 8 ms; 0xffffffff before the first sensor values
  std::vector<uint8_t> payload;
};

// A connection to a robot, which answers requests in their order.  Throws std::runtime_error with a
// remedy when the robot cannot be reached or does not answer in time, and RemoteRefusal when it
// refuses a request.
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

  // Sends a request whose payload is a struct of RemoteProtocol.h that has Write(); returns the
  // answer.
  template <typename Payload>
  RemoteAnswer RequestWith(int command, const Payload& payload) {
    uint8_t bytes[RC_MAX_PACKET];
    RcWriter writer(bytes, sizeof bytes);
    payload.Write(&writer);
    return Request(command, {bytes, bytes + writer.Size()});
  }

  // Reads a struct of RemoteProtocol.h from an answer.
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
  // Returns whether the robot still answers a new client although this connection was lost.
  bool RobotGoesOn() const;
  int WaitForConnection() const;  // returns an errno
  uint16_t SendRequest(int command, const std::vector<uint8_t>& payload);
  RemoteAnswer ReceiveAnswer(uint16_t tag);
  void Send(const std::vector<uint8_t>& bytes);
  void ReceivePacket();
  bool WaitFor(short events) const;
  [[noreturn]] void ThrowMalformed() const;
  [[noreturn]] void ThrowSilent() const;
  [[noreturn]] void ThrowLost(int error) const;  // `error` is an errno; 0: the other end has closed
  [[noreturn]] void Throw(const std::string& why) const;

  const RemoteAddress address_;
  const int timeout_ms_;
  const bool is_probe_;  // this client was made by RobotGoesOn()
  int socket_ = -1;
  uint16_t tag_ = 0;
  RcFramer framer_;
};

// The devices of the robot, to be found by name, title, locator or number.
class RemoteDevices {
 public:
  RemoteDevices(RemoteClient* client, RcDeviceKind kind);

  const std::vector<RcDescription>& all() const { return all_; }

  // Returns the index of the device.  Throws std::runtime_error that lists the names.
  int Find(const std::string& name) const;

 private:
  std::vector<RcDescription> all_;
};

}  // namespace openr_host
