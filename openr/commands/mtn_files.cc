#include "openr/commands/mtn_files.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "cli/counted.h"
#include "cli/exit_code.h"
#include "cli/input_file.h"
#include "cli/json_text.h"
#include "cli/output_file.h"
#include "cli/print_plain.h"
#include "cli/standard_streams.h"
#include "openr/commands/common_flags.h"
#include "openr/commands/motion_input.h"
#include "openr/motion/log_charts.h"
#include "openr/motion/mtn_csv.h"
#include "openr/motion/oda_file.h"
#include "runtime/base/read_file.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

// Makes `command` run `action` when the user calls the command.  An error of `action` is printed,
// and makes the exit status 1.
void OnCall(CLI::App* command, int* exit_code, std::function<void()> action) {
  command->callback([exit_code, action = std::move(action)] {
    try {
      action();
      *exit_code = kExitGood;
    } catch (const std::system_error&) {
      throw;  // the answer cannot be written; program.cc reports this error
    } catch (const ReaderGone&) {
      throw;
    } catch (const std::runtime_error& error) {
      PrintPlain(stderr, "openr: {}\n", error.what());
      *exit_code = kExitWrong;
    }
  });
}

std::string ReadInput(const std::string& file, const InputKind& kind) {
  RequireReadable(file, kind);
  std::optional<std::string> bytes = ReadFile(file);
  if (!bytes) {
    throw std::runtime_error(fmt::format("{}: cannot be read: {}", file, std::strerror(errno)));
  }
  return std::move(*bytes);
}

void ThrowIfAny(const std::string& problem) {
  if (!problem.empty()) throw std::runtime_error(problem);
}

struct FromCsvFlags {
  std::string file, output;
  std::string like;  // motion file from which the new motion gets its names (--like); "": none
  std::optional<std::string> name, creator, label;
};

// Sets the name, the creator and the design label of `motion`.  Each of them is taken from its
// flag; without the flag, from the motion file of --like; without this file, it has a default.  The
// defaults are the name of the CSV file from which the motion is made, and the creator and design
// label of our own motions.
void SetNames(const FromCsvFlags& flags, MotionFile* motion) {
  motion->name = std::filesystem::path(flags.file).stem().string();
  if (!flags.like.empty()) {
    const MtnFile like = ReadMotion(flags.like);
    motion->name = like.Name();
    motion->creator = like.Creator();
    motion->design_label = like.DesignLabel();
  }
  motion->name = flags.name.value_or(motion->name);
  motion->creator = flags.creator.value_or(motion->creator);
  motion->design_label = flags.label.value_or(motion->design_label);
  for (const std::string& text : {motion->name, motion->creator, motion->design_label}) {
    if (text.size() <= 255) continue;
    throw std::runtime_error(
        fmt::format("'{}...': a name in a motion has at most 255 characters", text.substr(0, 40)));
  }
}

void FromCsv(const FromCsvFlags& flags) {
  MotionFile motion;
  try {
    motion = ParseMotionCsv(ReadInput(flags.file, {"table of openr mtn dump", ".csv"}));
  } catch (const std::runtime_error& error) {
    const std::string text = error.what();
    // Adds the name of the file only to errors in the content of the CSV file, because errors in
    // reading the file begin with its name already.
    throw std::runtime_error(text.find(flags.file) == 0 ? text : flags.file + ": " + text);
  }
  SetNames(flags, &motion);
  const std::vector<uint8_t> bytes = WriteMtn(motion);
  ThrowIfAny(WriteFile(flags.output, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}));
}

struct OdaFlags {
  std::string file, folder;
  bool overwrites = false, json = false;
};

std::vector<OdaMember> MembersOf(const std::string& file, const std::string& bytes) {
  try {
    return ReadOda(bytes);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}: {}", file, error.what()));
  }
}

// Returns `name` with '?' in place of all bytes except printable ASCII.  A container of motion
// files (.ODA) may come from anywhere, so control bytes in its names must not reach the terminal.
std::string Printable(std::string name) {
  for (char& c : name) {
    if (c < ' ' || c > '~') c = '?';
  }
  return name;
}

