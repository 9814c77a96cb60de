// A client of the remote control inside the program: joint targets of ROS 2 go to the robot as a
// client on the network sends them (docs/remote-control.md).
//
// It stands between a robot and its network and makes a connection of its own to the robot's port,
// without a socket.  For the robot, the order of events and a recording it is one client more:
// what it says comes out of Poll() as everything from outside does, so a run with commands is
// replayed like any other, and the robot's own limits of position, speed and acceleration hold.
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
  double speed_rad_s = 0;  // limit from now on; 0: the one in force
};

class JointClient : public PassingNetwork {
 public:
  // `refused` hears why the robot did not take a target.
  using Refused = std::function<void(const std::string& why)>;
  JointClient(std::unique_ptr<Network> inner, Refused refused)
      : PassingNetwork(std::move(inner)), refused_(std::move(refused)) {}

  // Targets by joint, in the robot's numbering, for the next Poll().  While the robot has not yet
  // answered the ones before, the newest of each joint waits.
  void Want(const std::map<int, JointTarget>& targets);

  // Targets wait that the robot does not take.
  bool IsWaiting() const { return !wanted_.empty(); }
  // They are too old.
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
  NetHandle listener_ = 0;             // of the remote control
  std::deque<NetHandle> accepts_;      // of it, not yet connected

  // Of the connection.
  NetHandle handle_ = 0;  // 0: none
  std::string out_;       // requests that the robot has not read
  int unanswered_ = 0;
  uint64_t taken_ = 0;  // bytes of answers since the last Poll()
  size_t wants_ = 0;    // of a Receive()
  bool is_closing_ = false;
  bool is_broken_ = false;  // what came is no answer
  RcFramer framer_;
};

}  // namespace openr_host
