// RemoteClient, a client of the robot's remote control.  It speaks the protocol of
// docs/remote-control.md over TCP.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "RemoteProtocol.h"
#include "RemoteStreams.h"

namespace openr_host {

// The address of a robot, which users write as "HOST" or "HOST:PORT".  Without a port it has the
// remote control's usual port, 54000.
struct RemoteAddress {
  std::string host;
  uint16_t port = RC_PORT;

  std::string Text() const { return host + ":" + std::to_string(port); }
};

// Reads `text` into `address`.  Returns "" or the error.  IPv6 addresses are refused, because the
// robot's network is IPv4.
std::string ParseRemoteAddress(const std::string& text, RemoteAddress* address);

// The exception that RemoteClient throws when the robot refuses a request.
class RemoteRefusal : public std::runtime_error {
 public:
  RemoteRefusal(int the_status, uint32_t the_frame, const std::string& why)
      : std::runtime_error(why), status(the_status), frame(the_frame) {}
  const int status;      // RcStatus
  const uint32_t frame;  // frame number in the answer
};

// The exception that RemoteClient throws when the robot cannot be reached, is silent for too long
// or sends what is no answer.  The connection is of no use any more.
class RemoteFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The robot's answer to a request.
struct RemoteAnswer {
  uint32_t frame = 0;  // number of the frame of 8 ms; 0xffffffff: no sensor values yet
  std::vector<uint8_t> payload;
};

// A request, for a batch.  `payload` has no header.
struct RemoteCall {
  int command;
  std::vector<uint8_t> payload;
};

// A packet of a stream, which the robot sends unasked (RemoteStreams.h).
struct RemoteEvent {
  uint16_t tag = 0;  // what Subscribe() has returned
  uint32_t frame = 0;
  int stream = 0;               // RcStream
  int left_out = 0;             // number of values missed since the event before
  std::vector<uint8_t> values;  // RcSensors or RcSetValues
};

// The robot's answer to a request in a batch.
struct RemoteReply {
  int status = rcOK;  // RcStatus; when it is not rcOK, `error` says why
  std::string error;
  RemoteAnswer answer;
};

// A packet that has arrived without being waited for: an event or, if `is_event` is false, the
// answer to a request of Post() or PostBatch().
struct RemotePacket {
  bool is_event = false;
  RemoteEvent event;
  uint16_t tag = 0;
  RemoteReply reply;
};

// A connection to a robot, which answers requests in the order in which they were sent.  The
// functions throw RemoteRefusal when the robot refuses a request.  When it cannot be reached or is
// silent for too long, they throw RemoteFailure, whose text says what the user can do.
class RemoteClient {
 public:
  RemoteClient(const RemoteAddress& address, int timeout_ms)
      : RemoteClient(address, timeout_ms, false) {}
  ~RemoteClient();
  RemoteClient(const RemoteClient&) = delete;
  RemoteClient& operator=(const RemoteClient&) = delete;

  // Makes all further requests in this version of the protocol.  The first version is
  // RC_VERSION; commands for files need RC_VERSION_FILES.
  void UseVersion(int version) { version_ = version; }

  RemoteAnswer Request(int command, const std::vector<uint8_t>& payload = {});

  // Sends one request for each payload, then waits for all answers.  That takes one round trip
  // instead of many.
  std::vector<RemoteAnswer> RequestAll(int command,
                                       const std::vector<std::vector<uint8_t>>& payloads);

  // Sends up to RC_MAX_BATCH requests in one packet, in version 2 of the protocol, and returns
  // their answers in the same order.  A request that the robot refuses does not end the batch.
  std::vector<RemoteReply> Batch(const std::vector<RemoteCall>& calls);

  // Subscribes to a stream and returns the tag of its events.  `period` is the smallest number of
  // frames between two events.
  uint16_t Subscribe(RcStream stream, int period);

