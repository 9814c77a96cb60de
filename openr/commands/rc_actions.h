// The actions of the commands of `openr rc`.  Each action sends requests to the robot and prints
// its answers.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "RemoteProtocol.h"
#include "openr/remote/connection.h"

namespace openr_host {

namespace remote = openr::remote;

struct RcFlags {
  std::string address;
  std::string with;  // address of a second robot; "": there is only one robot
  // True: the robot that follows the other robot goes straight to each position, and ignores its
  // own limits of speed and acceleration.
  bool track = false;
  int64_t timeout_us = 3'000'000;
  // File with the token, the secret that the robots' servers ask for; "": none.
  std::string token_file;
  bool json = false;
  std::string device;  // the device that the user has named, by its name, title, locator or number
  double value = 0;
  std::string state;  // wanted state of a light or an ear: "on" or "off"
  bool watch = false;
  int64_t every_us = 500'000;
  int64_t stream_us = 32'000;
  std::string file;
  int loops = 1;
  int key_frames = 0;
  // Layer of the picture: "h", "m", "l" (high, medium or low resolution) or "c" (detected colours).
  std::string layer = "m";
  // True: the bytes of the camera picture are written exactly as the robot sends them.
  bool raw = false;
  std::string log;         // file on this host to which the log of a motion is written; "": no log
  bool simulated = false;  // true: the log's values are values of a simulated robot
  // File on this host to which a download is written; "": the new file has the name of the file on
  // the stick.
  std::string output;
  std::vector<std::string> goals;  // joints and their wanted positions, such as "neck_pan=30"
  std::string stream;              // name of the stream to print: "sensors" or "keyframes"
  int count = 0;           // number of events that are printed; 0: prints events until Ctrl-C
  std::vector<int> gains;  // new gains P, I and D; empty: the present gains are only shown
};

// Returns the time limit and the token for a connection to a robot.  The token is the secret that a
// robot's server asks for.  Throws std::runtime_error if the file of --token-file has no token.
remote::Options OptionsOf(const RcFlags& flags);

// A function that carries out a command of openr rc: it sends requests to `robot` and prints the
// answers to standard output.  Throws remote::Error.
using RcAction = std::function<void(remote::Connection* robot, const RcFlags& flags)>;

void RcInfoAction(remote::Connection* robot, const RcFlags& flags);
void RcGetAction(remote::Connection* robot, const RcFlags& flags);
void RcSensorsAction(remote::Connection* robot, const RcFlags& flags);
void RcPlayAction(remote::Connection* robot, const RcFlags& flags);
void RcStopAction(remote::Connection* robot, const RcFlags& flags);

// Actions of openr rc for several joints, and for their motors (rc_joints.cc).
void RcPoseAction(remote::Connection* robot, const RcFlags& flags);
void RcMotorAction(remote::Connection* robot, const RcFlags& flags);
void RcGainsAction(remote::Connection* robot, const RcFlags& flags);
void RcPowerAction(remote::Connection* robot, const RcFlags& flags);

// Plays a motion on two robots at the same time (rc_play_with.cc).
void RcPlayWithAction(remote::Connection* robot, const RcFlags& flags);
// Returns `bytes`, the log of a motion, as the log of a simulated robot: with its measured values
// in the group of simulated values (rc_play_with.cc).
std::string SimulatedLog(const std::string& bytes);

// Fetches a picture from the robot's camera (rc_camera.cc).
void RcCameraAction(remote::Connection* robot, const RcFlags& flags);

// Actions that receive events, which the robot sends without further requests (rc_streams.cc).
void RcStreamAction(remote::Connection* robot, const RcFlags& flags);
void RcLogAction(remote::Connection* robot, const RcFlags& flags);

// Actions of openr rc for files of the robot's stick, and for the end of the run (rc_files.cc).
void RcListAction(remote::Connection* robot, const RcFlags& flags);
void RcUploadMotionAction(remote::Connection* robot, const RcFlags& flags);
void RcUploadControllerAction(remote::Connection* robot, const RcFlags& flags);
void RcDownloadAction(remote::Connection* robot, const RcFlags& flags);
void RcDeleteAction(remote::Connection* robot, const RcFlags& flags);
void RcRebootAction(remote::Connection* robot, const RcFlags& flags);
void RcShutdownAction(remote::Connection* robot, const RcFlags& flags);

// Returns the action that sends `command`, which is rcMOVE, rcSPEED or rcACCEL, to a joint.  `unit`
// is the unit of the value, for the printed answer.
RcAction RcJointAction(RcCommand command, const std::string& unit);

// Returns the action that sends `command`.  With rcLED the action switches a light on or off.  With
// rcEAR it moves an ear, which has two positions.
RcAction RcLightAction(RcCommand command);

}  // namespace openr_host
