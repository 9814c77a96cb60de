#include "openr/commands/stick_commands.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "cli/colour.h"
#include "cli/counted.h"
#include "cli/exit_code.h"
#include "cli/install_paths.h"
#include "cli/json_text.h"
#include "cli/output_file.h"
#include "cli/print_plain.h"
#include "cli/standard_streams.h"
#include "kit/check.h"
#include "kit/check_boot.h"
#include "kit/new_stick.h"
#include "kit/shell_words.h"
#include "kit/text_files.h"
#include "kit/wlan_file.h"
#include "openr/commands/common_flags.h"
#include "openr/simulation/simulation.h"
#include "runtime/base/terminal_text.h"
#include "virtualrobot/model/robot_model.h"

namespace openr_host {
namespace {

struct WlanFlags {
  WlanConfig config;
  bool is_given = false;  // true: the user has given a setting of the wireless network by a flag
  bool has_key = false;   // true: one of the flags was --wep-key
};

void SetByFlag(const std::string& flag, const std::string& key, const std::string& value,
               WlanFlags* flags) {
  const std::string problem = SetWlanKey(key, value, &flags->config);
  if (!problem.empty()) throw CLI::ValidationError(flag, problem);
  flags->is_given = true;
  flags->has_key = flags->has_key || key == "WEPKEY";
}

void AddWlanFlags(CLI::App* command, WlanFlags* flags) {
  for (const WlanQuestion& question : WlanQuestions()) {
    const std::string key = question.key, flag = question.flag;
    // Skips three settings of WLANCONF.TXT, because their flags take no value or only certain
    // words.  These flags are added separately below.
    if (key == "WEPENABLE" || key == "USE_DHCP" || key == "APMODE") continue;
    command
        ->add_option_function<std::string>(
            flag, [=](const std::string& value) { SetByFlag(flag, key, value, flags); },
            fmt::format("{} ({})", question.question, key))
        ->type_name("VALUE");
  }
  command->add_flag_callback(
      "--no-wep", [flags] { SetByFlag("--no-wep", "WEPENABLE", "0", flags); },
      "The network is not encrypted (WEPENABLE=0)");
  command->add_flag_callback(
      "--dhcp", [flags] { SetByFlag("--dhcp", "USE_DHCP", "1", flags); },
      "The network gives the robot its address (USE_DHCP=1)");
  command
      ->add_option_function<std::string>(
          "--mode",
          [flags](const std::string& mode) {
            const char* const value = mode == "infrastructure" ? "1" : mode == "adhoc" ? "0" : "2";
            SetByFlag("--mode", "APMODE", value, flags);
          },
          "By an access point, without one, or whichever is there (APMODE)")
      ->check(CLI::IsMember({"infrastructure", "adhoc", "automatic"}));
}

// Asks for all settings of the wireless network on the terminal.  If standard input is a pipe,
// reads one answer from each line of the pipe.
void AskAll(WlanConfig* config) {
  PrintPlain(stderr, "An empty answer takes the value in brackets.\n");
  const auto ask = [](const std::string& question,
                      const std::string& value) -> std::optional<std::string> {
    PrintPlain(stderr, "{} [{}]: ", question, value);
    std::string answer;
    if (!std::getline(std::cin, answer)) return std::nullopt;
    return answer;
  };
  const auto refuse = [](const std::string& reason) { PrintPlain(stderr, "  {}\n", reason); };
  if (AskForWlan(ask, refuse, config)) return;
  PrintPlain(stderr, "\n");
  throw std::runtime_error(
      "the answers ended before the last question; nothing was written.  Flags give the settings "
      "as well: openr help stick wlan");
}

void PrintNote(const std::string& text) {
  const std::string begin = Coloured(Colour::kNote, "openr: note:", HasColours(STDERR_FILENO));
  fmt::print(stderr, "{} {}\n", begin, TerminalText(text));
}

// Prints a note on standard error if the flags leave WEP on with the key of Sony's file, which is
// probably not the key of the user's network.
void WarnOfDefaultKey(const WlanFlags& flags) {
  if (!flags.is_given || flags.has_key || !flags.config.wep_enable) return;
  PrintNote(
      fmt::format("WEP is on with the key of Sony's file, {}; --wep-key gives another one, "
                  "--no-wep is for a network without encryption",
                  flags.config.wep_key));
}

// Prints warnings on standard error about wireless settings in the file that make no sense.
void WarnOfWlanSettings(const std::string& file, const std::string& text) {
  PrintPlain(stderr, "{}", Render(CheckWlanSettings(file, ParseWlanConfig(file, text))));
}

[[noreturn]] void ThrowNoStick(const std::string& folder) {
  throw std::runtime_error(
      fmt::format("{}: is no stick, there is no OPEN-R/ in it{}", folder, StickNear(folder)));
}

struct WlanCommand {
  WlanFlags wlan;
  std::string stick;
  std::string output;
};

int WriteWlan(WlanCommand command) {
  if (!command.stick.empty() && FindEntry(command.stick, "OPEN-R").empty())
    ThrowNoStick(command.stick);
  if (!command.wlan.is_given) AskAll(&command.wlan.config);
  WarnOfDefaultKey(command.wlan);
  const std::string text = WlanText(command.wlan.config);
  if (command.stick.empty() && command.output.empty()) {
    PrintAnswer(text);
    return kExitGood;
  }
  std::string file = command.output;
  if (file.empty()) {
    file = PutWlanFile(command.stick, text);
  } else if (const std::string problem = WriteFile(file, text); !problem.empty()) {
    throw std::runtime_error(problem);
  }
  WarnOfWlanSettings(file, text);
  PrintAnswer(fmt::format("wrote {}\n", file));
  return kExitGood;
}

struct CheckCommand {
  std::string stick;
  std::string robot = "ers210";
  bool json = false;
};

// Returns a size in KB of 1024 bytes, rounded up.
uint64_t InKilobytes(uint64_t bytes) { return (bytes + 1023) / 1024; }

// Returns the number and size of the stick's files as text.  Does not check whether the files fit
// on a real stick, because no source says how much a Programming Memory Stick holds
// (docs/robot-build.md).
std::string SummaryOf(const StickSummary& stick) {
  return fmt::format("{}, {} KB, of which {} of objects {} {} KB; base image: {}\n",
                     Counted(static_cast<uint64_t>(stick.num_files), "file"),
                     InKilobytes(stick.num_bytes),
                     Counted(static_cast<uint64_t>(stick.num_images), "image"),
                     stick.num_images == 1 ? "has" : "have", InKilobytes(stick.image_bytes),
                     stick.base.empty() ? "none" : stick.base);
}

int Check(const CheckCommand& command) {
  if (FindEntry(command.stick, "OPEN-R").empty()) ThrowNoStick(command.stick);
  Remarks remarks = CheckFolder(command.stick, {}, CheckTarget::kRobot);
  const RobotModel model = LoadRobotModel(ModelFile(command.robot));
  const StickSummary summary =
      CheckBoot(std::filesystem::canonical(command.stick), model.design, &remarks);
  const int errors = remarks.CountOf(Remark::Kind::kError);
  if (command.json) {
    auto json = ParseJson<nlohmann::ordered_json>(RemarksToJson(remarks, command.stick));
    json["robot"] = model.design;
    json["base"] = summary.base;
    json["files"] = summary.num_files;
    json["bytes"] = summary.num_bytes;
    json["images"] = summary.num_images;
    json["image_bytes"] = summary.image_bytes;
    PrintAnswer(JsonText(json, 2) + "\n");
  } else {
    PrintAnswerWithCodes(RenderRemarks(remarks, HasColours(StandardOutput())));
    PrintAnswer(TerminalText(SummaryOf(summary)));
    PrintAnswer(errors == 0
                    ? fmt::format("nothing is known that keeps an {} from booting\n", model.design)
                    : fmt::format("{} keep an {} from booting\n",
                                  Counted(static_cast<uint64_t>(errors), "error"), model.design));
  }
  return errors == 0 ? kExitGood : kExitWrong;
}

struct NewCommand {
  NewStickOptions stick;
  WlanFlags wlan;
  std::string robot = "ers210";
};

int MakeNew(NewCommand command) {
  if (command.wlan.is_given) command.stick.wlan = WlanText(command.wlan.config);
  const std::vector<std::string> unlisted = MakeNewStick(command.stick);
  const std::string word = ShellWord(command.stick.output);
  PrintAnswer(TerminalText(fmt::format("made {}\n", command.stick.output)));
  for (const std::string& name : unlisted) {
    PrintAnswer(TerminalText(
        fmt::format("OBJS/{} of the base is not in OBJECT.CFG, so no robot loads it; name "
                    "it among the images if it is needed\n",
                    name)));
  }
  if (command.stick.images.empty())
    PrintNote(
        "no IMAGE is named, so the stick has no object of yours; name your .BIN files in "
        "the order to load them");
  WarnOfDefaultKey(command.wlan);
  if (command.wlan.is_given) WarnOfWlanSettings("WLANCONF.TXT", command.stick.wlan);
  const std::string openr = ShellWord(ProgramCall());
  PrintAnswer(fmt::format("\nwhat a robot needs beyond that:\n{0} stick check {1} --robot {2}\n",
                          openr, word, command.robot));
  if (!command.wlan.is_given) PrintAnswer(fmt::format("{} stick wlan {}\n", openr, word));
  return kExitGood;
}

void AddRobotFlag(CLI::App* command, std::string* robot) {
  command->add_option("--robot", *robot, "The robot that is to boot from it")
      ->check(CLI::IsMember({"ers210", "ers220", "ers7"}))
      ->capture_default_str();
}

}  // namespace

void AddStickCheck(CLI::App* stick, int* exit_code) {
  CLI::App* const command = stick->add_subcommand(
      "check", "Says what keeps a robot from booting from a stick; status 1 if something does");
  auto flags = std::make_shared<CheckCommand>();
  command->add_option("DIR", flags->stick, "The stick: a folder that holds OPEN-R/")->required();
  AddRobotFlag(command, &flags->robot);
  command->add_flag("--json", flags->json, "One JSON object instead of text");
  command->callback([flags, exit_code] { *exit_code = Check(*flags); });
}

void AddStickNew(CLI::App* stick, int* exit_code) {
  CLI::App* const command =
      stick->add_subcommand("new", "A stick for images that are built already");
  auto flags = std::make_shared<NewCommand>();
  command->add_option("IMAGE", flags->stick.images, ".BIN files, in the order to load them");
  command->add_option("-o,--output", flags->stick.output, "Folder to make; OPEN-R/ will be in it")
      ->required()
      ->check(IsFolder());
  command->add_option("--connect", flags->stick.connections, "CONNECT.CFG to copy (default: empty)")
      ->check(IsReadable("--connect", "CONNECT.CFG", ".CFG"));
  command
      ->add_option("--base", flags->stick.base,
                   "Folder with the OPEN-R/ of the robot's system, of the SDK: "
                   "OPEN_R/MS_ERS200/WCONSOLE/memprot")
      ->type_name("FOLDER");
  AddRobotFlag(command, &flags->robot);
  AddWlanFlags(command, &flags->wlan);
  command->callback([flags, exit_code] { *exit_code = MakeNew(*flags); });
}

void AddStickWlan(CLI::App* stick, int* exit_code) {
  CLI::App* const command = stick->add_subcommand(
      "wlan", "Writes WLANCONF.TXT, the network settings; asks for them when no flag gives one");
  auto flags = std::make_shared<WlanCommand>();
  CLI::Option* const folder =
      command->add_option("DIR", flags->stick, "The stick to write it to (default: print it)");
  command->add_option("-o,--output", flags->output, "File to write it to instead")
      ->check(IsWritable())
      ->excludes(folder);
  AddWlanFlags(command, &flags->wlan);
  command->callback([flags, exit_code] { *exit_code = WriteWlan(*flags); });
}

}  // namespace openr_host
