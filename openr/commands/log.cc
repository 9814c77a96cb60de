// The command openr log: shows, plots and compares log files of motions that a robot has played
// (file format AIBO_1.1).
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "cli/counted.h"
#include "cli/exit_code.h"
#include "cli/input_file.h"
#include "cli/json_text.h"
#include "cli/print_plain.h"
#include "cli/standard_streams.h"
#include "openr/commands/commands.h"
#include "openr/commands/common_flags.h"
#include "openr/commands/motion_input.h"
#include "openr/motion/log_charts.h"
#include "openr/motion/log_times.h"
#include "runtime/base/read_file.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

constexpr InputKind kLogKind = {"log file of openr rc", ".LOG"};
constexpr double kSameMotionDeg = 0.1;
constexpr LogGroup kGroups[] = {LogGroup::kCommanded, LogGroup::kMeasured, LogGroup::kSimulated};

struct LogFlags {
  // The files to read.  Only the command `compare` uses `other`; "" means that it compares two
  // groups of values in `file`.
  std::string file, other;
  std::string motion;  // motion file that was played for the log; "": not named
  // Names of the groups of values (commanded, measured or simulated) on the two sides of a
  // comparison; "": GroupOf() or GroupWithin() chooses a group that the log of the motion has.
  std::string group, other_group;
  std::string output;  // file for the chart of the log; "": no chart
  bool json = false;
};

// A log of a motion, and the time of each of its records.  A record has the commanded angles of all
// joints at one key frame of the motion, and the measured and simulated angles if they are known.
struct TimedLog {
  std::string name;
  LogFile log;
  std::vector<double> times_ms;
};

LogFile ReadLog(const std::string& file) {
  RequireReadable(file, kLogKind);
  const std::optional<std::string> bytes = ReadFile(file);
  if (!bytes) {
    throw std::runtime_error(fmt::format("{}: cannot be read: {}", file, std::strerror(errno)));
  }
  try {
    return ParseLog(*bytes);
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}: {}", file, error.what()));
  }
}

std::vector<double> TimesOfLog(const std::string& file, const LogFile& log,
                               const std::string& motion_file) {
  try {
    if (motion_file.empty()) return TimesOf(log);
    return TimesOf(log, ReadMotion(motion_file));
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(fmt::format("{}: {}", file, error.what()));
  }
}

TimedLog ReadTimedLog(const std::string& file, const std::string& motion_file) {
  TimedLog timed{std::filesystem::path(file).filename().string(), ReadLog(file), {}};
  timed.times_ms = TimesOfLog(file, timed.log, motion_file);
  return timed;
}

int CountOf(const LogFile& log, LogGroup group) {
  int count = 0;
  for (const LogRecord& record : log.records) {
    if (group == LogGroup::kMeasured ? record.measured.has_value() : record.simulated.has_value())
      ++count;
  }
  return count;
}

// Returns the name that Hohl 2004, section 3.3.6, gives to this kind of motion log.  The kind
// depends on the numbers of key frames with measured and with simulated values.
const char* CaseOf(int measured, int simulated) {
  if (measured > 0 && simulated > 0) return "synchronised play-back";
  if (measured > 0) return "play-back on the robot";
  return simulated > 0 ? "simulated play-back" : "no measured values";
}

void LogInfo(const LogFlags& flags) {
  const LogFile log = ReadLog(flags.file);
  const int measured = CountOf(log, LogGroup::kMeasured);
  const int simulated = CountOf(log, LogGroup::kSimulated);
  std::optional<double> duration_s;
  std::string why_not;
  try {
    const std::vector<double> times_ms = TimesOfLog(flags.file, log, flags.motion);
    duration_s = times_ms.empty() ? 0 : times_ms.back() / 1000;
  } catch (const std::runtime_error& error) {
    why_not = error.what();
  }
  if (flags.json) {
    Json json = {{"file", flags.file},
                 {"format", RC_LOG_HEADER},
                 {"robot", log.robot->design},
                 {"case", CaseOf(measured, simulated)},
                 {"records", log.records.size()},
                 {"measured", measured},
                 {"simulated", simulated},
                 {"duration_s", nullptr}};
    if (duration_s) json["duration_s"] = *duration_s;
    if (!why_not.empty()) json["no_times"] = why_not;
    PrintPlain("{}\n", JsonText(json));
    return;
  }
  PrintPlain("{}: {}, {} joints as the {}, {}\n", flags.file, RC_LOG_HEADER,
             LoggedJoints(*log.robot).size(), log.robot->design, CaseOf(measured, simulated));
  PrintPlain("  {}, {} with measured and {} with simulated values\n",
             Counted(log.records.size(), "record"), measured, simulated);
  if (duration_s) {
    PrintPlain("  {:.3f} s\n", *duration_s);
  } else {
    // Prints the error without its first words, which are the name of the file, because the first
    // line of the output has this name already.
    PrintPlain("  no times: {}\n", why_not.substr(flags.file.size() + 2));
  }
}

