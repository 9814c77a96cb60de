// The actions of `openr rc` for files of the robot's stick, and for the end of the run.
#include <fmt/format.h>
#include <unistd.h>

#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cli/input_file.h"
#include "cli/output_file.h"
#include "openr/commands/rc_actions.h"
#include "openr/commands/rc_format.h"
#include "openr/remote/file_checks.h"
#include "openr/remote/remote_client.h"
#include "openr/remote/remote_files.h"
#include "runtime/base/read_file.h"
#include "runtime/base/wall_clock.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

// Shows on a terminal how far an upload is, when it takes longer than two seconds.
class UploadLine {
 public:
  UploadLine(std::string name, size_t size)
      : name_(std::move(name)), size_(size), begin_ms_(WallClockMs()) {}
  ~UploadLine() {
    if (is_drawn_) fmt::print(stderr, "\r\x1b[K");
  }
  UploadLine(const UploadLine&) = delete;
  UploadLine& operator=(const UploadLine&) = delete;

  void Show(size_t done) {
    if (isatty(STDERR_FILENO) == 0 || WallClockMs() - begin_ms_ < 2000) return;
    fmt::print(stderr, "\r\x1b[K{}: {} of {} KB", name_, done / 1024, size_ / 1024);
    is_drawn_ = true;
  }

 private:
  const std::string name_;
  const size_t size_;
  const int64_t begin_ms_;
  bool is_drawn_ = false;
};

std::string ReadInput(const std::string& file, const char* kind, const char* extension) {
  const std::string problem = WhyNotReadable(file, kind, extension);
  if (!problem.empty()) throw std::runtime_error(fmt::format("{}: {}", file, problem));
  return ReadFileOrThrow(file);
}

std::string UpperCaseName(const std::string& file) {
  std::string name = std::filesystem::path(file).filename().string();
  for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return name;
}

uint32_t Upload(RemoteClient* client, RcFileKind kind, const std::string& name,
                const std::string& bytes) {
  UploadLine line(name, bytes.size());
  return UploadFile(client, kind, name, bytes, [&line](size_t done) { line.Show(done); });
}

}  // namespace

void RcListAction(RemoteClient* client, const RcFlags& flags) {
  uint32_t frame = 0;
  Json json = Json::array();
  const std::vector<RcListEntry> motions = ListMotions(client, &frame);
  std::string text = fmt::format("{} motion{}", motions.size(), motions.size() == 1 ? "" : "s");
  for (const RcListEntry& motion : motions) {
    json.push_back({{"name", motion.name}, {"bytes", motion.size}});
    text += fmt::format("\n  {:<12} {:8} bytes", motion.name, motion.size);
  }
  PrintRcAnswer(flags.json, frame, {{"motions", json}}, text);
}

void RcUploadMotionAction(RemoteClient* client, const RcFlags& flags) {
  const std::string bytes = ReadInput(flags.file, "motion file", ".MTN");
  const std::string name = UpperCaseName(flags.file);
  CheckMotion(flags.file, bytes, AskFileInfo(client));
  const uint32_t frame = Upload(client, rcfileMOTION, name, bytes);
  PrintRcAnswer(flags.json, frame, {{"name", name}, {"bytes", bytes.size()}},
                fmt::format("{} is on the stick, {} bytes", name, bytes.size()));
}

void RcUploadControllerAction(RemoteClient* client, const RcFlags& flags) {
  const RcInfo info = AskFileInfo(client);
  const std::string bytes =
      ImageToSend(flags.file, ReadInput(flags.file, "controller image", ".BIN"), info);
  const uint32_t frame = Upload(client, rcfileIMAGE, RC_IMAGE_NAME, bytes);
  PrintRcAnswer(flags.json, frame, {{"name", RC_IMAGE_NAME}, {"bytes", bytes.size()}},
                fmt::format("{} is on the stick, {} bytes; it runs after the next boot, and "
                            "CONTROLL.OLD is the one before",
                            RC_IMAGE_NAME, bytes.size()));
}

void RcDownloadAction(RemoteClient* client, const RcFlags& flags) {
  uint32_t frame = 0;
  const std::string name = UpperCaseName(flags.file);
  const std::string file = flags.output.empty() ? name : flags.output;
  const std::string bytes = DownloadFile(client, rcfileMOTION, flags.file, &frame);
  const std::string problem = WriteFile(file, bytes);
  if (!problem.empty()) throw std::runtime_error(problem);
  PrintRcAnswer(flags.json, frame, {{"name", name}, {"file", file}, {"bytes", bytes.size()}},
                fmt::format("{} is in {}, {} bytes", name, file, bytes.size()));
}

void RcDeleteAction(RemoteClient* client, const RcFlags& flags) {
  client->UseVersion(RC_VERSION_FILES);
  const RemoteAnswer answer = client->RequestWith(rcDELETE, RcFileName{rcfileMOTION, flags.file});
  const std::string name = UpperCaseName(flags.file);
  PrintRcAnswer(flags.json, answer.frame, {{"deleted", name}}, fmt::format("{} is deleted", name));
}

void RcRebootAction(RemoteClient* client, const RcFlags& flags) {
  client->UseVersion(RC_VERSION_FILES);
  const uint32_t frame = client->Request(rcREBOOT).frame;
  PrintRcAnswer(flags.json, frame, {{"reboots", true}},
                "the robot shuts down and boots again; until then it takes no connections");
}

void RcShutdownAction(RemoteClient* client, const RcFlags& flags) {
  client->UseVersion(RC_VERSION_FILES);
  const uint32_t frame = client->Request(rcSHUTDOWN).frame;
  PrintRcAnswer(flags.json, frame, {{"shuts_down", true}}, "the robot shuts down");
}

}  // namespace openr_host
