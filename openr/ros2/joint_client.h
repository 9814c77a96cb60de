// JointClient, a client of the robot's remote control inside this program.  It sends the robot the
// joint targets that come from ROS 2, as a client on the network does (docs/remote-control.md).
//
// The client needs no socket, because it stands between the robot and its network.  Its connection
// and its requests reach the robot as events of Poll(), like those of a client on the network.  So
// the robot cannot distinguish this client from others.  The robot's limits of position, speed and
// acceleration hold for the joint targets, and a run can be recorded and replayed with them.
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
  double speed_rad_s = 0;  // new limit of the joint's speed; 0: the joint keeps its present limit
};

class JointClient : public PassingNetwork {
 public:
  // The type of a function that is called, with the reason, when the robot refuses a target.
  using Refused = std::function<void(const std::string& why)>;
  JointClient(std::unique_ptr<Network> inner, Refused refused)
      : PassingNetwork(std::move(inner)), refused_(std::move(refused)) {}

  // Stores joint targets for the next Poll().  The key of a target is the number that the robot
  // gives the joint.  While the robot has not answered earlier requests, a new target replaces the
  // stored target of the same joint.
  void SetTargets(const std::map<int, JointTarget>& targets);

  // Returns whether stored joint targets still wait to be sent to the robot.
  bool IsWaiting() const { return !wanted_.empty(); }
  // Drops the stored joint targets.  Called when they could not be sent to the robot for 1 s,
  // because an old command must not move the robot much later.
  void GiveUp() { wanted_.clear(); }

  void Listen(NetHandle listener, uint16_t port) override;
  void Accept(NetHandle listener, NetHandle handle) override;
  void Send(NetHandle handle, const void* data, size_t size) override;
  void Receive(NetHandle handle, size_t size_max) override;
  void Close(NetHandle handle) override;
  void Drop(NetHandle handle, bool reset) override;
  std::vector<NetworkEvent> Poll() override;
  void Forget() override;

 private:
  bool AnswerAccept(std::vector<NetworkEvent>* events);
  void WriteRequests();
  void Request(int command, int joint, double value);
  void ReadAnswers();
  void EndConnection();

  const Refused refused_;
  std::map<int, JointTarget> wanted_;  // stored targets; key: number of the joint
  NetHandle listener_ = 0;         // listener of the robot's remote control; 0: it does not listen
  std::deque<NetHandle> accepts_;  // Accept() calls of the remote control that wait

  // ---- Members for the connection to the robot
  NetHandle handle_ = 0;  // the robot's end of the connection; 0: no connection
  std::string out_;       // requests that the robot has not received yet
  int unanswered_ = 0;
  // Number of bytes that the robot has sent; the next Poll() confirms them.
  uint64_t unconfirmed_bytes_ = 0;
  // The largest number of bytes that the remote control accepts in its present call of Receive();
  // 0: no call of Receive() waits for bytes.
  size_t wants_ = 0;
  bool is_closing_ = false;
  bool is_broken_ = false;  // true: the robot has sent something that is no valid answer
  RcFramer framer_;
};

}  // namespace openr_host