void ListOda(const OdaFlags& flags) {
  const std::string bytes = ReadInput(flags.file, {"container", ".ODA"});
  Json list = Json::array();
  for (const OdaMember& member : MembersOf(flags.file, bytes)) {
    if (flags.json) {
      list.push_back({{"name", member.name},
                      {"type", member.type},
                      {"bytes", member.bytes.size()},
                      {"file", member.file}});
    } else {
      PrintPlain("{:<4} {:>9} bytes  {:<12}  {}\n", Printable(member.type), member.bytes.size(),
                 member.file, Printable(member.name));
    }
  }
  if (flags.json) PrintPlain("{}\n", JsonText(list));
}

void UnpackOda(const OdaFlags& flags) {
  const std::string bytes = ReadInput(flags.file, {"container", ".ODA"});
  const std::vector<OdaMember> members = MembersOf(flags.file, bytes);
  const std::filesystem::path folder = flags.folder;
  // Checks all names before the first file is written, so that an error leaves nothing unpacked.
  for (const OdaMember& member : members) {
    // Does not write a member of the ODA file over a symbolic link, even with --overwrite, because
    // the link may lead to a file outside of the folder.
    std::error_code error;
    if (flags.overwrites && !std::filesystem::is_symlink(folder / member.file, error)) continue;
    if (std::filesystem::symlink_status(folder / member.file, error).type() ==
        std::filesystem::file_type::not_found) {
      continue;
    }
    throw std::runtime_error(fmt::format(
        "{}: is there already; nothing was unpacked{}", (folder / member.file).string(),
        flags.overwrites ? ": it is a symbolic link" : " (--overwrite replaces files)"));
  }
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw std::runtime_error(fmt::format("{}: {}", flags.folder, error.message()));
  for (const OdaMember& member : members)
    ThrowIfAny(WriteFile((folder / member.file).string(), member.bytes));
  PrintPlain("{} in {}\n", Counted(members.size(), "file"), flags.folder);
}

}  // namespace

void AddMtnPlotCommand(CLI::App* mtn, int* exit_code) {
  CLI::App* const plot = mtn->add_subcommand("plot", "A chart of every joint");
  const auto file = std::make_shared<std::string>(), output = std::make_shared<std::string>();
  plot->add_option("FILE", *file, "Motion file")->required();
  AddChartOption(plot, output.get())->required();
  OnCall(plot, exit_code, [file, output] {
    const std::string title = std::filesystem::path(*file).filename().string();
    ThrowIfAny(chart::WriteChart(ChartOf(ReadMotion(*file), title), *output));
  });
}

void AddMtnFromCsvCommand(CLI::App* mtn, int* exit_code) {
  CLI::App* const command =
      mtn->add_subcommand("from-csv", "Makes a motion file of what dump has printed");
  const auto flags = std::make_shared<FromCsvFlags>();
  command->add_option("FILE", flags->file, "Table of key frames")->required();
  command->add_option("-o,--output", flags->output, "The motion file to write")
      ->required()
      ->check(IsWritable());
  command->add_option("--like", flags->like,
                      "Motion file to take name, creator and design label from");
  command->add_option("--name", flags->name, "Name of the motion (default: that of FILE)");
  command->add_option("--creator", flags->creator, "Its creator (default: openr-host)");
  command->add_option("--design-label", flags->label,
                      "The robot it is for (default: DRX-900, ERS-210 and ERS-220)");
  OnCall(command, exit_code, [flags] { FromCsv(*flags); });
}

void AddMtnOdaCommand(CLI::App* mtn, int* exit_code) {
  CLI::App* const oda = mtn->add_subcommand("oda", "Containers of motions and sounds (ODA)");
  oda->require_subcommand(1);
  const auto flags = std::make_shared<OdaFlags>();
  CLI::App* const list = oda->add_subcommand("list", "The members of a container");
  list->add_option("FILE", flags->file, "Container")->required();
  list->add_flag("--json", flags->json, "A list of JSON objects");
  OnCall(list, exit_code, [flags] { ListOda(*flags); });
  CLI::App* const unpack = oda->add_subcommand("unpack", "Writes each member to a file");
  unpack->add_option("FILE", flags->file, "Container")->required();
  unpack->add_option("-o,--output", flags->folder, "Folder for the files")
      ->required()
      ->check(IsFolder());
  unpack->add_flag("--overwrite", flags->overwrites, "Replace files that are there");
  OnCall(unpack, exit_code, [flags] { UnpackOda(*flags); });
}

}  // namespace openr_host
