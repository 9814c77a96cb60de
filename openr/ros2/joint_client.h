// A client of the remote control inside the program.  It sends joint targets of ROS 2 to the robot
// as a client on the network does (docs/remote-control.md).
//
// The client is placed between a robot and its network, and opens a connection of its own to the
// robot's port, without a socket.  The client's data come out of Poll() like all data from outside.
// Therefore the robot, the order of events and a recording treat it like any other client, a run
// with commands can be replayed, and the robot's limits of position, speed and acceleration hold.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "RemotePacket.h"
#include "openr/simulation/passing_network.h"

namespace openr_host {

struct JointTarget {
  double position_rad = 0;
  double speed_rad_s = 0;  // limit from now on; 0: no change
};

class JointClient : public PassingNetwork {
 public:
  // A function that is called with the reason when the robot refuses a target.
  using Refused = std::function<void(const std::string& why)>;
  JointClient(std::unique_ptr<Network> inner, Refused refused)
      : PassingNetwork(std::move(inner)), refused_(std::move(refused)) {}

  // Sets targets by joint, in the robot's numbering, for the next Poll().  Until the robot has
  // answered the targets before, only the newest target of each joint is kept.
  void Want(const std::map<int, JointTarget>& targets);

  // Returns whether targets wait because the robot has not taken them.
  bool IsWaiting() const { return !wanted_.empty(); }
  // Drops the waiting targets.
  void GiveUp() { wanted_.clear(); }

  void Listen(NetHandle listener, uint16_t port) override;
  void Accept(NetHandle listener, NetHandle handle) override;
  void Send(NetHandle handle, const void* data, size_t size) override;
  void Receive(NetHandle handle, size_t size_max) override;
  void Close(NetHandle handle) override;
  void Drop(NetHandle handle, bool reset) override;
  std::vector<NetworkEvent> Poll() override;

 private:
  bool TakePlace(std::vector<NetworkEvent>* events);
  void WriteRequests();
  void Request(int command, int joint, double value);
  void HearAnswers();
  void Forget();

  const Refused refused_;
  std::map<int, JointTarget> wanted_;  // by joint
  NetHandle listener_ = 0;             // handle on which the remote control listens
  std::deque<NetHandle> accepts_;  // accept operations of the remote control without a client yet

  // ---- State of the connection
  NetHandle handle_ = 0;  // 0: no connection
  std::string out_;       // requests that the robot has not read
  int unanswered_ = 0;
  uint64_t taken_ = 0;  // bytes of answers since the last Poll()
  size_t wants_ = 0;    // bytes that a Receive() of the robot waits for
  bool is_closing_ = false;
  bool is_broken_ = false;  // the data received were no valid answer
  RcFramer framer_;
};

}  // namespace openr_host
