#include "openr/panel/rc_calls.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "cli/base64.h"
#include "cli/json_text.h"
#include "openr/live/request_reader.h"
#include "openr/remote/power_format.h"
#include "openr/remote/sensor_format.h"
#include "openr/upload/file_checks.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kCdegPerDeg = 100;
// Largest value of a joint, in degrees, that a page may send.  A larger value in 0.01 degree would
// not fit into 32 bits.
constexpr double kValueMax = 1e6;
constexpr int kLoopsMax = 65535;  // the remote control sends the number in 16 bits

double Degrees(Sint32 value_cdeg) { return value_cdeg / kCdegPerDeg; }

// Returns the member `member` of a request as text, even if it is a number, because a page may name
// a device by its name or by its number.
std::string TextOf(const nlohmann::json& request, const char* member) {
  const JsonReader reader = RequestReader(request).At(member);
  const nlohmann::json& value = request[member];
  if (value.is_number_integer()) return std::to_string(value.get<int64_t>());
  if (!value.is_string()) reader.Fail("must be a name or a whole number, is {}", JsonText(value));
  return reader.Text();
}

std::string UpperCase(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

// Returns how many times `request` plays a motion.  Throws std::runtime_error if the number is not
// allowed.
int LoopsOf(const nlohmann::json& request) {
  return static_cast<int>(RequestReader(request).WholeOr("loops", 1, kLoopsMax, 1));
}

Json JointJson(const remote::Description& joint, const remote::JointState& state) {
  const auto limit = [&joint](RcJointValue which) {
    return static_cast<size_t>(which) < joint.values.size() ? Degrees(joint.values[which]) : 0;
  };
  return {{"name", joint.name},
          {"title", joint.title},
          {"locator", joint.locator},
          {"min_deg", limit(rcjointMIN)},
          {"max_deg", limit(rcjointMAX)},
          {"max_speed", limit(rcjointMAX_SPEED)},
          {"max_accel", limit(rcjointMAX_ACCEL)},
          {"speed", Degrees(state.speed)},
          {"accel", Degrees(state.acceleration)},
          {"deg", Degrees(state.position)}};
}

Json NamesJson(const std::vector<remote::Description>& devices) {
  Json names = Json::array();
  for (const remote::Description& device : devices)
    names.push_back({{"name", device.name}, {"title", device.title}, {"locator", device.locator}});
  return names;
}

}  // namespace

RcCalls::RcCalls(FindAddress find_address) : find_address_(std::move(find_address)) {}

RcCalls::~RcCalls() = default;

RcCalls::Call RcCalls::FindCall(const std::string& name) {
  static const std::map<std::string, Call> calls = {
      {"connect", &RcCalls::Connect}, {"move", &RcCalls::Move},
      {"speed", &RcCalls::Speed},     {"accel", &RcCalls::Accel},
      {"led", &RcCalls::Led},         {"ear", &RcCalls::Ear},
      {"motions", &RcCalls::Motions}, {"play", &RcCalls::Play},
      {"stop", &RcCalls::Stop},       {"upload", &RcCalls::Upload},
      {"delete", &RcCalls::Delete},   {"download", &RcCalls::Download},
      {"motors", &RcCalls::Motors},   {"reboot", &RcCalls::Reboot},
      {"sensors", &RcCalls::Sensors}, {"shutdown", &RcCalls::Shutdown},
      {"power", &RcCalls::Power}};
  const auto found = calls.find(name);
  if (found != calls.end()) return found->second;
  std::vector<std::string> known;
  for (const auto& [each, call] : calls) known.push_back(each);
  throw std::runtime_error(fmt::format("'{}' is no call of the remote control; known are {}", name,
                                       fmt::join(known, ", ")));
}

Json RcCalls::Do(const nlohmann::json& request, const Progress& progress) {
  try {
    const Call call = FindCall(RequestReader(request).At("call").Text());
    Robot();
    return (this->*call)(request, progress);
  } catch (const remote::Error& error) {
    if (!error.IsConnectionUsable()) Disconnect();
    if (error.code() != remote::ErrorCode::kRefused) return {{"error", error.what()}};
    return {{"error", error.text()}, {"status", error.status()}};
  } catch (const std::exception& error) {
    return {{"error", error.what()}};
  }
}

