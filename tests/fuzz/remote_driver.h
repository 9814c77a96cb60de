// Runs a session of the remote control that a string of bytes describes: nine clients, a stick and
// a robot, without a network.  Checks after each step what must hold in every session.
//
// A byte of the program names a client (low four bits) and a step (high four bits); the bytes
// behind it are the arguments of the step.  Every string is a program.  The steps are: to connect
// and to close, to write packets or any bytes, to let some of the written bytes arrive, to let a
// send end, and to let time pass on the robot.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "ClientSession.h"

namespace openr_host {

// Something that must hold did not.
class Violation : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A stick in a new folder, which is removed at the end.
class FuzzStick {
 public:
  FuzzStick();
  ~FuzzStick();
  FuzzStick(const FuzzStick&) = delete;
  FuzzStick& operator=(const FuzzStick&) = delete;

  std::string root() const { return root_.string(); }

  // Throws Violation when a file outside of the folders of motions and images was touched, or when
  // these folders have files that no client may have put there.
  void Check() const;

  // Returns a hash of the names of all files in the folders of motions and images.
  uint64_t State() const;

  // Makes all files as they were.
  void Restore() const;

 private:
  void Write(const std::string& name, const std::string& bytes);

  std::filesystem::path root_;
  std::map<std::string, std::string> files_;  // files at the beginning: path below root_, bytes
};

class RemoteDriver : private RequestPort {
 public:
  explicit RemoteDriver(FuzzStick* stick);
  ~RemoteDriver() override;

  // Runs a program to its end, closes all clients and checks what is left.  Throws Violation.
  void Run(const uint8_t* program, size_t size);

 private:
  // A whole request that has arrived, and the header that its answer must have.
  struct Expected {
    uint8_t command;
    uint16_t tag;
    bool is_last;  // nothing is answered after it
  };
  struct Client {
    bool is_open = false;
    bool is_receiving = false;
    bool is_sending = false;
    ClientSession session;
    std::string written;             // bytes that have not arrived yet
    std::string arrived;             // bytes that have, behind the last whole packet
    std::deque<Expected> questions;  // without an answer so far
    bool is_over = false;            // no further request is answered
    std::string sent;                // copy of the bytes that are being sent
    size_t events = 0;               // events that the client has received
    uint32_t upload_offset = 0;      // bytes that the steps have uploaded so far
    bool is_image = false;           // the upload is one of an image, not of a motion
    uint8_t buffer[ClientSession::SEND_SIZE] = {};
  };

  // RequestPort
  bool PostMover(const MoverCommand& command) override;
  void PostLedEar(const LedEarState&) override {}
  bool ReadFile(const std::string& path, std::vector<Uint8>* bytes, std::string* error) override;
  void ReadBattery(Sint32* capacity, Sint32* temperature) override;
  bool ReadPower(RcPower* power) override;
  bool ReadGains(int joint, Uint16 gains[6]) override;
  void WantImage(bool wanted) override { wants_image_ = wanted; }
  void EndRun(bool) override {}

  uint8_t Byte();
  void Step();
  void Open(int index);
  void Close(int index);
  void WriteRequest(Client* client);
  void WriteUpload(Client* client);
  void WriteBatch(Client* client);
  void WritePacket(Client* client, int command, const std::string& payload, int version);
  void LetArrive(int index, size_t count);
  void EndSend(int index);
  void Serve(int index);
  void PassTime();
  void NoteRequests(Client* client, const std::string& bytes);
  void HearPackets(Client* client);
  void HearPacket(Client* client, const std::string& packet);
  void AskWitness();
  void Finish();

  FuzzStick* const stick_;
  std::unique_ptr<RequestHandler> handler_;
  std::vector<std::unique_ptr<Client>> clients_;
  const uint8_t* program_ = nullptr;
  size_t size_ = 0, at_ = 0;
  uint32_t frame_ = 3;
  uint16_t tag_ = 0;
  bool is_mover_full_ = false;
  bool wants_image_ = false;
};

}  // namespace openr_host
