// The command openr emon: says what an EMON.LOG of a robot means.
#include <fmt/format.h>

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
#include "openr/ending/robot_record.h"
#include "runtime/base/read_file.h"
#include "runtime/base/terminal_text.h"

namespace openr_host {
namespace {

constexpr InputKind kEmonLog = {"crash record of a robot, OPEN-R/EMON.LOG", ".LOG"};
// The beginning of a crash record that a run on a computer has written (ending/crash_log.h).  The
// crash record of a robot has the words "exception code" instead.
constexpr char kOwnRecord[] = "EXCEPTION ";

struct EmonFlags {
  std::string file;
  std::string image;
  bool is_json = false;
};

// Returns the first part of a run's crash record: a text for people, with functions and lines.  The
// second part has the form of a robot's crash record.
std::string TextOfRun(const std::string& record) {
  return record.substr(0, record.find(kRobotRecordBegin));
}

// Returns the last crash record of a file to which the processes of a run have added their records.
std::string LastRecord(const std::string& text) {
  const size_t last = text.rfind(std::string("\n") + kOwnRecord);
  return last == std::string::npos ? text : text.substr(last + 1);
}

// Returns whether `record`, a crash record of a run, has all its parts.  Its last part is the list
// of objects.
bool IsCompleteRecord(const std::string& record) {
  const size_t robot_record = record.find(kRobotRecordBegin);
  return robot_record != std::string::npos && record.ends_with('\n') &&
         record.find("[object list]\n", robot_record) != std::string::npos;
}

constexpr char kIncompleteRecord[] =
    "the record is not complete: it has no list of objects at its end, because it was cut off, or "
    "because the crash had damaged the stack";

// Prints what the crash record of a run on a computer says.  Needs no image, because such a record
// already names functions and lines.  `log` is the part of `record` that has the form of a robot's
// crash record; nullopt if the record has no such part.
void ExplainRunRecord(const EmonFlags& flags, const std::string& record,
                      const std::optional<EmonLog>& log) {
  if (!flags.image.empty()) {
    throw std::runtime_error(flags.file +
                             ": was written by a run on a computer, and names functions and lines "
                             "itself; leave out --image");
  }
  CrashExplanation explanation = ExplainCrash(log.value_or(EmonLog()), nullptr);
  explanation.problem = IsCompleteRecord(record) ? "" : kIncompleteRecord;
  std::string text = TextOfRun(record);
  if (flags.is_json) {
    nlohmann::ordered_json json = ExplanationJson(explanation);
    json["record"] = text;
    PrintAnswer(JsonText(json) + "\n");
    return;
  }
  std::string on_robot;
  if (log) {
    on_robot = fmt::format("ON THE ROBOT {}\n",
                           log->code.value_or(0) == 0
                               ? "no exception at this place; it may go wrong later"
                               : fmt::format("exception {}: {}", *log->code, explanation.meaning));
  }
  if (!text.ends_with('\n')) text += '\n';
  if (!explanation.problem.empty()) on_robot += fmt::format("note: {}\n", explanation.problem);
  PrintAnswer(TerminalText(text + on_robot));
}

int ExplainRecord(const EmonFlags& flags) {
  RequireReadable(flags.file, kEmonLog);
  const std::string text = LastRecord(ReadFileOrThrow(flags.file));
  const std::optional<EmonLog> log = ParseEmonLog(text);
  if (text.starts_with(kOwnRecord)) {
    ExplainRunRecord(flags, text, log);
    return kExitGood;
  }
  if (!log)
    throw std::runtime_error(flags.file +
                             ": is no EMON.LOG of a robot: it has neither \"epc\" nor an exception "
                             "code");
  std::optional<RobotCode> code;
  if (!flags.image.empty()) code.emplace(flags.image);
  const CrashExplanation explanation = ExplainCrash(*log, code ? &*code : nullptr);
  PrintAnswer(flags.is_json ? JsonText(ExplanationJson(explanation)) + "\n"
                            : TerminalText(ExplanationText(explanation)));
  return kExitGood;
}

}  // namespace

void AddEmonCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command =
      app->add_subcommand("emon", "Says what the crash record of a robot (EMON.LOG) means");
  auto flags = std::make_shared<EmonFlags>();
  command->add_option("FILE", flags->file, "EMON.LOG of the robot's Memory Stick")->required();
  command->add_option("--image", flags->image,
                      "Image of the object that crashed: its .BIN, beside which NAME.nosnap.elf, "
                      "NAME.elf or NAME.DBG has the names of functions, or the ELF file from which "
                      "mkbin made it (NAME.nosnap.elf)");
  command->add_flag("--json", flags->is_json, "Print JSON");
  command->callback([flags, exit_code] { *exit_code = ExplainRecord(*flags); });
}

}  // namespace openr_host