remote::Connection* RcCalls::Robot() {
  if (robot_ == nullptr) robot_ = std::make_unique<remote::Connection>(find_address_());
  return robot_.get();
}

void RcCalls::Disconnect() {
  sensors_.reset();
  robot_.reset();
}

Json RcCalls::Connect(const Request&, const Progress&) {
  const remote::Info info = robot_->GetInfo();
  const std::vector<remote::Description>& joints = robot_->Devices(rcdeviceJOINT);
  std::vector<remote::Bytes> questions;
  for (size_t i = 0; i < joints.size(); ++i) questions.push_back({static_cast<uint8_t>(i)});
  const std::vector<remote::Answer> states = robot_->RequestAll(rcGET, questions);
  Json all = Json::array();
  for (size_t i = 0; i < joints.size(); ++i)
    all.push_back(JointJson(joints[i], robot_->Read<remote::JointState>(states[i])));
  Json sensors = Json::array();
  for (const RcDeviceKind kind : {rcdeviceBINARY, rcdeviceOTHER}) {
    for (const remote::Description& sensor : robot_->Devices(kind)) {
      sensors.push_back({{"name", sensor.name},
                         {"title", sensor.title},
                         {"unit", remote::SensorUnit(sensor)},
                         {"kind", kind == rcdeviceBINARY ? "binary" : "other"}});
    }
  }
  return {{"robot", info.design},
          {"state", remote::StateName(info.state)},
          {"processor", info.hasFiles ? info.processor : 0},
          {"joints", std::move(all)},
          {"leds", NamesJson(robot_->Devices(rcdeviceLED))},
          {"ears", NamesJson(robot_->Devices(rcdeviceEAR))},
          {"sensors", std::move(sensors)}};
}

Json RcCalls::JointValue(Setter setter, const Request& request, const char* member) {
  const int joint = robot_->Find(rcdeviceJOINT, TextOf(request, "joint"));
  const double value = RequestReader(request).At(member).Number();
  if (!(std::abs(value) < kValueMax))
    throw std::runtime_error(fmt::format("'{}' must be a number of degrees below 1000000", member));
  return {{"value", (robot_.get()->*setter)(joint, value)}};
}

Json RcCalls::Move(const Request& request, const Progress&) {
  return JointValue(&remote::Connection::Move, request, "deg");
}

Json RcCalls::Speed(const Request& request, const Progress&) {
  return JointValue(&remote::Connection::SetSpeed, request, "value");
}

Json RcCalls::Accel(const Request& request, const Progress&) {
  return JointValue(&remote::Connection::SetAcceleration, request, "value");
}

int RcCalls::Switch(RcDeviceKind kind, const Request& request, bool* is_on) {
  const int index = robot_->Find(kind, TextOf(request, "index"));
  *is_on = RequestReader(request).At("on").Bool();
  return index;
}

Json RcCalls::Led(const Request& request, const Progress&) {
  bool is_on = false;
  const int led = Switch(rcdeviceLED, request, &is_on);
  robot_->SetLed(led, is_on);
  return Json::object();
}

Json RcCalls::Ear(const Request& request, const Progress&) {
  bool is_on = false;
  const int ear = Switch(rcdeviceEAR, request, &is_on);
  robot_->SetEar(ear, is_on);
  return Json::object();
}

Json RcCalls::Motions(const Request&, const Progress&) {
  Json motions = Json::array();
  for (const remote::ListEntry& motion : robot_->ListMotions())
    motions.push_back({{"name", motion.name}, {"size", motion.size}});
  return {{"motions", motions}};
}

Json RcCalls::Play(const Request& request, const Progress&) {
  const int loops = LoopsOf(request);
  const remote::PlayAnswer answer =
      robot_->PlayMotion(RequestReader(request).At("name").Text(), loops);
  return {{"duration_s", answer.durationMs / 1000.0},
          {"key_frames", answer.keyFrames},
          {"loops", answer.loops}};
}

Json RcCalls::Stop(const Request&, const Progress&) {
  robot_->StopMotion();
  return Json::object();
}

