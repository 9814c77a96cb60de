#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/console.h"
#include "cli/counted.h"
#include "cli/exit_code.h"
#include "cli/json_text.h"
#include "cli/output_file.h"
#include "cli/standard_streams.h"
#include "openr/commands/commands.h"
#include "openr/commands/common_flags.h"
#include "openr/commands/distributed_run.h"
#include "openr/commands/distribution_flags.h"
#include "openr/ending/crash_log.h"
#include "openr/ending/ending.h"
#include "openr/ending/watchdog.h"
#include "openr/inspect/recorder.h"
#include "openr/run/interrupt.h"
#include "openr/run/report.h"
#include "openr/run/runner.h"
#include "openr/simulation/network_setup.h"
#include "openr/simulation/run_stick.h"
#include "openr/simulation/simulation.h"
#include "runtime/base/duration.h"

namespace openr_host {
namespace {

struct RunFlags {
  SimulationOptions simulation;
  PlacementFlags placement;
  Ros2Flags ros2;
  std::optional<int64_t> for_us;
  const CLI::Option* for_flag = nullptr;
  bool until_idle = false;
  std::string rate = "1";
  std::string report_file;
  std::string record_file;
  bool no_payloads = false;
  bool json = false;
  bool no_panel = false;
  const CLI::Option* panel = nullptr;  // --panel, with or without an address
  std::string panel_address;
  std::string log = "info";
  std::string console_file;
  std::string stdin_file;
  int64_t handler_limit_us = 10'000'000;
  std::vector<std::string> snapshots;
  std::vector<std::string> snapshot_files;
};

void DescribeRun(CLI::App* command, RunFlags* flags) {
  AddCommonFlags(command, &flags->simulation);
  flags->for_flag = AddDurationFlag(
      command, "--for", [flags](int64_t us) { flags->for_us = us; },
      "How long to run, in virtual time: 20s, 250ms");
  command->add_flag("--until-idle", flags->until_idle,
                    "Run until no object has sent anything for 1 s of virtual time; sensor values "
                    "and asking for more of them do not count. The default stick never rests: its "
                    "controller moves lights and tail, so give --for as well");
  command->add_option("--rate", flags->rate, "Virtual seconds per second, or max")
      ->capture_default_str();
  command
      ->add_option("--robots", flags->simulation.robots,
                   "Number of robots, each in a world of its own, on one read-only stick")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command
      ->add_option("--body", flags->simulation.body, "ode: physics; ideal: joints follow exactly")
      ->check(CLI::IsMember({"ode", "ideal"}))
      ->capture_default_str();
  AddBatteryFlag(command, &flags->simulation);
  command->add_flag("--strict", flags->simulation.strict,
                    "Enforce the limits of the robot; refuse wrong wiring");
  AddCostFlag(command, &flags->simulation);
  command
      ->add_option("--speaker", flags->simulation.speaker,
                   "WAV file for what the first robot's speaker plays")
      ->check(IsWritable());
  command
      ->add_option("--mic", flags->simulation.microphone,
                   "WAV file the first robot's microphone hears (default: silence)")
      ->check(IsReadable("--mic", "WAV file", ".wav"));
  const auto has_pictures = [](const std::string& folder) -> std::string {
    RefuseInput("--images", folder, WhyNoReadableFolder(folder, "folder of pictures"));
    return "";
  };
  command
      ->add_option("--images", flags->simulation.images,
                   "Folder of pictures the first robot's camera sees, in order of their names "
                   "(default: a test pattern)")
      ->check(CLI::Validator(has_pictures, ""));
  AddDurationFlag(command, "--handler-limit", &flags->handler_limit_us,
                  "End the run when a handler uses more processor time; 0s: never");
  AddPlacementFlags(command, &flags->placement);
  AddRos2Flags(command, &flags->ros2);
}

std::string WhyNoPortNumber(const std::string& text) {
  int port = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, port);
  if (error == std::errc() && stop == end && port >= 0 && port <= 65535) return "";
  return fmt::format("'{}' is no port; give a number from 1 to 65535, or 0 for any free port",
                     text);
}

void DescribeOutput(CLI::App* command, RunFlags* flags) {
  command->add_option("--report", flags->report_file, "Write the report to this file")
      ->check(IsWritable());
  command->add_flag("--json", flags->json, "Print the report, and nothing else, as JSON");
  command
      ->add_option("--record", flags->record_file,
                   "Write inputs and messages to this file, for openr replay and openr trace")
      ->check(IsWritable());
  command
      ->add_flag("--no-payloads", flags->no_payloads,
                 "Record hashes of messages instead of their bytes")
      ->needs(command->get_option("--record"));
  command->add_option("--log", flags->log, "Lines of objects to print")
      ->check(CLI::IsMember({"error", "warning", "info"}))
      ->capture_default_str();
  command
      ->add_option("--console", flags->console_file,
                   "File for what objects print (default: standard error)")
      ->check(IsWritable());
  const auto is_typed = [](const std::string& file) -> std::string {
    if (file != "-") RefuseInput("--stdin", file, WhyNotReadable(file, "file of lines", ".txt"));
    return "";
  };
  command
      ->add_option("--stdin", flags->stdin_file,
                   "What is typed on the robots' console: a file, from the start; -: lines of "
                   "standard input as they come (default if it is a terminal)")
      ->check(CLI::Validator(is_typed, ""));
  command
      ->add_option("--snapshot", flags->snapshots,
                   "Take a picture: t=5s,view=side (front, top, iso, follow),size=1280x720")
      ->take_all();
  command->add_option("-o", flags->snapshot_files, "PNG file of the --snapshot before it")
      ->take_all()
      ->check(IsWritable());
  command
      ->add_option("--rc-port", flags->simulation.rc_port,
                   "Port of the remote control; 0: any free one")
      ->check(CLI::Validator(&WhyNoPortNumber, "UINT"));
  command
      ->add_option_function<std::vector<std::string>>(
          "--ip",
          [flags](const std::vector<std::string>& texts) {
            for (const std::string& text : texts) {
              AddressPair pair;
              std::string problem = ParseAddressPair(text, &pair);
              if (problem.empty()) problem = AddAddressPair(pair, &flags->simulation.addresses);
              if (!problem.empty()) throw CLI::ValidationError("--ip", problem);
            }
          },
          "Address that programs have compiled in, and where it is: 10.0.1.2=127.0.0.1; may be "
          "repeated, and goes before the stick's HOSTADDR.CFG")
      ->allow_extra_args(false)
      ->type_name("ROBOT=HOST")
      ->take_all();
  command->add_flag("--no-panel", flags->no_panel, "No web panel");
  flags->panel =
      command->add_option("--panel", flags->panel_address, "Web panel (not in this version)")
          ->expected(0, 1);
}

// Returns the reason why a run with the flags `flags` cannot take the picture that `plan`, a value
// of --snapshot, asks for; "" if it can.
std::string Misfit(const PictureRequest& plan, const RunFlags& flags) {
  if (plan.robot >= flags.simulation.robots) return fmt::format("there is no robot {}", plan.robot);
  if (flags.for_us && plan.time_us > *flags.for_us) {
    return fmt::format("t={} is after the end of the run (--for {}); t=end is its end",
                       FormatDuration(plan.time_us), flags.for_flag->as<std::string>());
  }
  return "";
}

std::vector<PictureRequest> PictureRequests(const RunFlags& flags) {
  if (flags.snapshots.size() != flags.snapshot_files.size()) {
    throw CLI::ValidationError("--snapshot",
                               fmt::format("{} given, with {} (-o FILE)", flags.snapshots.size(),
                                           Counted(flags.snapshot_files.size(), "file")));
  }
  std::vector<PictureRequest> plans;
  for (size_t i = 0; i < flags.snapshots.size(); ++i) {
    PictureRequest plan;
    plan.file = flags.snapshot_files[i];
    std::string problem = ParsePictureRequest(flags.snapshots[i], &plan);
    if (problem.empty()) problem = Misfit(plan, flags);
    if (!problem.empty()) throw CLI::ValidationError("--snapshot", problem);
    plans.push_back(std::move(plan));
  }
  return plans;
}

double RateOf(const std::string& text) {
  if (text == "max") return 0;
  char* end = nullptr;
  const double rate = std::strtod(text.c_str(), &end);
  if (!text.empty() && *end == 0 && rate >= 0.001 && rate <= 1000) return rate;
  throw CLI::ValidationError(
      "--rate", fmt::format("'{}' is neither 'max' nor a number from 0.001 to 1000", text));
}

// Throws if two flags name the same file, because each would overwrite what the other writes.
void CheckThatFilesDiffer(const RunFlags& flags) {
  std::vector<std::pair<std::string, std::string>> named = {
      {"--report", flags.report_file},   {"--record", flags.record_file},
      {"--console", flags.console_file}, {"--speaker", flags.simulation.speaker},
      {"--stdin", flags.stdin_file},     {"--mic", flags.simulation.microphone}};
  for (const std::string& file : flags.snapshot_files) named.emplace_back("-o", file);
  std::map<std::string, std::string> flag_of;
  for (const auto& [flag, file] : named) {
    if (file.empty() || file == "-" || file == "/dev/null") continue;
    std::error_code error;  // set for a stream such as /dev/stdout, which is no file
    const std::string real = std::filesystem::weakly_canonical(file, error);
    const auto [first, is_new] = flag_of.emplace(error ? file : real, flag);
    if (!is_new) {
      throw CLI::ValidationError(flag,
                                 fmt::format("{} is the file of {} already", file, first->second));
    }
  }
}

// Throws if the run would write something else than the JSON object of --json to standard output.
void CheckStandardOutput(const RunFlags& flags) {
  if (!flags.json) return;
  const std::pair<const char*, const std::string&> named[] = {
      {"--report", flags.report_file},
      {"--record", flags.record_file},
      {"--console", flags.console_file},
      {"--speaker", flags.simulation.speaker}};
  for (const auto& [flag, file] : named) {
    if (!IsStandardOutput(file)) continue;
    throw CLI::ValidationError(
        flag, fmt::format("{} is where --json writes the report; leave out one of the two", file));
  }
}

// Throws CLI::ValidationError when the flags contradict each other.
RunPlan PlanOf(const RunFlags& flags) {
  CheckThatFilesDiffer(flags);
  CheckStandardOutput(flags);
  if (flags.panel->count() > 0) {
    throw CLI::ValidationError("--panel", "there is no web panel in this version");
  }
  const int rc_port = flags.simulation.rc_port;
  if (const std::string problem = WhyNoPort(rc_port); !problem.empty())
    throw CLI::ValidationError("--rc-port", problem);
  RunPlan plan;
  plan.for_us = flags.for_us;
  if (flags.for_us) plan.for_text = flags.for_flag->as<std::string>();
  plan.until_idle = flags.until_idle;
  plan.rate = RateOf(flags.rate);
  plan.snapshots = PictureRequests(flags);
  plan.stdin_file = flags.stdin_file;
  plan.say = [](const std::string& line) { fmt::print(stderr, "openr: {}\n", line); };
  if (flags.placement.is_free && plan.rate <= 0)
    throw CLI::ValidationError("--free-running", "needs a clock: --rate max has none");
  return plan;
}

// Prints `problem`, unless it is "".  Returns whether it is "".
bool IsGood(const std::string& problem) {
  if (!problem.empty()) fmt::print(stderr, "openr: {}\n", problem);
  return problem.empty();
}

bool Answer(const std::string& text) {
  try {
    PrintAnswer(text);
    return true;
  } catch (const std::exception& error) {
    return IsGood(error.what());
  }
}

// Writes the report to standard output (with --json) and to the file of --report.  Returns false
// after printing an error.
bool WriteReport(const nlohmann::ordered_json& report, const RunFlags& flags) {
  const bool is_answered = !flags.json || Answer(JsonText(report) + "\n");
  if (flags.report_file.empty()) return is_answered;
  return IsGood(WriteFile(flags.report_file, JsonText(report, 2) + "\n")) && is_answered;
}

std::string Summary(const nlohmann::ordered_json& report, const std::optional<RunEnd>& end) {
  std::string text = fmt::format(
      "{:.3f} s of virtual time in {:.3f} s, {:.1f} x real time; {}; state {}\n",
      report["virtual_time_s"].get<double>(), report["wall_time_s"].get<double>(),
      report["x_real_time"].get<double>(), Counted(report["messages"].get<uint64_t>(), "message"),
      report["state_hash"].get<std::string>());
  for (const auto& robot : report["robots"]) {
    text += fmt::format("{}: {}\n", robot["model"].get<std::string>(),
                        robot["standing"].get<bool>() ? "standing" : "not standing");
  }
  if (end) text += DescribeEnd(*end) + "\n";
  return text;
}

// Writes the report when an object ends the run, by a crash or by a handler that does not return.
// The report has the present state and, as "error", the record of the crash.
void ReportTheEnding(Ending* ending, Simulation* simulation, DistributedRun* distribution,
                     const RunFacts& facts, const RunFlags& flags) {
  {
    const CurrentScope scope(&simulation->system(), ending->object);
    simulation->system().AddFinding(Severity::kError, std::string(ending->finding.text()));
    simulation->system().NoteRunEnd(EndOf(*ending));
  }
  distribution->ShortenTimeouts();
  simulation->CloseFiles();
  nlohmann::ordered_json report = MakeReport(simulation, facts);
  distribution->Describe(&report);
  std::string_view record = ending->record.text();
  while (record.ends_with('\n')) record.remove_suffix(1);
  report["error"] = std::string(record);
  WriteReport(report, flags);
  ending->answered = true;
  distribution->EndProcesses();
}

// One run of `openr run`, from the flags to the report.
class CommandedRun {
 public:
  explicit CommandedRun(const RunFlags& flags);

