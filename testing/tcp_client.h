// A client on another computer, as a test plays it: a script on the bench's own network.
//
//   bench.AddClient().Connect(54000).Send("PING\n").Hear("PONG\n").Close();
//   bench.RunFor(1s);
//
// The script goes on by virtual time, at the frame boundaries at which input from outside
// enters a robot, so a run with clients repeats itself like any other.  A script that has
// not come to its end fails the test when the bench is verified.
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

  // ---- The script, step after step

  // Until somebody listens on `port` of the robot and takes the connection.
  TcpClient& Connect(uint16_t port, Place place = Place::Here());
  TcpClient& Send(std::string bytes, Place place = Place::Here());
  // Until these bytes came; what came before them is passed over.
  TcpClient& Hear(std::string bytes, Place place = Place::Here());
  // Until so many more bytes came.
  TcpClient& HearBytes(size_t count, Place place = Place::Here());
  // Until the robot has ended the connection.
  TcpClient& HearEnd(Place place = Place::Here());
  // Ends the connection in an orderly way, or as a computer that is switched off.
  TcpClient& Close(Place place = Place::Here());
  TcpClient& Reset(Place place = Place::Here());

  bool done() const { return script_.empty(); }
  // "to hear 'PONG\n'", and what was heard instead; "" when done.
  std::string WaitsFor() const;
  // The test's line of the step it waits at.  REQUIRES: !done().
  const Place& place() const { return script_.front().place; }
  // Forgets the rest.
  void DropScript() { script_.clear(); }

  // ---- What happened

  bool connected() const { return connected_; }
  bool ended() const { return ended_; }                // by the robot
  bool broken() const { return broken_; }              // reset by the robot
  const std::string& heard() const { return heard_; }  // everything

 private:
  enum class Kind { kConnect, kSend, kHear, kHearBytes, kHearEnd, kClose, kReset };
  struct Step {
    Kind kind;
    Place place;
    std::string bytes = {};
    size_t count = 0;  // port of kConnect
  };

  TcpClient& Add(Step step);
  void PostPoll();
  void Poll();
  void Take(const openr_host::NetworkEvent& event);
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
  std::string heard_;
  size_t passed_ = 0;  // bytes of heard_ that the script has taken
};

}  // namespace openr::testing