const std::optional<LogValues>* ValuesOf(const LogRecord& record, LogGroup group) {
  if (group == LogGroup::kCommanded) return nullptr;
  return group == LogGroup::kMeasured ? &record.measured : &record.simulated;
}

// Prints the columns of one group of values (commanded, measured or simulated) for a key frame of a
// motion log: the joints, and for measured and simulated values also the paws.  If the log does not
// have the group for this key frame, prints empty fields.
void PrintFields(const LogRecord& record, LogGroup group) {
  const std::optional<LogValues>* const values = ValuesOf(record, group);
  const size_t joints = record.commanded_cdeg.size();
  if (values != nullptr && !*values) {
    PrintPlain("{:,>{}}", "", joints + RC_LOG_PAWS);
    return;
  }
  const auto& positions = values == nullptr ? record.commanded_cdeg : (*values)->positions_cdeg;
  for (const int16_t position : positions) PrintPlain(",{:.2f}", position / 100.0);
  if (values == nullptr) return;
  for (const uint16_t paw : (*values)->paws) PrintPlain(",{}", paw);
}

void LogCsv(const LogFlags& flags) {
  const LogFile log = ReadLog(flags.file);
  std::vector<double> times_ms;
  try {
    times_ms = TimesOfLog(flags.file, log, flags.motion);
  } catch (const std::runtime_error& error) {
    // Goes on with an empty column time_ms if the user has named no motion, because no other column
    // needs the times of the motion.
    if (!flags.motion.empty()) throw;
    PrintPlain(stderr, "{}; the column time_ms is empty\n", error.what());
  }
  PrintPlain("record,key_frame,time_ms");
  for (const LogGroup group : kGroups) {
    for (const JointConstants* const joint : LoggedJoints(*log.robot))
      PrintPlain(",{}_{}_deg", joint->name, NameOf(group));
    if (group == LogGroup::kCommanded) continue;
    for (const char* const leg : {"LF", "LH", "RF", "RH"})
      PrintPlain(",paw_{}_{}", leg, NameOf(group));
  }
  PrintPlain("\n");
  for (size_t i = 0; i < log.records.size(); ++i) {
    PrintPlain("{},{},", i, log.records[i].key_frame);
    if (!times_ms.empty()) PrintPlain("{}", times_ms[i]);
    for (const LogGroup group : kGroups) PrintFields(log.records[i], group);
    PrintPlain("\n");
  }
}

void WriteChartFile(const chart::Chart& picture, const std::string& file) {
  const std::string problem = chart::WriteChart(picture, file);
  if (!problem.empty()) throw std::runtime_error(problem);
}

void LogPlot(const LogFlags& flags) {
  const TimedLog timed = ReadTimedLog(flags.file, flags.motion);
  WriteChartFile(ChartOf(timed.log, timed.times_ms, timed.name), flags.output);
}

// Returns the group of values (commanded, measured or simulated) for one side of a comparison of
// two logs.  This is the group that the flag names.  Without the flag, it is the values of the real
// robot if the log of the motion has them, else the simulated values.
LogGroup GroupOf(const std::string& flag, const LogFile& log) {
  for (const LogGroup group : kGroups) {
    if (flag == NameOf(group)) return group;
  }
  return CountOf(log, LogGroup::kMeasured) > 0 ? LogGroup::kMeasured : LogGroup::kSimulated;
}

// Returns the group of values for one side of a comparison within one log of a motion.  This is the
// group that the flag `flag` names.  Without the flag, it is the first of `groups` that the log
// has, but never `other`, the group of the other side, because a comparison of a group with itself
// says nothing.  If there is no such group, returns the commanded values or, if these are `other`,
// the measured values.
LogGroup GroupWithin(const std::string& flag, const std::string& other, const LogFile& log,
                     std::initializer_list<LogGroup> groups) {
  if (!flag.empty()) return GroupOf(flag, log);
  for (const LogGroup group : groups) {
    if (other != NameOf(group) && CountOf(log, group) > 0) return group;
  }
  return other == NameOf(LogGroup::kCommanded) ? LogGroup::kMeasured : LogGroup::kCommanded;
}

