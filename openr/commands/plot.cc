// The command openr plot: draws quantities over time, from logs and recordings.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "cli/exit_code.h"
#include "cli/input_file.h"
#include "cli/print_plain.h"
#include "cli/progress_line.h"
#include "cli/standard_streams.h"
#include "openr/commands/commands.h"
#include "openr/commands/common_flags.h"
#include "openr/commands/motion_input.h"
#include "openr/data/mcap_writer.h"
#include "openr/data/replay_log.h"
#include "openr/data/table_chart.h"
#include "openr/ending/end_guards.h"
#include "openr/inspect/replayer.h"
#include "openr/motion/log_compare.h"
#include "openr/motion/log_times.h"
#include "runtime/base/read_file.h"
#include "runtime/base/temp_folder.h"
#include "runtime/base/terminal_text.h"

namespace openr_host {
namespace {

struct PlotFlags {
  std::string file, stick, motion, output;
  std::vector<std::string> wanted;
  int64_t from_us = 0, until_us = INT64_MAX;
  bool lists = false;
};

std::string BytesOf(const std::string& file) {
  RequireReadable(file, {"log or recording of a run", ".csv"});
  const std::optional<std::string> bytes = ReadFile(file);
  if (!bytes)
    throw std::runtime_error(fmt::format("{}: cannot be read: {}", file, std::strerror(errno)));
  return *bytes;
}

// Reads `bytes`, the content of `file`, with `read`, which is ReadCsvTable or ReadMcapTable.  Shows
// the progress on a terminal.
Table ReadWithProgress(TableReader* read, const std::string& file, const std::string& bytes) {
  constexpr size_t kMegabyte = 1'000'000;
  ProgressLine progress(STDERR_FILENO, bytes.size() / kMegabyte, "MB read");
  return read(file, bytes, [&progress](size_t count) { progress.Show(count / kMegabyte); });
}

// Replays the recording and returns the values of its quantities over time.  If the replay cannot
// go to the end of the recording, for example because the file is cut off, returns the values up to
// there and stores the reasons in `problems`.
Table TableOfRecording(const PlotFlags& flags, std::vector<std::string>* problems) {
  const ReplayOptions replay = {
      .file = flags.file, .stick = flags.stick, .console = [](std::string_view) {}};
  StartWithSanitizerOfRecording(replay);
  const EndGuards guards({.limit_name = ""});
  const TempFolder folder;
  DataLogOptions log;
  log.file = folder.path() + "/run.csv";
  Replayer replayer(replay);
  const std::string problem = LogReplay(&replayer, log, "", flags.until_us, STDERR_FILENO);
  if (!problem.empty()) throw std::runtime_error(problem);
  if (!replayer.difference().empty()) {
    throw std::runtime_error(
        fmt::format("{}: the replay differs: {}", flags.file, replayer.difference()));
  }
  Table table = ReadWithProgress(ReadCsvTable, log.file, BytesOf(log.file));
  table.note = replayer.reader().note();
  *problems = replayer.problems();
  if (!replayer.loss().empty()) problems->push_back(replayer.loss());
  return table;
}

// Returns the values in the log of a motion (file format AIBO_1.1) over time.
Table TableOfMotionLog(const PlotFlags& flags, const std::string& bytes) {
  const LogFile log = ParseLog(bytes);
  const std::vector<double> times_ms =
      flags.motion.empty() ? TimesOf(log) : TimesOf(log, ReadMotion(flags.motion));
  const std::pair<LogGroup, const char*> groups[] = {{LogGroup::kCommanded, "command."},
                                                     {LogGroup::kMeasured, "measured."},
                                                     {LogGroup::kSimulated, "joint."}};
  Table table;
  const std::vector<const JointConstants*> joints = LoggedJoints(*log.robot);
  for (size_t j = 0; j < joints.size(); ++j) {
    for (const auto& [group, begin] : groups) {
      const JointTraces traces = TracesOf(log, times_ms, group);
      if (traces.times_ms.empty()) continue;
      Series series{std::string(begin) + joints[j]->name, {}, traces.deg[j]};
      for (const double time_ms : traces.times_ms) series.time_s.push_back(time_ms / 1e3);
      table.series.push_back(std::move(series));
    }
  }
  return table;
}

// Reads the file as a table.  The first bytes of the file tell its format.  If they do not tell a
// format, the name of the file decides: a file with the ending .mcap is read as MCAP, so that the
// error message is about MCAP, and any other file is read as CSV.  Stores in `problems` why the
// table of a recording ends before the end of the recording.
Table ReadTable(const PlotFlags& flags, std::vector<std::string>* problems) {
  const std::string bytes = BytesOf(flags.file);
  if (bytes.starts_with(kMcapMagic)) return ReadWithProgress(ReadMcapTable, flags.file, bytes);
  if (bytes.starts_with("OPENRTRC")) return TableOfRecording(flags, problems);
  if (!bytes.starts_with("AIBO_")) {
    const bool is_mcap = flags.file.ends_with(".mcap");
    return ReadWithProgress(is_mcap ? ReadMcapTable : ReadCsvTable, flags.file, bytes);
  }
  try {
    return TableOfMotionLog(flags, bytes);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}: {}", flags.file, error.what()));
  }
}

// Splits each of `words` at commas and returns the names between the commas.
std::vector<std::string> NamesIn(const std::vector<std::string>& words) {
  std::vector<std::string> names;
  for (const std::string& word : words) {
    for (const std::string& name : CLI::detail::split(word, ',')) {
      if (!name.empty()) names.push_back(name);
    }
  }
  return names;
}

int Plot(const PlotFlags& flags) {
  if (flags.output.empty() && !flags.lists)
    throw CLI::RequiredError("-o CHART, the .svg or .png file to write,");
  std::vector<std::string> problems;
  const Table table = ReadTable(flags, &problems);
  for (const std::string& problem : problems) PrintPlain(stderr, "openr: {}\n", problem);
  const int exit_code = problems.empty() ? kExitGood : kExitWrong;
  if (!table.note.empty()) PrintPlain(stderr, "openr: note: {}\n", table.note);
  if (flags.lists) {
    for (const Series& series : table.series) PrintAnswer(TerminalLine(series.name) + "\n");
  }
  if (flags.output.empty()) return exit_code;
  PlotRequest request;
  request.wanted = NamesIn(flags.wanted);
  request.from_s = static_cast<double>(flags.from_us) / 1e6;
  request.until_s = static_cast<double>(flags.until_us) / 1e6;
  request.title = std::filesystem::path(flags.file).filename().string();
  chart::Chart chart;
  try {
    chart = ChartOf(table, request);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}: {}", flags.file, error.what()));
  }
  const std::string problem = chart::WriteChart(chart, flags.output);
  if (!problem.empty()) throw std::runtime_error(problem);
  return exit_code;
}

}  // namespace

void AddPlotCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command = app->add_subcommand(
      "plot",
      "Draws joints, sensors and poses over time with their units, from a log or a recording");
  auto flags = std::make_shared<PlotFlags>();
  command
      ->add_option("FILE", flags->file,
                   "What openr run --log-data or --record wrote, or a log of a motion (AIBO_1.1)")
      ->required();
  command->add_option("QUANTITY", flags->wanted,
                      "What to draw: names with commas between them, such as LF_j1,pitch_deg, or "
                      "patterns, such as 'sensor.*' (default: all joints)");
  AddChartOption(command, &flags->output);
  command->add_flag("--list", flags->lists, "Print the names of all quantities of the file");
  AddDurationFlag(command, "--from", &flags->from_us, "Draw from this virtual time on");
  AddDurationFlag(
      command, "--until", [flags](int64_t us) { flags->until_us = us; },
      "Draw up to this virtual time");
  command->add_option("--stick", flags->stick,
                      "Of a recording: the stick as it was then (default: the recorded folder)");
  command->add_option(
      "--motion", flags->motion,
      "Of a log of a motion: the motion, for times when it has interpolated frames");
  command->callback([flags, exit_code] { *exit_code = Plot(*flags); });
}

}  // namespace openr_host
