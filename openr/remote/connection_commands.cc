// The part of Connection for devices, joints, lights, sensors, motions, and the end of the run.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "openr/remote/connection.h"

namespace openr::remote {
namespace {

constexpr double kCdegPerDegree = 100;
// Largest joint position, speed or acceleration that is sent, in degrees, degrees/s or degrees/s^2.
// Larger values in 0.01 degree might not fit into 32 bits.
constexpr double kValueMax = 1e6;

}  // namespace

// ---- Functions that describe the robot and its devices

Info Connection::GetInfo() {
  const Answer answer = WaitForAny(Send(rcINFO, {}, RC_VERSION_FILES));
  // Asks again for the description of the robot with version 1 of the protocol if the robot knows
  // no later version.  The answer to version 1 has fewer fields.
  if (answer.status == rcerrorVERSION) return Read<Info>(Request(rcINFO));
  if (answer.status != rcOK) throw Error(answer.status, answer.frame, answer.error);
  return Read<Info>(answer);
}

const std::vector<Description>& Connection::Devices(RcDeviceKind kind) {
  std::optional<std::vector<Description>>& known = devices_[kind];
  if (known) return *known;
  const Info info = Read<Info>(Request(rcINFO));
  const int counts[] = {info.numJoints, info.numLeds, info.numEars, info.numBinary, info.numOther};
  std::vector<Bytes> questions;
  for (int i = 0; i < counts[kind]; ++i) {
    questions.push_back({static_cast<uint8_t>(kind), static_cast<uint8_t>(i)});
  }
  std::vector<Description> devices;
  for (const Answer& answer : RequestAll(rcDESCRIBE, questions)) {
    devices.push_back(Read<Description>(answer));
  }
  known = std::move(devices);
  return *known;
}

int Connection::Find(RcDeviceKind kind, const std::string& name) {
  const std::vector<Description>& all = Devices(kind);
  std::string list;
  for (size_t i = 0; i < all.size(); ++i) {
    const Description& device = all[i];
    if (name == device.name || name == device.title || name == device.locator ||
        name == std::to_string(i)) {
      return static_cast<int>(i);
    }
    list += fmt::format("\n  {} {}", i, device.name);
  }
  throw Error(ErrorCode::kNoDevice, fmt::format("the robot has no '{}'", name),
              fmt::format("there are{}", list));
}

// ---- Functions that read and command joints, lights and ears

JointState Connection::GetJoint(int joint) {
  return Read<JointState>(Request(rcGET, {static_cast<uint8_t>(joint)}));
}

Call Connection::JointCall(RcCommand command, int joint, double value) {
  const double limited = std::clamp(value, -kValueMax, kValueMax);
  uint8_t bytes[5];
  RcWriter writer(bytes, sizeof bytes);
  writer.U8(static_cast<Uint32>(joint));
  writer.S32(static_cast<Sint32>(std::lround(limited * kCdegPerDegree)));
  return {command, {bytes, bytes + sizeof bytes}};
}

double Connection::InForce(const Answer& answer) const {
  RcReader reader(answer.payload.data(), static_cast<int>(answer.payload.size()));
  const Sint32 value = reader.S32();
  if (!reader.IsComplete()) ThrowMalformed();
  return value / kCdegPerDegree;
}

double Connection::Move(int joint, double degrees) {
  return InForce(Request(rcMOVE, JointCall(rcMOVE, joint, degrees).payload));
}

double Connection::SetSpeed(int joint, double degrees_per_s) {
  return InForce(Request(rcSPEED, JointCall(rcSPEED, joint, degrees_per_s).payload));
}

double Connection::SetAcceleration(int joint, double degrees_per_s2) {
  return InForce(Request(rcACCEL, JointCall(rcACCEL, joint, degrees_per_s2).payload));
}

void Connection::SetLed(int led, bool on) {
  Request(rcLED, {static_cast<uint8_t>(led), static_cast<uint8_t>(on)});
}

void Connection::SetEar(int ear, bool on) {
  Request(rcEAR, {static_cast<uint8_t>(ear), static_cast<uint8_t>(on)});
}

void Connection::SwitchMotor(int joint, bool on) {
  Request(on ? rcMOTOR_ON : rcMOTOR_OFF, {static_cast<uint8_t>(joint)});
}

Gains Connection::GetGains(int joint) {
  return Read<Gains>(Request(rcGAINS, {static_cast<uint8_t>(joint)}));
}

Gains Connection::SetGains(int joint, int p, int i, int d) {
  uint8_t bytes[7];
  RcWriter writer(bytes, sizeof bytes);
  writer.U8(static_cast<Uint32>(joint));
  for (const int gain : {p, i, d}) writer.U16(static_cast<Uint32>(gain));
  return Read<Gains>(Request(rcGAINS, {bytes, bytes + sizeof bytes}));
}

// ---- Functions that read sensors and power

Sensors Connection::GetSensors() { return Read<Sensors>(Request(rcSENSORS)); }

Power Connection::GetPower() { return Read<Power>(Request(rcPOWER)); }

// ---- Functions that play motions

PlayAnswer Connection::PlayMotion(const std::string& name, int loops, int key_frames_per_vector) {
  RcPlayRequest request;
  request.file = name;
  request.loops = static_cast<Uint16>(loops);
  request.keyFramesPerVector = static_cast<Uint8>(key_frames_per_vector);
  return Read<PlayAnswer>(Request(rcMTN_PLAY, BytesOf(request)));
}

void Connection::StopMotion() { Request(rcMTN_STOP); }

// ---- Functions that end the run

void Connection::Reboot() { Request(rcREBOOT); }

void Connection::Shutdown() { Request(rcSHUTDOWN); }

}  // namespace openr::remote
