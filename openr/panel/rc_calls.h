// RcCalls, which does what a page asks of a robot's remote control ("do":"rc").
#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "RemoteProtocol.h"
#include "openr/remote/remote_client.h"

namespace openr_host {

class SensorFormat;

// A plain client of the remote control.  It connects at the first call, and again at the next one
// after the connection was lost.  It waits for each answer, so it belongs into a thread of its own.
class RcCalls {
 public:
  using Json = nlohmann::ordered_json;
  // Finds the address of the robot.  Throws std::runtime_error if there is none.
  using FindAddress = std::function<RemoteAddress()>;
  // Called with the number of bytes of an upload that the robot has taken, and their sum.
  using Progress = std::function<void(size_t sent, size_t size)>;

  explicit RcCalls(FindAddress find_address);
  ~RcCalls();

  // Does the call `request["call"]`.  Returns the answer without "id"; {"error":TEXT}, with
  // "status" if the robot has refused, if it failed.
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

  // Returns the client, connected, which makes its next requests in `version` of the protocol.
  RemoteClient* Client(int version = RC_VERSION);
  RcInfo Info();
  const RemoteDevices& Devices(RcDeviceKind kind);
  Json JointValue(int command, const Request& request, const char* member);
  Json Switch(int command, RcDeviceKind kind, const Request& request);
  std::string FreeName();
  Json PlayAndDelete(const Request& request);
  void Disconnect();

  const FindAddress find_address_;
  std::unique_ptr<RemoteClient> client_;  // null: not connected
  std::optional<RemoteDevices> devices_[NUM_RC_DEVICES];
  std::unique_ptr<SensorFormat> sensors_;
};

}  // namespace openr_host
