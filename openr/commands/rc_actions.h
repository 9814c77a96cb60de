// The requests that the commands of `openr rc` send to the robot, and the printing of answers.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "RemoteProtocol.h"

namespace openr_host {

class RemoteClient;

struct RcFlags {
  std::string address;
  int64_t timeout_us = 3'000'000;
  bool json = false;
  std::string device;  // name, title, locator or number
  double value = 0;
  std::string state;  // "on" or "off"
  bool watch = false;
  int64_t every_us = 500'000;
  std::string file;
  int loops = 1;
  int key_frames = 0;
};

// A function that sends requests and prints one or more answers to standard output.  Throws the
// errors of RemoteClient.
using RcAction = std::function<void(RemoteClient* client, const RcFlags& flags)>;

void RcInfoAction(RemoteClient* client, const RcFlags& flags);
void RcGetAction(RemoteClient* client, const RcFlags& flags);
void RcSensorsAction(RemoteClient* client, const RcFlags& flags);
void RcPlayAction(RemoteClient* client, const RcFlags& flags);
void RcStopAction(RemoteClient* client, const RcFlags& flags);

// Returns the action for rcMOVE, rcSPEED or rcACCEL, with a value in `unit`.
RcAction RcJointAction(RcCommand command, const std::string& unit);

// Returns the action for rcLED or rcEAR.
RcAction RcLightAction(RcCommand command);

}  // namespace openr_host