Json RcCalls::Upload(const Request& request, const Progress& progress) {
  const std::string kind = RequestReader(request).At("kind").Text();
  std::string name = UpperCase(RequestReader(request).At("name").Text());
  std::optional<std::string> bytes = FromBase64(RequestReader(request).At("data").Text());
  if (!bytes) throw std::runtime_error("'data' is no Base64");
  const remote::Info info = robot_->GetInfo();
  RcFileKind file_kind = rcfileMOTION;
  if (kind == "controller") {
    bytes = ImageToSend(name, *std::move(bytes), info);
    file_kind = rcfileIMAGE;
    name = RC_IMAGE_NAME;
  } else if (kind == "motion") {
    CheckMotion(name, *bytes, info);
  } else {
    throw std::runtime_error("'kind' must be motion or controller");
  }
  const size_t size = bytes->size();
  const bool plays = file_kind == rcfileMOTION && request.contains("loops");
  // Checks `loops`, how often the motion plays, before the upload, so that no file is left on the
  // stick when the motion cannot play.
  if (plays) LoopsOf(request);
  if (plays) name = FreeName();
  robot_->Upload(file_kind, name, *bytes, [&progress](size_t sent, size_t whole) {
    if (sent > 0) progress(sent, whole);
  });
  if (plays) return PlayAndDelete({{"name", name}, {"loops", request["loops"]}});
  return {{"name", name}, {"size", size}};
}

// Returns an unused name for a motion file, which is deleted again as soon as the motion has begun.
std::string RcCalls::FreeName() {
  const std::vector<remote::ListEntry> motions = robot_->ListMotions();
  for (int i = 0; i <= 99; ++i) {
    std::string name = fmt::format("PANEL{}.MTN", i);
    if (std::none_of(motions.begin(), motions.end(),
                     [&](const remote::ListEntry& motion) { return motion.name == name; }))
      return name;
  }
  throw std::runtime_error("the stick has all motions from PANEL0.MTN to PANEL99.MTN already");
}

// Plays a motion, and deletes its file as soon as the robot's object JointMover has read it.
Json RcCalls::PlayAndDelete(const Request& request) {
  const std::string name = RequestReader(request).At("name").Text();
  Json answer;
  try {
    answer = Play(request, {});
  } catch (const remote::Error& error) {
    if (error.code() == remote::ErrorCode::kRefused) robot_->DeleteMotion(name);
    throw;
  }
  robot_->GetSensors();
  const uint32_t begin = robot_->frame();
  // Waits until the robot's object JointMover has read the file, which takes at most four sensor
  // vectors after the answer to MTN_PLAY.  Asks at most kAsksMax times, because a paused run makes
  // no vectors and this loop would never end.
  constexpr int kAsksMax = 100;
  for (int i = 0; i < kAsksMax; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    robot_->GetSensors();
    if (robot_->frame() - begin >= 4 * RC_FRAMES_PER_VECTOR) break;
  }
  robot_->DeleteMotion(name);
  return answer;
}

Json RcCalls::Delete(const Request& request, const Progress&) {
  robot_->DeleteMotion(RequestReader(request).At("name").Text());
  return Json::object();
}

Json RcCalls::Download(const Request& request, const Progress&) {
  const std::string name = RequestReader(request).At("name").Text();
  return {{"data", ToBase64(robot_->Download(rcfileMOTION, name))}};
}

Json RcCalls::Motors(const Request& request, const Progress&) {
  robot_->SwitchMotor(RC_ALL_JOINTS, RequestReader(request).At("on").Bool());
  return Json::object();
}

Json RcCalls::Power(const Request&, const Progress&) {
  return remote::PowerJson(robot_->GetPower());
}

Json RcCalls::Reboot(const Request&, const Progress&) {
  robot_->Reboot();
  return Json::object();
}

Json RcCalls::Shutdown(const Request&, const Progress&) {
  robot_->Shutdown();
  return Json::object();
}

Json RcCalls::Sensors(const Request&, const Progress&) {
  if (sensors_ == nullptr) sensors_ = std::make_unique<remote::SensorFormat>(robot_.get());
  return sensors_->ToJson(robot_->GetSensors());
}

}  // namespace openr_host