  // Waits for the next event, without a limit as long as the robot answers.  Asks for INFO from
  // time to time, because a client that sends nothing may lose its place.  Events that arrive while
  // an answer is awaited are kept for this function, the newest kEventsMax of them.
  RemoteEvent NextEvent();
  static constexpr size_t kEventsMax = 1000;

  // The functions below do not wait for the robot, for programs that serve several robots in one
  // thread (remote_posts.cc).  A program uses either them or the functions above.

  // Send a request, or requests in one packet, and return the tag of the answer.
  uint16_t Post(int command, const std::vector<uint8_t>& payload = {});
  uint16_t PostBatch(const std::vector<RemoteCall>& calls);
  // Returns the next packet that has arrived whole; none if there is none.  Throws RemoteFailure
  // when the connection is lost.
  std::optional<RemotePacket> TakePacket();
  // Reads the answer to PostBatch(), which had `count` requests.
  std::vector<RemoteReply> ReadBatch(const RemoteAnswer& answer, size_t count) const;
  // Returns the socket, for poll().
  int descriptor() const { return socket_; }

  // Sends a request with the payload `payload`, a struct of RemoteProtocol.h, and returns the
  // answer.
  template <typename Payload>
  RemoteAnswer RequestWith(int command, const Payload& payload) {
    uint8_t bytes[RC_MAX_PACKET];
    RcWriter writer(bytes, sizeof bytes);
    payload.Write(&writer);
    return Request(command, {bytes, bytes + writer.Size()});
  }

  // Reads the values of `event` into RcSensors or RcSetValues.
  template <typename Values>
  Values Read(const RemoteEvent& event) const {
    return Read<Values>(RemoteAnswer{event.frame, event.values});
  }

  // Reads the payload of `answer` into a struct of RemoteProtocol.h.
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
  // Called after this connection was lost.  Returns whether the robot answers on a new connection,
  // so that the error text can say whether only the connection or the whole run has ended.
  bool RobotGoesOn() const;
  int WaitForConnection() const;  // returns 0 or an errno
  uint16_t SendRequest(int command, const std::vector<uint8_t>& payload);
  RemoteAnswer ReceiveAnswer(uint16_t tag);
  void Send(const std::vector<uint8_t>& bytes);
  void ReceivePacket();
  bool ReceivePacketInTime();
  RcAnswerHeader ReceiveHeader();
  bool KeepEvent(const RcAnswerHeader& header);
  static RemoteReply ReadReply(const RcAnswerHeader& header, const RcFramer& framer);
  std::vector<uint8_t> BatchPayload(const std::vector<RemoteCall>& calls) const;
  bool ReceiveNow();
  bool WaitFor(short events) const;
  [[noreturn]] void ThrowMalformed() const;
  [[noreturn]] void ThrowSilent() const;
  [[noreturn]] void ThrowLost(int error) const;  // `error` is an errno; 0: the other end has closed
  [[noreturn]] void Throw(const std::string& why) const;

  const RemoteAddress address_;
  const int timeout_ms_;
  const bool is_probe_;  // made by RobotGoesOn() to test the robot
  int socket_ = -1;
  uint16_t tag_ = 0;
  int version_ = RC_VERSION;
  RcFramer framer_;
  std::deque<RemoteEvent> events_;  // arrived and not yet returned by NextEvent()
};

// The devices of one kind, such as joints, that the robot has.  Users may give a device's short
// name ("LF_j1"), title ("Left fore leg J1"), locator ("PRM:/r2/c1-Joint2:j1", its name in OPEN-R)
// or number.
class RemoteDevices {
 public:
  RemoteDevices(RemoteClient* client, RcDeviceKind kind);

  const std::vector<RcDescription>& all() const { return all_; }

  // Returns the index of the device whose short name, title, locator or number is `name`.  Throws
  // std::runtime_error with a list of all devices when the robot has no such device.
  int Find(const std::string& name) const;

 private:
  std::vector<RcDescription> all_;
};

}  // namespace openr_host
