// The command openr emon: says what an EMON.LOG of a robot means.
#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "cli/exit_code.h"
#include "cli/input_file.h"
#include "cli/json_text.h"
#include "cli/standard_streams.h"
#include "openr/commands/commands.h"
#include "openr/emon/emon_log.h"
#include "openr/emon/emon_text.h"
#include "openr/emon/robot_code.h"
#include "runtime/base/read_file.h"

namespace openr_host {
namespace {

constexpr InputKind kEmonLog = {"crash record of a robot, OPEN-R/EMON.LOG", ".LOG"};
// The first word of a record that a run on this computer has written (ending/crash_log.h).
constexpr char kOwnRecord[] = "EXCEPTION SIG";

struct EmonFlags {
  std::string file;
  std::string image;
  bool is_json = false;
};

int Tell(const EmonFlags& flags) {
  RequireReadable(flags.file, kEmonLog);
  const std::string text = ReadFileOrThrow(flags.file);
  if (text.find(kOwnRecord) != std::string::npos)
    throw std::runtime_error(flags.file +
                             ": was written by a run on a computer, and names function and line "
                             "already; openr emon reads the records of robots");
  const std::optional<EmonLog> log = ParseEmonLog(text);
  if (!log)
    throw std::runtime_error(flags.file +
                             ": is no EMON.LOG of a robot: it has neither \"epc\" nor an exception "
                             "code");
  std::optional<RobotCode> code;
  if (!flags.image.empty()) code.emplace(flags.image);
  const EmonStory story = TellStory(*log, code ? &*code : nullptr);
  PrintAnswer(flags.is_json ? JsonText(StoryJson(story)) + "\n" : StoryText(story));
  return kExitGood;
}

}  // namespace

void AddEmonCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command =
      app->add_subcommand("emon", "Says what the crash record of a robot (EMON.LOG) means");
  auto flags = std::make_shared<EmonFlags>();
  command->add_option("FILE", flags->file, "EMON.LOG of the robot's Memory Stick")->required();
  command->add_option("--image", flags->image,
                      "Image of the object that crashed: its .BIN, or the ELF file from which "
                      "mkbin made it (NAME.nosnap.elf)");
  command->add_flag("--json", flags->is_json, "Print JSON");
  command->callback([flags, exit_code] { *exit_code = Tell(*flags); });
}

}  // namespace openr_host