  // Runs the simulation and writes the report.  Returns the exit code.
  int Run();

 private:
  SimulationOptions Options();
  void NoteThatItDoesNotBoot(bool is_refused);
  bool RunToTheEnd();
  bool Report();

  bool records() const { return !flags_.record_file.empty(); }
  System& system() { return simulation_.system(); }

  const RunFlags flags_;
  RunPlan plan_;
  const RunStick stick_;
  Console console_;
  const InterruptCounter interrupts_;
  Recorder recorder_;
  DistributedRun distribution_;
  const SimulationOptions options_;
  Simulation simulation_;
  bool boots_ = false;
  RunFacts facts_;
};

CommandedRun::CommandedRun(const RunFlags& flags)
    : flags_(flags),
      plan_(PlanOf(flags)),
      stick_(flags.simulation.stick, flags.simulation.robots == 1),
      console_(flags.console_file),
      interrupts_(plan_.for_us || plan_.until_idle ? HangUp::kIgnored : HangUp::kCounts),
      recorder_(flags.record_file, !flags.no_payloads),
      distribution_(flags.placement, flags.ros2, stick_, flags.handler_limit_us, &interrupts_),
      options_(Options()),
      simulation_(options_) {
  facts_.seed = options_.seed;
}

// Returns the options of the simulation: those of the flags, to which the console, the recorder and
// the connections of `distribution_` are added.
SimulationOptions CommandedRun::Options() {
  SimulationOptions options = flags_.simulation;
  options.stick = stick_.folder();
  options.log_level = flags_.log == "error" ? 1 : flags_.log == "warning" ? 2 : 3;
  options.console = [this](std::string_view text) { console_.Print(text); };
  if (records()) recorder_.Listen(&options);
  // DistributedRun::Enter() adds the network client of ROS 2 after the recorder has added itself,
  // because the recorder must see the commands of ROS 2 as input.
  distribution_.Enter(&options, plan_.say);
  return options;
}

int CommandedRun::Run() {
  if (simulation_.loaded()) distribution_.CheckPlaces();
  console_.Print(DescribeObjects(&simulation_));
  const bool is_refused = flags_.simulation.strict && system().findings().HasError();
  boots_ = simulation_.loaded() && !is_refused && distribution_.Connect(&simulation_);
  bool good = boots_;
  if (!boots_) NoteThatItDoesNotBoot(is_refused);
  // After a Ctrl-C during the boot, nobody knows whether the robot would have booted.  So `boots_`
  // is set, because otherwise the program would print that the robot does not boot.
  if (!boots_ && interrupts_.count() > 0) boots_ = true;
  if (good) {
    good = RunToTheEnd();
  } else {
    facts_.standing.assign(simulation_.robots().size(), StandingMonitor(simulation_.model()));
  }
  good = Report() && good;
  return good && !system().findings().HasError() ? kExitGood : kExitWrong;
}

void CommandedRun::NoteThatItDoesNotBoot(bool is_refused) {
  RunEnd end{EndKind::kNoBoot, "the robot does not boot; the findings say why"};
  if (simulation_.loaded()) {
    end.why = is_refused ? "--strict refuses what the findings name; no object was started"
                         : "a process with objects of the run did not come";
    if (interrupts_.count() > 0)
      end = {EndKind::kSignal, "Ctrl-C or SIGTERM came while a process was waited for"};
  }
  system().NoteRunEnd(end);
}

// Boots the robots and runs the simulation to its end.  Returns false after printing an error.
bool CommandedRun::RunToTheEnd() {
  const EndingAnswer answer(flags_.json ? StandardOutput() : -1, flags_.report_file);
  // The crash record of a run on the default stick is in a folder that users do not know.  So
  // `place` gets a value, which makes the finding name the record's file.  The value is "", because
  // no text needs to follow the file's name.
  std::optional<std::string> place;
  if (stick_.is_default()) place = "";
  const CrashLog crash_log(
      std::vector<std::string>(static_cast<size_t>(options_.robots), stick_.crash_log()),
      distribution_.has_processes(), place);
  const Watchdog watchdog(flags_.handler_limit_us);
  if (records()) {
    recorder_.Begin(&simulation_, options_, stick_.name(), flags_.placement.is_free);
    plan_.recorder = &recorder_;
  }
  distribution_.Begin(&simulation_, &plan_);
  Runner runner(&simulation_, plan_, &interrupts_);
  const auto learn_facts = [this, &runner] {
    facts_.wall_time_s = runner.wall_time_s();
    facts_.standing = runner.standing();
  };
  const EndingAction ending_action([&](Ending* ending) {
    learn_facts();
    ReportTheEnding(ending, &simulation_, &distribution_, facts_, flags_);
  });
  bool good = runner.Run();
  distribution_.RunIsOver();
  learn_facts();
  if (records()) good = IsGood(recorder_.Finish(&system())) && good;
  boots_ = system().booted() || !system().powered_off() || interrupts_.count() >= 2;
  return good;
}

// Writes the report, with facts that workers send, and then ends the worker processes.  Returns
// false after printing an error.
bool CommandedRun::Report() {
  distribution_.ReportLosses();
  const bool is_stopped = system().end() && system().end()->kind == EndKind::kStrict;
  if (!boots_ && !is_stopped) fmt::print(stderr, "openr: the robot does not boot\n");
  EndConsoleLine();
  nlohmann::ordered_json report = MakeReport(&simulation_, facts_);
  distribution_.Describe(&report);
  distribution_.EndProcesses();
  fmt::print(stderr, "{}{}", DescribeFindings(&simulation_), Summary(report, system().end()));
  const bool is_written = WriteReport(report, flags_);
  return IsGood(console_.Problem()) && is_written;
}

}  // namespace

void AddRunCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command =
      app->add_subcommand("run", "Runs the objects of a stick; Ctrl-C is the pause button");
  auto flags = std::make_shared<RunFlags>();
  DescribeRun(command, flags.get());
  DescribeOutput(command, flags.get());
  command->callback([flags, exit_code] { *exit_code = CommandedRun(*flags).Run(); });
}

}  // namespace openr_host
