// A robot behind the requests of the remote control, for tests of RequestHandler.
#pragma once

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "MoverState.h"
#include "RequestHandler.h"
#include "mtn_bytes.h"

namespace openr_host {

// Remembers the commands that RequestHandler has sent.
class RemoteRobot : public RequestPort {
 public:
  RemoteRobot() : handler(this) {
    handler.Begin(FindRobot("ERS-210"));
    SensorValues values = {};
    values.frame = frame;
    for (int j = 0; j < MAX_JOINTS; ++j) values.joint[j] = j * 17453;
    for (int i = 0; i < MAX_SENSORS; ++i) values.sensor[i] = 100 + i;
    handler.SetSensors(values);
    Say(moverACCEPTING_COMMANDS, -1);
  }

  bool PostMover(const MoverCommand& command) override {
    if (full) return false;
    commands.push_back(command);
    return true;
  }
  void PostLedEar(const LedEarState& change) override { lights.push_back(change); }
  bool ReadFile(const std::string& path, std::vector<Uint8>* bytes, std::string* error) override {
    if (!files.contains(path)) {
      *error = path + ": no such file on the Memory Stick";
      return false;
    }
    *bytes = files[path];
    return true;
  }
  void ReadBattery(Sint32* capacity, Sint32* temperature) override {
    *capacity = 87;
    *temperature = 2500;
  }
  bool ReadPower(RcPower* power) override {
    *power = {0x12345678, 0x90, 87, 2000, 7400, -1300, 2500};
    return tells_power;
  }
  bool ReadGains(int joint, Uint16 gains[6]) override {
    for (int i = 0; i < 6; ++i) gains[i] = limp ? 0 : FindRobot("ERS-210")->joints[joint].gain[i];
    return !limp;
  }
  void WantImage(bool wanted) override { wants_image = wanted; }
  void EndRun(bool) override {}

  void Say(int state, int key_frame, bool motors_off = false) {
    SetValueMessage message = {};
    message.state = state;
    message.keyFrame = key_frame;
    message.motorsOff = motors_off ? 1 : 0;
    handler.SetMover(message);
  }

  // Sends a request and returns the status; the answer's payload is in `payload`.
  int Ask(int command, const std::vector<uint8_t>& request, int version = RC_VERSION,
          int client = 0) {
    const std::vector<uint8_t> bytes = Packet(command, request, version);
    RcFramer framer;
    framer.Append(bytes.data(), static_cast<int>(bytes.size()));
    EXPECT_EQ(framer.Next(), RcFramer::PACKET);
    uint8_t answer[RC_MAX_PACKET];
    RcWriter out(answer, RC_MAX_PACKET);
    handler.Answer(client, framer, &out);
    return ReadAnswer(answer, out.Size(), command, 4711);
  }

  int ReadAnswer(const uint8_t* answer, int size, int command, int tag) {
    RcFramer framer;
    framer.Append(answer, size);
    EXPECT_EQ(framer.Next(), RcFramer::PACKET);
    RcAnswerHeader header;
    EXPECT_TRUE(header.Read(framer));
    EXPECT_EQ(header.frame, frame) << "every answer carries the frame number";
    version = header.header.version;
    EXPECT_EQ(header.header.command, command);
    EXPECT_EQ(header.header.tag, tag);
    payload.assign(answer + RC_ANSWER_HEADER_SIZE, answer + size);
    error.clear();
    if (header.status != rcOK) {
      RcReader in(payload.data(), static_cast<int>(payload.size()));
      error = in.String();
      EXPECT_TRUE(in.IsComplete());
      EXPECT_NE(error, "");
    }
    return header.status;
  }

  static std::vector<uint8_t> Packet(int command, const std::vector<uint8_t>& payload,
                                     int version = RC_VERSION_FILES, int tag = 4711) {
    std::vector<uint8_t> bytes(RC_MAX_PACKET);
    RcWriter out(bytes.data(), RC_MAX_PACKET);
    for (int i = 0; i < RC_HEADER_SIZE; ++i) out.U8(0);
    out.Bytes(payload.data(), static_cast<int>(payload.size()));
    out.PutHeader(command, tag, version);
    bytes.resize(static_cast<size_t>(out.Size()));
    return bytes;
  }

  template <class Message>
  Message Payload() {
    Message message{};
    RcReader in(payload.data(), static_cast<int>(payload.size()));
    EXPECT_TRUE(message.Read(&in));
    return message;
  }
  int32_t Number() {
    RcReader in(payload.data(), static_cast<int>(payload.size()));
    const int32_t number = in.S32();
    EXPECT_TRUE(in.IsComplete());
    return number;
  }
  static std::vector<uint8_t> JointValue(int joint, int32_t value) {
    std::vector<uint8_t> bytes{static_cast<uint8_t>(joint)};
    Append32(&bytes, static_cast<uint32_t>(value));
    return bytes;
  }
  static std::vector<uint8_t> PlayRequest(const std::string& file, int loops = 1) {
    std::vector<uint8_t> bytes;
    AppendString(&bytes, file);
    Append16(&bytes, loops);
    bytes.push_back(0);
    return bytes;
  }
  void AddMotion(const std::string& name, const std::vector<uint8_t>& bytes) {
    files["/MS/OPEN-R/MW/DATA/P/" + name] = bytes;
  }

  RequestHandler handler;
  std::vector<MoverCommand> commands;
  std::vector<LedEarState> lights;
  std::map<std::string, std::vector<uint8_t>> files;
  bool full = false;
  uint32_t frame = 2500;  // frame number that every answer must have
  bool tells_power = true;
  bool wants_image = false;
  bool limp = false;  // whether the gains are disabled
  std::vector<uint8_t> payload;
  std::string error;
  int version = 0;  // protocol version of the last answer
};

}  // namespace openr_host
