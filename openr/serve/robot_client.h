// RobotClients: TCP connections of a program to a robot whose network is inside the process.
//
// Bytes that a client sends arrive at once, and the robot sees them at its next frame boundary.  So
// a run with such clients is the same each time; a run with sockets of the host is not.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>

#include "runtime/ipstack/loopback_network.h"

namespace openr_host {

class System;

class RobotClients {
 public:
  // Returns the network of a robot, for SimulationOptions::network_filter.
  std::unique_ptr<Network> MakeNetwork(int robot) {
    return std::make_unique<LoopbackNetwork>(HubOf(robot));
  }

  // Connects to the TCP port `port` of a robot.  Returns the number of the connection.
  int Connect(const System& system, int robot, uint16_t port);

  struct State {
    bool is_open = false;  // true: the robot has accepted the connection, and has not ended it
    // True: the robot or the program has ended the connection, or the connection has failed.
    bool has_ended = false;
    bool is_closed = false;  // true: the program has closed the connection by Close()
    std::string problem;     // the reason why the connection failed; "": it has not failed
    size_t waiting = 0;  // number of bytes that have arrived and that Take() has not returned yet
  };
  // StateOf(), Send(), Take() and Close() throw std::runtime_error if the connection does not
  // exist.  Send() also throws it if the connection has ended.
  State StateOf(int connection);
  void Send(int connection, std::string_view bytes);
  // Returns bytes that the robot has sent, at most `size_max`, and removes them from the waiting
  // bytes.
  std::string Take(int connection, size_t size_max);
  void Close(int connection);

 private:
  struct Client {
    std::unique_ptr<LoopbackNetwork> network;
    int robot = -1;   // number of the robot to which the connection is made; -1: not yet known
    uint32_t ip = 0;  // the address of the program, as the robot sees it
    bool is_connected = false;
    bool has_ended = false;
    bool is_closed = false;
    std::string problem;
    std::string received;
  };

  // Returns the network of a robot.  Each robot has a network of its own, because all robots may
  // have the same address.
  const std::shared_ptr<LoopbackHub>& HubOf(int robot) {
    std::shared_ptr<LoopbackHub>& hub = hubs_[robot];
    if (hub == nullptr) hub = std::make_shared<LoopbackHub>();
    return hub;
  }
  // Returns the address for a new connection to a robot: the lowest address from 10.0.1.3 on that
  // is neither `robot_ip`, the robot's own address, nor in use by an open connection to this robot.
  uint32_t FreeAddress(int robot, uint32_t robot_ip) const;
  Client& Find(int connection);
  static void Poll(Client* client);

  // The network of each robot; the key is the number of the robot.
  std::map<int, std::shared_ptr<LoopbackHub>> hubs_;
  std::map<int, Client> clients_;
  int last_ = 0;
};

}  // namespace openr_host
