// RcCalls, which carries out the calls by which a page uses a robot's remote control (its requests
// with "do":"rc").
#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "RemoteProtocol.h"
#include "openr/remote/connection.h"

namespace openr::remote {
class SensorFormat;
}

namespace openr_host {

namespace remote = openr::remote;

// A client of a robot's remote control.  Connects at the first call, and again at the next call
// after the connection was lost.  Waits for each answer, so it must be used in a thread of its own.
class RcCalls {
 public:
  using Json = nlohmann::ordered_json;
  // A function that finds the address of the robot.  Throws std::runtime_error if the robot has no
  // address.
  using FindAddress = std::function<remote::Address()>;
  // A function that is called during an upload with two numbers: how many bytes the robot has taken
  // so far, and the size of the file in bytes.
  using Progress = remote::Progress;

  explicit RcCalls(FindAddress find_address);
  ~RcCalls();

  // Carries out the remote-control call `request["call"]`.  Returns its answer without "id", or
  // {"error":TEXT} if the call failed.  If the robot refused the call, the error has "status", too.
  Json Do(const nlohmann::json& request, const Progress& progress);

 private:
  using Request = nlohmann::json;
  using Call = Json (RcCalls::*)(const Request& request, const Progress& progress);
  static Call FindCall(const std::string& name);

  Json Connect(const Request& request, const Progress& progress);
  Json Move(const Request& request, const Progress& progress);
  Json Speed(const Request& request, const Progress& progress);
  Json Accel(const Request& request, const Progress& progress);
  Json Led(const Request& request, const Progress& progress);
  Json Ear(const Request& request, const Progress& progress);
  Json Motions(const Request& request, const Progress& progress);
  Json Play(const Request& request, const Progress& progress);
  Json Stop(const Request& request, const Progress& progress);
  Json Upload(const Request& request, const Progress& progress);
  Json Delete(const Request& request, const Progress& progress);
  Json Download(const Request& request, const Progress& progress);
  Json Motors(const Request& request, const Progress& progress);
  Json Reboot(const Request& request, const Progress& progress);
  Json Shutdown(const Request& request, const Progress& progress);
  Json Sensors(const Request& request, const Progress& progress);
  Json Power(const Request& request, const Progress& progress);

  // Returns the connection to the robot.  Makes the connection first if there is none.
  remote::Connection* Robot();
  using Setter = double (remote::Connection::*)(int joint, double value);
  Json JointValue(Setter setter, const Request& request, const char* member);
  // Returns the index of the light or ear that `request` names.  Sets `*is_on` to the member "on"
  // of the request.
  int Switch(RcDeviceKind kind, const Request& request, bool* is_on);
  std::string FreeName();
  Json PlayAndDelete(const Request& request);
  void Disconnect();

  const FindAddress find_address_;
  std::unique_ptr<remote::Connection> robot_;  // the connection to the robot; null: not connected
  std::unique_ptr<remote::SensorFormat> sensors_;
};

}  // namespace openr_host