ComparedSide SideOf(const TimedLog& timed, LogGroup group, const std::string& label) {
  ComparedSide side{TracesOf(timed.log, timed.times_ms, group), label};
  if (side.traces.times_ms.empty()) {
    throw std::runtime_error(fmt::format("{}: has no {} values", timed.name, NameOf(group)));
  }
  return side;
}

// Compares two groups of values of one log of a motion.  A synchronised log has the values of two
// robots, and these are compared.  In any other log the values of the robot are compared with the
// commanded positions.
Comparison CompareWithin(const LogFlags& flags) {
  const TimedLog timed = ReadTimedLog(flags.file, flags.motion);
  const LogGroup second = GroupWithin(flags.other_group, flags.group, timed.log,
                                      {LogGroup::kSimulated, LogGroup::kMeasured});
  const LogGroup first = GroupWithin(flags.group, NameOf(second), timed.log,
                                     {LogGroup::kMeasured, LogGroup::kSimulated});
  Comparison comparison;
  comparison.title = timed.name;
  comparison.a = SideOf(timed, first, NameOf(first));
  comparison.b = SideOf(timed, second, NameOf(second));
  if (first != LogGroup::kCommanded && second != LogGroup::kCommanded)
    comparison.commanded = TracesOf(timed.log, timed.times_ms, LogGroup::kCommanded);
  comparison.robot = timed.log.robot;
  return comparison;
}

// Prints a warning if two logs seem to be of different motions.  This is only a warning, because
// similar motions can be compared as well.
void WarnIfMotionsDiffer(const TimedLog& first, const TimedLog& second) {
  const std::vector<const JointConstants*> joints = LoggedJoints(*first.log.robot);
  const size_t count = std::min(first.log.records.size(), second.log.records.size());
  // Skips the first record of each log.  Its commanded positions are from before the motion, so
  // they may differ even if the motions are the same.
  for (size_t i = 1; i < count; ++i) {
    const LogRecord& a = first.log.records[i];
    const LogRecord& b = second.log.records[i];
    if (a.key_frame != b.key_frame) continue;
    for (size_t j = 0; j < joints.size(); ++j) {
      const double a_deg = a.commanded_cdeg[j] / 100.0, b_deg = b.commanded_cdeg[j] / 100.0;
      if (std::abs(a_deg - b_deg) <= kSameMotionDeg) continue;
      PrintPlain(stderr,
                 "openr: warning: the logs are of different motions: {} is commanded to {:.2f} and "
                 "{:.2f} degrees at key frame {}\n",
                 joints[j]->name, a_deg, b_deg, a.key_frame);
      return;
    }
  }
}

// Returns the name of a file with the name of its folder in front.
std::string WithFolder(const std::string& file) {
  const std::filesystem::path path = std::filesystem::absolute(file);
  return (path.parent_path().filename() / path.filename()).string();
}

Comparison CompareFiles(const LogFlags& flags) {
  const TimedLog first = ReadTimedLog(flags.file, flags.motion);
  const TimedLog second = ReadTimedLog(flags.other, flags.motion);
  if (first.log.robot != second.log.robot) {
    throw std::runtime_error(fmt::format("{} is of an {}, {} of an {}: their joints differ",
                                         flags.file, first.log.robot->design, flags.other,
                                         second.log.robot->design));
  }
  WarnIfMotionsDiffer(first, second);
  const LogGroup group = GroupOf(flags.group, first.log);
  const LogGroup other_group = GroupOf(flags.other_group, second.log);
  // Adds the folders to the labels of the curves if both files have the same name, because the
  // labels would otherwise be equal.
  const bool same = first.name == second.name;
  const std::string name = same ? WithFolder(flags.file) : first.name;
  const std::string other_name = same ? WithFolder(flags.other) : second.name;
  Comparison comparison;
  comparison.title = fmt::format("{} and {}", name, other_name);
  comparison.a = SideOf(first, group, fmt::format("{} {}", name, NameOf(group)));
  comparison.b = SideOf(second, other_group, fmt::format("{} {}", other_name, NameOf(other_group)));
  comparison.commanded = TracesOf(first.log, first.times_ms, LogGroup::kCommanded);
  comparison.robot = first.log.robot;
  return comparison;
}

