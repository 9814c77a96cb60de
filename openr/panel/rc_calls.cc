#include "openr/panel/rc_calls.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include "openr/panel/base64.h"
#include "openr/remote/file_checks.h"
#include "openr/remote/power_format.h"
#include "openr/remote/remote_files.h"
#include "openr/remote/sensor_format.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kRemoteTimeoutMs = 3000;
constexpr double kCdegPerDeg = 100;
constexpr double kValueMax = 1e6;  // in degrees; a value in 0.01 degree fits into 32 bits

// The payload of MOVE, SPEED and ACCEL.
struct JointRequest {
  int joint;
  Sint32 value;
  void Write(RcWriter* out) const {
    out->U8(static_cast<Uint32>(joint));
    out->S32(value);
  }
};

double Degrees(Sint32 value_cdeg) { return value_cdeg / kCdegPerDeg; }

// Returns the member of a request as text: a device is named by text or by its number.
std::string TextOf(const nlohmann::json& request, const char* member) {
  const nlohmann::json& value = request.at(member);
  return value.is_number_integer() ? std::to_string(value.get<int64_t>())
                                   : value.get<std::string>();
}

std::string UpperCase(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

Json JointJson(const RcDescription& joint, const RcJointState& state) {
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

Json NamesJson(const std::vector<RcDescription>& devices) {
  Json names = Json::array();
  for (const RcDescription& device : devices)
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
    const Call call = FindCall(request.at("call").get<std::string>());
    Client();
    try {
      return (this->*call)(request, progress);
    } catch (const RemoteRefusal&) {
      // These calls send several requests at once, and answers behind the refusal are still to
      // come.
      if (call == &RcCalls::Upload || call == &RcCalls::Connect) Disconnect();
      throw;
    } catch (const RemoteFailure&) {
      Disconnect();
      throw;
    }
  } catch (const RemoteRefusal& refusal) {
    return {{"error", refusal.what()}, {"status", refusal.status}};
  } catch (const std::exception& error) {
    return {{"error", error.what()}};
  }
}

RemoteClient* RcCalls::Client(int version) {
  if (client_ == nullptr)
    client_ = std::make_unique<RemoteClient>(find_address_(), kRemoteTimeoutMs);
  client_->UseVersion(version);
  return client_.get();
}

void RcCalls::Disconnect() {
  sensors_.reset();
  for (auto& devices : devices_) devices.reset();
  client_.reset();
}

// Returns INFO of version 2, or that of version 1 from a robot that serves no other.
RcInfo RcCalls::Info() {
  try {
    return AskFileInfo(Client(RC_VERSION_FILES));
  } catch (const RemoteRefusal& refusal) {
    if (refusal.status != rcerrorVERSION) throw;
  }
  return Client()->Read<RcInfo>(client_->Request(rcINFO));
}

const RemoteDevices& RcCalls::Devices(RcDeviceKind kind) {
  if (!devices_[kind]) devices_[kind].emplace(Client(), kind);
  return *devices_[kind];
}

Json RcCalls::Connect(const Request&, const Progress&) {
  const RcInfo info = Info();
  const std::vector<RcDescription>& joints = Devices(rcdeviceJOINT).all();
  std::vector<std::vector<uint8_t>> questions;
  for (size_t i = 0; i < joints.size(); ++i) questions.push_back({static_cast<uint8_t>(i)});
  const std::vector<RemoteAnswer> states = Client()->RequestAll(rcGET, questions);
  Json all = Json::array();
  for (size_t i = 0; i < joints.size(); ++i)
    all.push_back(JointJson(joints[i], client_->Read<RcJointState>(states[i])));
  Json sensors = Json::array();
  for (const RcDeviceKind kind : {rcdeviceBINARY, rcdeviceOTHER}) {
    for (const RcDescription& sensor : Devices(kind).all()) {
      sensors.push_back({{"name", sensor.name},
                         {"title", sensor.title},
                         {"unit", SensorUnit(sensor)},
                         {"kind", kind == rcdeviceBINARY ? "binary" : "other"}});
    }
  }
  return {{"robot", info.design},
          {"state", StateName(info.state)},
          {"processor", info.hasFiles ? info.processor : 0},
          {"joints", std::move(all)},
          {"leds", NamesJson(Devices(rcdeviceLED).all())},
          {"ears", NamesJson(Devices(rcdeviceEAR).all())},
          {"sensors", std::move(sensors)}};
}

Json RcCalls::JointValue(int command, const Request& request, const char* member) {
  const int joint = Devices(rcdeviceJOINT).Find(TextOf(request, "joint"));
  const double value = request.at(member).get<double>();
  if (!(std::abs(value) < kValueMax))
    throw std::runtime_error(fmt::format("'{}' must be a number of degrees below 1000000", member));
  const auto value_cdeg = static_cast<Sint32>(std::lround(value * kCdegPerDeg));
  const RemoteAnswer answer = Client()->RequestWith(command, JointRequest{joint, value_cdeg});
  RcReader reader(answer.payload.data(), static_cast<int>(answer.payload.size()));
  return {{"value", Degrees(reader.S32())}};
}

Json RcCalls::Move(const Request& request, const Progress&) {
  return JointValue(rcMOVE, request, "deg");
}

Json RcCalls::Speed(const Request& request, const Progress&) {
  return JointValue(rcSPEED, request, "value");
}

Json RcCalls::Accel(const Request& request, const Progress&) {
  return JointValue(rcACCEL, request, "value");
}

Json RcCalls::Switch(int command, RcDeviceKind kind, const Request& request) {
  const int index = Devices(kind).Find(TextOf(request, "index"));
  const bool is_on = request.at("on").get<bool>();
  Client()->Request(command, {static_cast<uint8_t>(index), static_cast<uint8_t>(is_on)});
  return Json::object();
}

Json RcCalls::Led(const Request& request, const Progress&) {
  return Switch(rcLED, rcdeviceLED, request);
}

Json RcCalls::Ear(const Request& request, const Progress&) {
  return Switch(rcEAR, rcdeviceEAR, request);
}

Json RcCalls::Motions(const Request&, const Progress&) {
  uint32_t frame = 0;
  Json motions = Json::array();
  for (const RcListEntry& motion : ListMotions(Client(RC_VERSION_FILES), &frame))
    motions.push_back({{"name", motion.name}, {"size", motion.size}});
  return {{"motions", motions}};
}

Json RcCalls::Play(const Request& request, const Progress&) {
  const int64_t loops = request.value("loops", int64_t{1});
  if (loops < 1 || loops > 65535) throw std::runtime_error("'loops' must be from 1 to 65535");
  RcPlayRequest play;
  play.file = request.at("name").get<std::string>();
  play.loops = static_cast<Uint16>(loops);
  play.keyFramesPerVector = 0;  // the robot's own choice
  const auto answer = client_->Read<RcPlayAnswer>(Client()->RequestWith(rcMTN_PLAY, play));
  return {{"duration_s", answer.durationMs / 1000.0},
          {"key_frames", answer.keyFrames},
          {"loops", answer.loops}};
}

Json RcCalls::Stop(const Request&, const Progress&) {
  Client()->Request(rcMTN_STOP);
  return Json::object();
}

Json RcCalls::Upload(const Request& request, const Progress& progress) {
  const std::string kind = request.at("kind").get<std::string>();
  std::string name = UpperCase(request.at("name").get<std::string>());
  std::optional<std::string> bytes = FromBase64(request.at("data").get_ref<const std::string&>());
  if (!bytes) throw std::runtime_error("'data' is no Base64");
  const RcInfo info = AskFileInfo(Client(RC_VERSION_FILES));
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
  if (plays) name = FreeName();
  UploadFile(client_.get(), file_kind, name, *bytes,
             [&progress, size](size_t sent) { progress(sent, size); });
  if (plays) return PlayAndDelete({{"name", name}, {"loops", request["loops"]}});
  return {{"name", name}, {"size", size}};
}

// Returns a name for a file that is on the stick only while its motion begins.
std::string RcCalls::FreeName() {
  uint32_t frame = 0;
  const std::vector<RcListEntry> motions = ListMotions(Client(RC_VERSION_FILES), &frame);
  for (int i = 0; i <= 99; ++i) {
    std::string name = fmt::format("PANEL{}.MTN", i);
    if (std::none_of(motions.begin(), motions.end(),
                     [&](const RcListEntry& motion) { return motion.name == name; }))
      return name;
  }
  throw std::runtime_error("the stick has all motions from PANEL0.MTN to PANEL99.MTN already");
}

// Plays a motion, and deletes its file as soon as JointMover has read it.
Json RcCalls::PlayAndDelete(const Request& request) {
  const RcFileName name = {rcfileMOTION, request.at("name").get<std::string>()};
  Json answer;
  try {
    answer = Play(request, {});
  } catch (const RemoteRefusal&) {
    Client(RC_VERSION_FILES)->RequestWith(rcDELETE, name);
    throw;
  }
  const uint32_t begin = Client()->Request(rcSENSORS).frame;
  // JointMover reads the file a moment after the answer.
  constexpr int kAsksMax = 100;
  for (int i = 0; i < kAsksMax; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (Client()->Request(rcSENSORS).frame - begin >= 4 * RC_FRAMES_PER_VECTOR) break;
  }
  Client(RC_VERSION_FILES)->RequestWith(rcDELETE, name);
  return answer;
}

Json RcCalls::Delete(const Request& request, const Progress&) {
  const RcFileName name = {rcfileMOTION, request.at("name").get<std::string>()};
  Client(RC_VERSION_FILES)->RequestWith(rcDELETE, name);
  return Json::object();
}

Json RcCalls::Download(const Request& request, const Progress&) {
  uint32_t frame = 0;
  const std::string name = request.at("name").get<std::string>();
  const std::string bytes = DownloadFile(Client(RC_VERSION_FILES), rcfileMOTION, name, &frame);
  return {{"data", ToBase64(bytes)}};
}

Json RcCalls::Motors(const Request& request, const Progress&) {
  const int command = request.at("on").get<bool>() ? rcMOTOR_ON : rcMOTOR_OFF;
  Client(RC_VERSION_FILES)->Request(command, {RC_ALL_JOINTS});
  return Json::object();
}

Json RcCalls::Power(const Request&, const Progress&) {
  return PowerJson(client_->Read<RcPower>(Client(RC_VERSION_FILES)->Request(rcPOWER)));
}

Json RcCalls::Reboot(const Request&, const Progress&) {
  Client(RC_VERSION_FILES)->Request(rcREBOOT);
  return Json::object();
}

Json RcCalls::Shutdown(const Request&, const Progress&) {
  Client(RC_VERSION_FILES)->Request(rcSHUTDOWN);
  return Json::object();
}

Json RcCalls::Sensors(const Request&, const Progress&) {
  if (sensors_ == nullptr) sensors_ = std::make_unique<SensorFormat>(Client());
  return sensors_->ToJson(client_->Read<RcSensors>(Client()->Request(rcSENSORS)));
}

}  // namespace openr_host
