#include "tests/fuzz/remote_driver.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

#include "ByteOrder.h"
#include "Crc32.h"
#include "MoverState.h"
#include "StickFile.h"
#include "tests/fuzz/fuzz_targets.h"
#include "tests/objects/mtn_bytes.h"

namespace openr_host {
namespace {

// The client that only asks for INFO, and must get its answer whatever the others do.
constexpr int kWitness = RC_PLACES - 1;

// A motion that the robot can play, which the steps upload.
const std::string& GoodMotion() {
  static const auto bytes =
      MtnBytes::OneJoint("PRM:/r1/c1-Joint2:j1", std::vector<int32_t>(300, 1000)).Bytes();
  static const std::string motion(bytes.begin(), bytes.end());
  return motion;
}

// The beginning of an image of this host, as long as the motion.  The robot accepts no other bytes
// as an image.
const std::string& GoodImage() {
  static const std::string image = [] {
    std::string bytes = "\177ELF";
    bytes.resize(GoodMotion().size());
    bytes[4] = 2;      // 64 bits
    bytes[5] = 1;      // little-endian
    bytes[18] = 0x3e;  // x86-64
    return bytes;
  }();
  return image;
}

uint32_t CrcOf(const std::string& bytes) {
  return Crc32(0, reinterpret_cast<const Uint8*>(bytes.data()), static_cast<int>(bytes.size()));
}

uint32_t CrcOfUpload(bool is_image) {
  static const uint32_t image = CrcOf(GoodImage()), motion = CrcOf(GoodMotion());
  return is_image ? image : motion;
}

// Commands that programs send most often; others are named by their number.
constexpr uint8_t kCommands[] = {
    rcINFO,        rcDESCRIBE,  rcGET,      rcMOVE,     rcSPEED,     rcACCEL,        rcLED,
    rcEAR,         rcSENSORS,   rcMTN_PLAY, rcMTN_STOP, rcMTN_LIST,  rcUPLOAD_BEGIN, rcUPLOAD_DATA,
    rcUPLOAD_END,  rcDELETE,    rcDOWNLOAD, rcLOG,      rcREBOOT,    rcSHUTDOWN,     rcBATCH,
    rcGAINS,       rcMOTOR_OFF, rcMOTOR_ON, rcPOWER,    rcSUBSCRIBE, rcUNSUBSCRIBE,  rcCAMERA,
    rcCAMERA_PART, rcEVENT,     rcTRACK};

std::string PacketBytes(int command, const std::string& payload, int tag, int version) {
  uint8_t bytes[RC_MAX_PACKET];
  RcWriter out(bytes, RC_MAX_PACKET);
  for (int i = 0; i < RC_HEADER_SIZE; ++i) out.U8(0);
  out.Bytes(reinterpret_cast<const Uint8*>(payload.data()), static_cast<int>(payload.size()));
  out.PutHeader(command, tag, version);
  return {reinterpret_cast<char*>(bytes), static_cast<size_t>(out.Size())};
}

void Append(std::string* bytes, uint32_t value, int count) {
  for (int i = 0; i < count; ++i) *bytes += static_cast<char>(value >> (8 * i));
}

}  // namespace

RemoteDriver::RemoteDriver(FuzzStick* stick)
    : stick_(stick),
      handler_(new RequestHandler(this)) {  // make_unique() may not convert to a private base
  handler_->Begin(FindRobot("ERS-210"), stick->root());
  for (int i = 0; i < RequestHandler::MAX_CLIENTS; ++i) {
    clients_.push_back(std::make_unique<Client>());
  }
  PassTime();
  Open(kWitness);
}

RemoteDriver::~RemoteDriver() = default;

uint8_t RemoteDriver::Byte() { return at_ < size_ ? program_[at_++] : 0; }

void RemoteDriver::Run(const uint8_t* program, size_t size) {
  program_ = program;
  size_ = size;
  at_ = 0;
  while (at_ < size_) {
    BeginFuzzStep(at_);
    const uint8_t kind = program_[at_] >> 4;
    Step();
    // Bytes that a client has only written have not reached the robot yet.
    const bool is_written_only = kind >= 1 && kind <= 7;
    if (!is_written_only) AskWitness();
  }
  Finish();
}

void RemoteDriver::Step() {
  const uint8_t step = Byte();
  int index = step % RequestHandler::MAX_CLIENTS;
  if (index == kWitness) index = RC_PLACES;  // the client that waits for a place
  Client* const client = clients_[static_cast<size_t>(index)].get();
  if (!client->is_open) Open(index);
  switch (step >> 4) {
    case 0:
      return Close(index);
    case 1:
    case 2:
    case 3:
      return WriteRequest(client);
    case 4:
    case 5:
      return WriteUpload(client);
    case 6:
      return WriteBatch(client);
    case 7:  // any bytes
      for (int count = Byte() % 32; count > 0; --count)
        client->written += static_cast<char>(Byte());
      return;
    case 8:
    case 9:
      return LetArrive(index, Byte());
    case 10:
    case 11:
      return LetArrive(index, client->written.size());
    case 12:
    case 13:
      return EndSend(index);
    default:
      return PassTime();
  }
}

// ---- What RCServer does with its endpoints

void RemoteDriver::Open(int index) {
  Client* const client = clients_[static_cast<size_t>(index)].get();
  *client = Client();
  client->is_open = true;
  client->session.Begin(index, handler_.get());
  client->session.SetWaiting(index == RC_PLACES);
  client->is_receiving = true;
}

void RemoteDriver::Close(int index) {
  Client* const client = clients_[static_cast<size_t>(index)].get();
  if (!client->is_open) return;
  client->session.End();
  client->is_open = false;
  client->questions.clear();
}

void RemoteDriver::LetArrive(int index, size_t count) {
  Client* const client = clients_[static_cast<size_t>(index)].get();
  count = std::min({count, client->written.size(), static_cast<size_t>(RC_MAX_PACKET)});
  if (count == 0 || !client->is_receiving) return;
  const std::string bytes = client->written.substr(0, count);
  client->written.erase(0, count);
  client->is_receiving = false;
  client->session.Receive(reinterpret_cast<const Uint8*>(bytes.data()), static_cast<int>(count));
  NoteRequests(client, bytes);
  Serve(index);
}

void RemoteDriver::Serve(int index) {
  Client* const client = clients_[static_cast<size_t>(index)].get();
  if (client->is_sending) return;
  int size = client->session.NextAnswers(client->buffer);
  if (size == 0) client->is_receiving = true;
  if (size == 0) size = client->session.NextEvents(client->buffer);
  if (size == 0) return;
  if (size < 0 || size > RC_MAX_PACKET) throw Violation(fmt::format("a send of {} bytes", size));
  client->is_sending = true;
  client->sent.assign(reinterpret_cast<const char*>(client->buffer), static_cast<size_t>(size));
}

void RemoteDriver::EndSend(int index) {
  Client* const client = clients_[static_cast<size_t>(index)].get();
  if (!client->is_open || !client->is_sending) return;
  if (std::memcmp(client->buffer, client->sent.data(), client->sent.size()) != 0) {
    throw Violation("bytes were changed while they were being sent");
  }
  client->is_sending = false;
  HearPackets(client);
  if (client->session.IsLast()) {
    if (!client->questions.empty()) throw Violation("a client is closed before its answer");
    Close(index);
  } else {
    Serve(index);
  }
}

// Lets a sensor vector come, sometimes with a report of JointMover or an image.
void RemoteDriver::PassTime() {
  const uint8_t what = Byte();
  frame_ += 4 * (1 + what % 8U);
  SensorValues values = {};
  values.frame = frame_;
  handler_->SetSensors(values);
  if ((what & 0x08) != 0) {
    SetValueMessage report = {};
    report.state = what % 16 == 15 ? moverCROUCHING : moverACCEPTING_COMMANDS;
    report.keyFrame = (what & 0x10) != 0 ? what : -1;
    if (report.keyFrame >= 0) report.state = moverMTN;
    handler_->SetMover(report);
  }
  is_mover_full_ = what % 32 == 31;
  if ((what & 0x40) != 0 && handler_->WantedLayer() >= 0) {
    const std::vector<uint8_t> image(44 * 36 * 6);
    handler_->SetPicture({frame_, 44, 36, image.data(), static_cast<Uint32>(image.size())});
    if (wants_image_) throw Violation("the camera goes on though the picture is there");
  }
  for (int i = 0; i < RequestHandler::MAX_CLIENTS; ++i) {
    if (clients_[static_cast<size_t>(i)]->is_open && handler_->HasEvents(i)) Serve(i);
  }
}

// ---- What clients write

void RemoteDriver::WritePacket(Client* client, int command, const std::string& payload,
                               int version) {
  client->written += PacketBytes(command, payload, ++tag_, version);
}

void RemoteDriver::WriteRequest(Client* client) {
  const uint8_t number = Byte();
  const int command = number < 0xe0 ? kCommands[number % std::size(kCommands)] : Byte();
  const int version = number % 7 == 0 ? RC_VERSION : RC_VERSION_FILES;
  std::string payload;
  for (int count = Byte() % 16; count > 0; --count) payload += static_cast<char>(Byte());
  WritePacket(client, command, payload, version);
}

// Writes a packet of an upload that succeeds when nothing comes between, or of a list, a download
// or a removal.
void RemoteDriver::WriteUpload(Client* client) {
  const uint8_t kind = Byte();
  const std::string name = fmt::format("F{}.MTN", kind / 16 % 3);
  std::string payload;
  if (kind % 8 == 0) {
    client->upload_offset = 0;
    client->is_image = kind % 16 == 8;
  }
  const std::string& file = client->is_image ? GoodImage() : GoodMotion();
  if (kind % 8 == 0) {
    Append(&payload, client->is_image ? rcfileIMAGE : rcfileMOTION, 1);
    const std::string given = client->is_image ? "CONTROLL.BIN" : name;
    payload += static_cast<char>(given.size()) + given;
    Append(&payload, static_cast<uint32_t>(file.size()), 4);
    Append(&payload, CrcOfUpload(client->is_image), 4);
    WritePacket(client, rcUPLOAD_BEGIN, payload, RC_VERSION_FILES);
  } else if (kind % 8 < 5 && client->upload_offset < file.size()) {
    Append(&payload, client->upload_offset, 4);
    payload += file.substr(client->upload_offset, RC_MAX_UPLOAD_DATA);
    client->upload_offset = static_cast<uint32_t>(
        std::min(file.size(), client->upload_offset + size_t{RC_MAX_UPLOAD_DATA}));
    WritePacket(client, rcUPLOAD_DATA, payload, RC_VERSION_FILES);
  } else if (kind % 8 <= 5) {
    WritePacket(client, rcUPLOAD_END, "", RC_VERSION_FILES);
  } else {
    payload = std::string(1, 0) + static_cast<char>(name.size()) + name;
    if (kind % 8 == 6) Append(&payload, 0, 4);
    WritePacket(client, kind % 8 == 6 ? rcDOWNLOAD : rcDELETE, payload, RC_VERSION_FILES);
  }
}

void RemoteDriver::WriteBatch(Client* client) {
  std::string batch;
  for (int count = Byte() % 28; count > 0; --count) {
    const uint8_t number = Byte();
    std::string payload;
    for (int rest = number % 8; rest > 0; --rest) payload += static_cast<char>(Byte());
    batch += PacketBytes(kCommands[number / 8 % std::size(kCommands)], payload, number,
                         number % 5 == 0 ? RC_VERSION : RC_VERSION_FILES);
  }
  WritePacket(client, rcBATCH, batch.substr(0, RC_MAX_PACKET - RC_HEADER_SIZE), RC_VERSION_FILES);
}

// ---- The robot

bool RemoteDriver::PostMover(const MoverCommand& command) {
  if (command.joint < MOVER_ALL_JOINTS || command.joint >= 18) {
    throw Violation(fmt::format("a command for joint {}", command.joint));
  }
  return !is_mover_full_;
}

bool RemoteDriver::ReadFile(const std::string& path, std::vector<Uint8>* bytes,
                            std::string* error) {
  return ReadStickFile(stick_->root() + path, bytes, error);
}

void RemoteDriver::ReadBattery(Sint32* capacity, Sint32* temperature) {
  *capacity = 50;
  *temperature = 2500;
}

bool RemoteDriver::ReadPower(RcPower* power) {
  *power = {};
  return true;
}

bool RemoteDriver::ReadGains(int joint, Uint16 gains[6]) {
  if (joint < 0 || joint >= 18) throw Violation(fmt::format("gains of joint {}", joint));
  std::fill_n(gains, 6, Uint16{1});
  return true;
}

}  // namespace openr_host