Json JsonOf(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

void PrintComparisonJson(const Comparison& comparison) {
  Json joints = Json::array();
  const std::vector<const JointConstants*> names = LoggedJoints(*comparison.robot);
  for (size_t j = 0; j < names.size(); ++j) {
    const JointDifference& d = comparison.differences[j];
    joints.push_back({{"joint", names[j]->name},
                      {"mean_deg", d.mean_deg},
                      {"max_deg", d.max_deg},
                      {"rms_deg", d.rms_deg},
                      {"lag_ms", JsonOf(d.lag_ms)},
                      {"gain", JsonOf(d.gain)},
                      {"rms_after_lag_deg", JsonOf(d.rms_after_lag_deg)}});
  }
  const Json json = {{"a", comparison.a.label}, {"b", comparison.b.label}, {"joints", joints}};
  PrintPlain("{}\n", JsonText(json));
}

std::string Field(const std::optional<double>& value, int decimals) {
  return value ? Rounded(*value, decimals) : "-";
}

void PrintComparison(const Comparison& comparison) {
  PrintPlain("{}: {} against {}\n", comparison.title, comparison.b.label, comparison.a.label);
  PrintPlain("  {:<12} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}\n", "joint", "mean", "max", "RMS", "lag",
             "gain", "RMS");
  PrintPlain("  {:<12} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}\n", "", "deg", "deg", "deg", "ms", "",
             "shifted");
  const std::vector<const JointConstants*> names = LoggedJoints(*comparison.robot);
  for (size_t j = 0; j < names.size(); ++j) {
    const JointDifference& d = comparison.differences[j];
    PrintPlain("  {:<12} {:>8} {:8.2f} {:8.2f} {:>8} {:>8} {:>8}\n", names[j]->name,
               Field(d.mean_deg, 2), d.max_deg, d.rms_deg, Field(d.lag_ms, 1), Field(d.gain, 3),
               Field(d.rms_after_lag_deg, 2));
  }
}

void LogCompare(const LogFlags& flags) {
  Comparison comparison = flags.other.empty() ? CompareWithin(flags) : CompareFiles(flags);
  comparison.differences = CompareTraces(comparison.a.traces, comparison.b.traces);
  flags.json ? PrintComparisonJson(comparison) : PrintComparison(comparison);
  if (flags.output.empty()) return;
  WriteChartFile(ChartOf(comparison), flags.output);
}

using LogAction = void (*)(const LogFlags& flags);

// Runs `action` and returns the exit code.  If `action` throws an error, prints the error on
// standard error and, with --json, also as JSON on standard output.
int PerformLog(LogAction action, const LogFlags& flags) {
  try {
    action(flags);
    return kExitGood;
  } catch (const std::system_error&) {
    throw;  // the answer cannot be written; program.cc reports this error
  } catch (const ReaderGone&) {
    throw;
  } catch (const std::runtime_error& error) {
    PrintPlain(stderr, "openr: {}\n", error.what());
    if (flags.json) PrintPlain("{}\n", JsonText(Json{{"error", error.what()}}));
    return kExitWrong;
  }
}

}  // namespace

void AddLogCommand(CLI::App* app, int* exit_code) {
  CLI::App* const log = app->add_subcommand("log", "Log files of motions (AIBO_1.1)");
  log->require_subcommand(1);
  auto flags = std::make_shared<LogFlags>();
  const auto add = [&](const char* name, const char* about, LogAction action) {
    CLI::App* const command = log->add_subcommand(name, about);
    command->add_option("FILE", flags->file, "The log")->required();
    command->add_option("--motion", flags->motion,
                        "The motion of the log, for times when it has interpolated frames");
    command->callback([flags, exit_code, action] { *exit_code = PerformLog(action, *flags); });
    return command;
  };
  CLI::App* const info = add("info", "What is in a log", &LogInfo);
  add("csv", "All records as comma-separated values, positions in degrees", &LogCsv);
  CLI::App* const plot = add("plot", "A chart of every joint", &LogPlot);
  CLI::App* const compare = add(
      "compare", "Error, lag and gain of every joint, between two logs or within one", &LogCompare);
  compare->add_option("OTHER", flags->other,
                      "The log to compare with FILE; without it the groups of FILE are compared");
  const auto groups = CLI::IsMember({"commanded", "measured", "simulated"});
  compare->add_option("--group", flags->group, "Values of FILE to compare")->check(groups);
  compare->add_option("--other-group", flags->other_group, "Values to compare them with")
      ->check(groups);
  for (CLI::App* const command : {info, compare})
    command->add_flag("--json", flags->json, "One JSON object");
  AddChartOption(plot, &flags->output)->required();
  AddChartOption(compare, &flags->output);
}

}  // namespace openr_host
