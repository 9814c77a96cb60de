// A robot whose stick is a new folder, for tests of the remote control's commands for files.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "Crc32.h"
#include "RequestHandler.h"
#include "image_bytes.h"
#include "mtn_bytes.h"

namespace openr_host {

inline const Bytes kGoodMotion = MtnBytes::OneJoint("PRM:/r1/c1-Joint2:j1", {0, 10, 20}).Bytes();

// A robot whose stick is a new folder.
class FilesTest : public testing::Test, private RequestPort {
 protected:
  FilesTest() {
    std::string name = (std::filesystem::temp_directory_path() / "openr-test-XXXXXX").string();
    if (mkdtemp(name.data()) != nullptr) root_ = name;
    std::filesystem::create_directories(Motion(""));
    std::filesystem::create_directories(ImagePath(""));
    Boot();
  }
  ~FilesTest() override {
    handler_.reset();
    std::filesystem::remove_all(root_);
  }

  // Begins anew, as a robot does after a run that was killed.
  void Boot() {
    handler_.reset(new RequestHandler(this));  // make_unique() may not convert to a private base
    kept_ = handler_->Begin(FindRobot("ERS-210"), root_);
  }

  std::string Motion(const std::string& name) const {
    return root_ + "/MS/OPEN-R/MW/DATA/P/" + name;
  }
  std::string ImagePath(const std::string& name) const {
    return root_ + "/MS/OPEN-R/MW/OBJS/" + name;
  }
  static void Write(const std::string& path, const Bytes& bytes) {
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()),
               static_cast<std::streamsize>(bytes.size()));
  }
  static Bytes Read(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  }
  // All files of the stick, without their folders.
  std::vector<std::string> Files() const {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root_))
      if (entry.is_regular_file()) names.push_back(entry.path().filename());
    std::sort(names.begin(), names.end());
    return names;
  }

  // Sends a request and returns the status; the answer's payload is in payload_.
  int Ask(int command, const Bytes& request, int client = 0) {
    uint8_t bytes[RC_MAX_PACKET];
    RcWriter in(bytes, RC_MAX_PACKET);
    for (int i = 0; i < RC_HEADER_SIZE; ++i) in.U8(0);
    in.Bytes(request.data(), static_cast<int>(request.size()));
    in.PutHeader(command, 5, RC_VERSION_FILES);
    RcFramer framer;
    framer.Append(bytes, in.Size());
    EXPECT_EQ(framer.Next(), RcFramer::PACKET);
    uint8_t answer[RC_MAX_PACKET];
    RcWriter out(answer, RC_MAX_PACKET);
    handler_->Answer(client, framer, &out);
    EXPECT_FALSE(out.HasOverflowed());
    RcFramer back;
    back.Append(answer, out.Size());
    EXPECT_EQ(back.Next(), RcFramer::PACKET);
    RcAnswerHeader header;
    EXPECT_TRUE(header.Read(back));
    payload_.assign(answer + RC_ANSWER_HEADER_SIZE, answer + out.Size());
    error_.clear();
    RcReader reader(payload_.data(), static_cast<int>(payload_.size()));
    if (header.status != rcOK) error_ = reader.String();
    return header.status;
  }
  template <typename Request>
  int AskWith(int command, const Request& request, int client = 0) {
    uint8_t bytes[RC_MAX_PACKET];
    RcWriter out(bytes, RC_MAX_PACKET);
    request.Write(&out);
    return Ask(command, {bytes, bytes + out.Size()}, client);
  }

  static uint32_t CrcOf(const Bytes& bytes) {
    return Crc32(0, bytes.data(), static_cast<int>(bytes.size()));
  }
  int Begin(int kind, const std::string& name, const Bytes& bytes, int client = 0) {
    return AskWith(rcUPLOAD_BEGIN,
                   RcUploadBegin{static_cast<Uint8>(kind), name, static_cast<Uint32>(bytes.size()),
                                 CrcOf(bytes)},
                   client);
  }
  int Data(size_t offset, const Bytes& bytes, int client = 0) {
    Bytes request;
    Append32(&request, static_cast<uint32_t>(offset));
    request.insert(request.end(), bytes.begin(), bytes.end());
    return Ask(rcUPLOAD_DATA, request, client);
  }
  // Sends the data of `bytes` from `offset` to `end`, `step` bytes at a time.
  int DataOf(const Bytes& bytes, size_t offset, size_t end, size_t step, int client = 0) {
    int status = rcOK;
    for (size_t at = offset; at < end && status == rcOK; at += step) {
      const auto first = bytes.begin() + static_cast<ptrdiff_t>(at);
      status = Data(at, {first, first + static_cast<ptrdiff_t>(std::min(step, end - at))}, client);
    }
    return status;
  }
  int Upload(int kind, const std::string& name, const Bytes& bytes, int client = 0) {
    const int begun = Begin(kind, name, bytes, client);
    if (begun != rcOK) return begun;
    const int sent = DataOf(bytes, 0, bytes.size(), RC_MAX_UPLOAD_DATA, client);
    return sent == rcOK ? Ask(rcUPLOAD_END, {}, client) : sent;
  }
  RcList List(int first) {
    EXPECT_EQ(Ask(rcMTN_LIST, {static_cast<uint8_t>(first), static_cast<uint8_t>(first >> 8)}),
              rcOK)
        << error_;
    RcList list{};
    RcReader reader(payload_.data(), static_cast<int>(payload_.size()));
    EXPECT_TRUE(list.Read(&reader));
    return list;
  }

  std::unique_ptr<RequestHandler> handler_;
  std::string root_;
  Bytes payload_;
  std::string error_;
  std::vector<bool> ends_;  // calls of EndRun()
  std::string kept_;        // the result of RequestHandler::Begin()

 private:
  bool PostMover(const MoverCommand&) override { return true; }
  void PostLedEar(const LedEarState&) override {}
  bool ReadFile(const std::string&, std::vector<Uint8>*, std::string*) override { return false; }
  void ReadBattery(Sint32*, Sint32*) override {}
  bool ReadPower(RcPower*) override { return false; }
  bool ReadGains(int, Uint16*) override { return false; }
  void WantImage(bool) override {}
  void EndRun(bool reboot) override { ends_.push_back(reboot); }
};

}  // namespace openr_host
