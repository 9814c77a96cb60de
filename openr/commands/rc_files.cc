// The actions of `openr rc` for files of the robot's stick, and for the end of the run.
#include <fmt/format.h>
#include <unistd.h>

#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cli/input_file.h"
#include "cli/output_file.h"
#include "cli/progress_line.h"
#include "openr/commands/rc_actions.h"
#include "openr/commands/rc_format.h"
#include "openr/remote/connection.h"
#include "openr/upload/file_checks.h"
#include "runtime/base/read_file.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

std::string ReadInput(const std::string& file, const char* kind, const char* extension) {
  const std::string problem = FileReadProblem(file, kind, extension);
  if (!problem.empty()) throw std::runtime_error(fmt::format("{}: {}", file, problem));
  return ReadFileOrThrow(file);
}

std::string UpperCaseName(const std::string& file) {
  std::string name = std::filesystem::path(file).filename().string();
  for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return name;
}

void Upload(remote::Connection* robot, RcFileKind kind, const std::string& name,
            const std::string& bytes) {
  const auto kilobytes = [](size_t size) { return (size + 1023) / 1024; };
  // Shows the progress on standard error if standard output is a terminal.  Else a program probably
  // reads the output, and nobody needs the progress.
  const int descriptor = isatty(STDOUT_FILENO) != 0 ? STDERR_FILENO : -1;
  ProgressLine line(descriptor, kilobytes(bytes.size()), "KB of " + name, 0);
  robot->Upload(kind, name, bytes,
                [&](size_t done, size_t /*size*/) { line.Show(kilobytes(done)); });
}

}  // namespace

void RcListAction(remote::Connection* robot, const RcFlags& flags) {
  Json json = Json::array();
  const std::vector<remote::ListEntry> motions = robot->ListMotions();
  std::string text = fmt::format("{} motion{}", motions.size(), motions.size() == 1 ? "" : "s");
  for (const remote::ListEntry& motion : motions) {
    json.push_back({{"name", motion.name}, {"bytes", motion.size}});
    text += fmt::format("\n  {:<12} {:8} bytes", motion.name, motion.size);
  }
  PrintRcAnswer(flags.json, robot->frame(), {{"motions", json}}, text);
}

void RcUploadMotionAction(remote::Connection* robot, const RcFlags& flags) {
  const std::string bytes = ReadInput(flags.file, "motion file", ".MTN");
  const std::string name = UpperCaseName(flags.file);
  CheckMotion(flags.file, bytes, robot->GetInfo());
  Upload(robot, rcfileMOTION, name, bytes);
  PrintRcAnswer(flags.json, robot->frame(), {{"name", name}, {"bytes", bytes.size()}},
                fmt::format("{} is on the stick, {} bytes", name, bytes.size()));
}

void RcUploadControllerAction(remote::Connection* robot, const RcFlags& flags) {
  const remote::Info info = robot->GetInfo();
  const std::string bytes =
      ImageToSend(flags.file, ReadInput(flags.file, "controller image", ".BIN"), info);
  Upload(robot, rcfileIMAGE, RC_IMAGE_NAME, bytes);
  PrintRcAnswer(flags.json, robot->frame(), {{"name", RC_IMAGE_NAME}, {"bytes", bytes.size()}},
                fmt::format("{} is on the stick, {} bytes; it runs after the next boot, and "
                            "CONTROLL.OLD is the one before",
                            RC_IMAGE_NAME, bytes.size()));
}

void RcDownloadAction(remote::Connection* robot, const RcFlags& flags) {
  const std::string name = UpperCaseName(flags.file);
  const std::string file = flags.output.empty() ? name : flags.output;
  const std::string bytes = robot->Download(rcfileMOTION, flags.file);
  const std::string problem = WriteFile(file, bytes);
  if (!problem.empty()) throw std::runtime_error(problem);
  PrintRcAnswer(flags.json, robot->frame(),
                {{"name", name}, {"file", file}, {"bytes", bytes.size()}},
                fmt::format("{} is in {}, {} bytes", name, file, bytes.size()));
}

void RcDeleteAction(remote::Connection* robot, const RcFlags& flags) {
  robot->DeleteMotion(flags.file);
  const std::string name = UpperCaseName(flags.file);
  PrintRcAnswer(flags.json, robot->frame(), {{"deleted", name}},
                fmt::format("{} is deleted", name));
}

void RcRebootAction(remote::Connection* robot, const RcFlags& flags) {
  robot->Reboot();
  PrintRcAnswer(flags.json, robot->frame(), {{"reboots", true}},
                "the robot shuts down and boots again; until then it takes no connections");
}

void RcShutdownAction(remote::Connection* robot, const RcFlags& flags) {
  robot->Shutdown();
  PrintRcAnswer(flags.json, robot->frame(), {{"shuts_down", true}}, "the robot shuts down");
}

}  // namespace openr_host
