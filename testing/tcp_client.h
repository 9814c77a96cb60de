// TcpClient, a simulated network client.  The robot sees it as a program on another computer.  The
// client does the steps of a script that the test writes.
//
//   bench.AddClient().Connect(54000).Send("PING\n").Hear("PONG\n").Close();
//   bench.RunFor(1s);
//
// The client acts only at frame boundaries of the virtual time (every 8 ms), where all input from
// outside enters a robot.  So a run with clients is the same each time, too.  Bench::Verify() makes
// the test fail if a script has not ended.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <variant>

#include "runtime/core/code_object.h"
#include "runtime/ipstack/loopback_network.h"
#include "testing/place.h"

namespace openr::testing {

class TcpClient : public openr_host::CodeObject {
 public:
  TcpClient(std::shared_ptr<openr_host::LoopbackHub> hub, uint32_t own_ip, uint32_t robot_ip);

  // ---- Functions that add a step to the script of this client

  // Adds a step that waits until an object listens on `port` of the robot and accepts the
  // connection.
  TcpClient& Connect(uint16_t port, Place place = Place::Here());
  TcpClient& Send(std::string bytes, Place place = Place::Here());
  // Adds a step that waits until the robot has sent `bytes`, and skips the bytes before them.
  TcpClient& Hear(std::string bytes, Place place = Place::Here());
  // Adds a step that waits until the robot has sent `count` more bytes.
  TcpClient& HearBytes(size_t count, Place place = Place::Here());
  // Adds a step that waits until the robot has ended the connection.
  TcpClient& HearEnd(Place place = Place::Here());
  // Add a step that ends the connection.  Close() ends it as TCP does normally.  Reset() breaks it
  // off with a TCP reset, so that the robot's next calls on the connection fail.
  TcpClient& Close(Place place = Place::Here());
  TcpClient& Reset(Place place = Place::Here());

  bool done() const { return script_.empty(); }
  // Describes the step of the test's script in which this client waits, and the bytes received so
  // far: "to hear 'PONG\n', has heard ''".  Returns "" when the script is done.
  std::string WaitsFor() const;
  // Returns the line of the test that added the step in which the script waits.  REQUIRES: !done().
  const Place& place() const;
  // Drops the steps of the script that are not done, so that their failure is reported only once.
  void DropScript() { script_.clear(); }

  // ---- The state of the connection

  bool connected() const { return connected_; }
  bool ended() const { return ended_; }                // true: the robot has ended the connection
  bool broken() const { return broken_; }              // true: the robot has reset the connection
  const std::string& heard() const { return heard_; }  // all bytes that the client has received

 private:
  enum class Kind { kConnect, kSend, kHear, kHearBytes, kHearEnd, kClose, kReset };
  struct Step {
    Kind kind;
    Place place;
    std::string bytes = {};
    size_t count = 0;  // for kHearBytes: number of bytes; for kConnect: port
  };

  TcpClient& Add(Step step);
  void PostPoll();
  void Poll();
  void StoreEvent(const openr_host::NetworkEvent& event);
  bool Do(const Step& step);
  bool DoConnect(const Step& step);

  openr_host::LoopbackNetwork network_;
  const uint32_t robot_ip_;
  Selector poll_entry_;
  bool poll_posted_ = false;
  std::deque<Step> script_;
  openr_host::NetHandle handle_ = 0;
  bool connecting_ = false;
  bool connected_ = false;
  bool ended_ = false;
  bool broken_ = false;
  std::string heard_;  // all bytes that the robot has sent
  size_t passed_ = 0;  // number of bytes of heard_ that the earlier steps of the script have used
};

}  // namespace openr::testing
