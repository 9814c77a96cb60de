// The checks of RemoteDriver: of the answers that clients hear, and of the files of the stick.
#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <set>

#include "ByteOrder.h"
#include "runtime/base/hasher.h"
#include "tests/fuzz/remote_driver.h"

namespace openr_host {
namespace {

constexpr char kMotions[] = "MS/OPEN-R/MW/DATA/P/";
constexpr char kImages[] = "MS/OPEN-R/MW/OBJS/";

std::string BytesOfFile(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

}  // namespace

// ---- Answers

// Finds the whole packets in the bytes that have arrived, as docs/remote-control.md has them.
void RemoteDriver::NoteRequests(Client* client, const std::string& bytes) {
  client->arrived += bytes;
  std::string& rest = client->arrived;
  while (!client->is_over && rest.size() >= 2) {
    const auto* const packet = reinterpret_cast<const Uint8*>(rest.data());
    const bool has_header = rest.size() >= static_cast<size_t>(RC_HEADER_SIZE);
    const int size = has_header ? GetU16(packet + 2) : 0;
    const bool is_broken = GetU16(packet) != RC_MAGIC ||
                           (has_header && (size < RC_HEADER_SIZE || size > RC_MAX_PACKET));
    if (is_broken) {
      client->questions.push_back({0, 0, true});
      client->is_over = true;
      return;
    }
    if (!has_header || rest.size() < static_cast<size_t>(size)) return;
    const int version = packet[4];
    const int command = packet[5];
    const bool ends_run = version == RC_VERSION_FILES && size == RC_HEADER_SIZE &&
                          (command == rcREBOOT || command == rcSHUTDOWN);
    const bool is_last = ends_run || client->session.IsWaiting();
    if (version != RC_VERSION_FILES || command != rcEVENT || client->session.IsWaiting()) {
      client->questions.push_back({static_cast<uint8_t>(command), GetU16(packet + 6), is_last});
    }
    client->is_over = is_last;
    rest.erase(0, static_cast<size_t>(size));
  }
}

void RemoteDriver::HearPackets(Client* client) {
  std::string bytes;
  bytes.swap(client->sent);
  for (size_t at = 0; at < bytes.size();) {
    const auto* const packet = reinterpret_cast<const Uint8*>(bytes.data()) + at;
    const size_t size =
        bytes.size() - at >= static_cast<size_t>(RC_ANSWER_HEADER_SIZE) ? GetU16(packet + 2) : 0;
    if (size < static_cast<size_t>(RC_ANSWER_HEADER_SIZE) || size > bytes.size() - at ||
        GetU16(packet) != RC_MAGIC) {
      throw Violation("a send is no row of whole packets");
    }
    HearPacket(client, bytes.substr(at, size));
    at += size;
  }
}

void RemoteDriver::HearPacket(Client* client, const std::string& packet) {
  const auto* const bytes = reinterpret_cast<const Uint8*>(packet.data());
  RcHeader header;
  header.Read(bytes);
  const int status = GetU16(bytes + 12);
  if (status > rcerrorNO_PICTURE) throw Violation(fmt::format("status {}", status));
  if (GetU32(bytes + 8) > frame_) throw Violation("a frame that has not come yet");
  const int payload_size = static_cast<int>(packet.size()) - RC_ANSWER_HEADER_SIZE;
  if (status != rcOK) {
    RcReader in(bytes + RC_ANSWER_HEADER_SIZE, payload_size);
    if (in.String().empty() || !in.IsComplete()) {
      throw Violation(fmt::format("status {} without a text", status));
    }
  }
  const bool is_event = header.command == rcEVENT && status == rcOK;
  if (is_event) {
    client->events += 1;
    return;
  }
  if (client->questions.empty()) {
    throw Violation(fmt::format("an answer to {:#04x} that nobody has asked", header.command));
  }
  const Expected expected = client->questions.front();
  client->questions.pop_front();
  if (header.command != expected.command || header.tag != expected.tag) {
    throw Violation(fmt::format("an answer to {:#04x}, tag {}, in place of {:#04x}, tag {}",
                                header.command, header.tag, expected.command, expected.tag));
  }
}

// Lets one client ask for INFO after each step in which bytes of the others arrive or time passes.
// It must get its answer at once.
void RemoteDriver::AskWitness() {
  constexpr int kIndex = RC_PLACES - 1;
  Client* const witness = clients_[kIndex].get();
  WritePacket(witness, rcINFO, "", RC_VERSION);
  LetArrive(kIndex, witness->written.size());
  if (!witness->is_sending) throw Violation("the witness gets no answer");
  const int status = GetU16(reinterpret_cast<const Uint8*>(witness->sent.data()) + 12);
  EndSend(kIndex);
  if (status != rcOK || !witness->questions.empty() || witness->events != 0) {
    throw Violation("the witness gets another answer than its own");
  }
}

// Lets everything arrive and end.  Every whole request has an answer then.
void RemoteDriver::Finish() {
  for (int i = 0; i < RequestHandler::MAX_CLIENTS; ++i) {
    Client* const client = clients_[static_cast<size_t>(i)].get();
    for (int round = 0; client->is_open && (client->is_sending || !client->written.empty());
         ++round) {
      if (round > 100'000) throw Violation("a client is served without end");
      LetArrive(i, client->written.size());
      EndSend(i);
    }
    if (!client->questions.empty()) {
      throw Violation(fmt::format("{} requests of client {} have no answer, the first is {:#04x}",
                                  client->questions.size(), i, client->questions.front().command));
    }
  }
  for (int i = 0; i < RequestHandler::MAX_CLIENTS; ++i) Close(i);
  if (wants_image_) throw Violation("the camera goes on though no client is there");
  PassTime();
  stick_->Check();
}

// ---- Files

FuzzStick::FuzzStick() {
  std::string name = (std::filesystem::temp_directory_path() / "openr-fuzz-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no folder for a stick");
  root_ = name;
  Write(std::string(kImages) + "CONTROLL.BIN", "old image");
  Write(std::string(kImages) + "RCSERVER.BIN", "server");
  Write(std::string(kMotions) + "OLD.MTN", "no motion");
  Write("MS/OPEN-R/MW/CONF/OBJECT.CFG", "objects");
  Write("MS/OPEN-R/MW/DATA/CONFIG.CFG", "configuration");
  Write("SECRET.TXT", "outside of the stick");
}

FuzzStick::~FuzzStick() {
  std::error_code ignored;
  std::filesystem::remove_all(root_, ignored);
}

void FuzzStick::Write(const std::string& name, const std::string& bytes) {
  std::filesystem::create_directories((root_ / name).parent_path());
  std::ofstream(root_ / name, std::ios::binary) << bytes;
  files_[name] = bytes;
}

void FuzzStick::Check() const {
  for (const auto& [name, bytes] : files_) {
    // Motions and the image of the controller may have changed.
    if (name.starts_with(kMotions) || name.ends_with("CONTROLL.BIN")) continue;
    if (BytesOfFile(root_ / name) != bytes) throw Violation(name + " was touched");
  }
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root_)) {
    if (!entry.is_regular_file()) continue;
    const std::string name = std::filesystem::relative(entry.path(), root_).string();
    const bool is_motion = name.starts_with(kMotions) && name.ends_with(".MTN");
    const bool is_old = name == std::string(kImages) + "CONTROLL.OLD";
    if (!is_motion && !is_old && !files_.contains(name)) throw Violation(name + " was left");
  }
  if (!std::filesystem::exists(root_ / (std::string(kImages) + "CONTROLL.BIN"))) {
    throw Violation("the image of the controller is gone");
  }
}

uint64_t FuzzStick::State() const {
  std::set<std::string> names;
  for (const char* const folder : {kMotions, kImages}) {
    for (const auto& entry : std::filesystem::directory_iterator(root_ / folder)) {
      names.insert(entry.path().filename().string());
    }
  }
  std::string all;
  for (const std::string& name : names) all += name + '\n';
  return HashBytes(all.data(), all.size());
}

void FuzzStick::Restore() const {
  for (const char* const folder : {kMotions, kImages}) {
    for (const auto& entry : std::filesystem::directory_iterator(root_ / folder)) {
      if (!files_.contains(folder + entry.path().filename().string())) {
        std::filesystem::remove(entry.path());
      }
    }
  }
  for (const char* const name : {"MS/OPEN-R/MW/OBJS/CONTROLL.BIN", "MS/OPEN-R/MW/DATA/P/OLD.MTN"}) {
    std::ofstream(root_ / name, std::ios::binary) << files_.at(name);
  }
}

}  // namespace openr_host
