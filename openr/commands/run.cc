#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/colour.h"
#include "cli/console.h"
#include "cli/counted.h"
#include "cli/exit_code.h"
#include "cli/json_text.h"
#include "cli/output_file.h"
#include "cli/print_plain.h"
#include "cli/progress_line.h"
#include "cli/standard_streams.h"
#include "openr/commands/commands.h"
#include "openr/commands/distributed_run.h"
#include "openr/commands/robot_jobs.h"
#include "openr/commands/run_flags.h"
#include "openr/data/data_log.h"
#include "openr/ending/end_guards.h"
#include "openr/inspect/recorder.h"
#include "openr/inspect/trace_file.h"
#include "openr/live/console_log.h"
#include "openr/live/couplings.h"
#include "openr/live/live_answers.h"
#include "openr/live/live_context.h"
#include "openr/live/live_events.h"
#include "openr/live/live_folder.h"
#include "openr/live/live_server.h"
#include "openr/live/message_history.h"
#include "openr/live/run_clock.h"
#include "openr/panel/panel_process.h"
#include "openr/rewind/rewind.h"
#include "openr/rewind/saved_files.h"
#include "openr/rewind/stick_entries.h"
#include "openr/run/event_script.h"
#include "openr/run/gdb_start.h"
#include "openr/run/interrupt.h"
#include "openr/run/report.h"
#include "openr/run/runner.h"
#include "openr/run/stick_lock.h"
#include "openr/simulation/run_stick.h"
#include "openr/simulation/sanitizer_start.h"
#include "openr/simulation/simulation.h"
#include "openr/timeline/timeline.h"
#include "runtime/base/terminal_text.h"
#include "runtime/core/system.h"
#include "runtime/core/write_errors.h"

namespace openr_host {
namespace {

// Prints `problem` as an error, unless it is "".  Returns true if `problem` is "".
bool IsGood(const std::string& problem) {
  if (!problem.empty()) PrintPlain(stderr, "openr: {}\n", problem);
  return problem.empty();
}

bool Answer(const std::string& text) {
  try {
    PrintAnswer(text);
    return true;
  } catch (const ReaderGone&) {
    return true;  // goes on without a reader, because the files of the run must still be written
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
// The report has the present state of the run, and the crash record as its member "error".
void ReportTheEnding(Ending* ending, Simulation* simulation, DistributedRun* distribution,
                     const RunFacts& facts, const RunFlags& flags) {
  NoteTheEnding(*ending, simulation);
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
  // Calls PrintHandledMessage() last, so that the report is written even if this call crashes.
  // PrintHandledMessage() prints the message whose handler has ended the process.
  PrintHandledMessage(*ending);
}

// Reads the script of --events.  Throws CLI::ValidationError, with the place in the file, if the
// script is wrong or cannot be read.
EventScript ReadEvents(const std::string& file) {
  try {
    return EventScript(file);
  } catch (const std::exception& error) {
    throw CLI::ValidationError("--events", error.what());
  }
}

// Makes the server for `openr poke`, `openr attach` and the panel.  Returns null if the socket of
// the server cannot be made; the run then goes on without the server.
std::unique_ptr<LiveServer> MakeLiveServer(const LiveContext& context, const std::string& name,
                                           Couplings* couplings) {
  try {
    const auto answer = [context](const nlohmann::json& request) {
      return AnswerLive(context, request);
    };
    return std::make_unique<LiveServer>(name, answer, context.events, couplings);
  } catch (const std::exception& error) {
    PrintPlain(stderr, "openr: openr poke and attach cannot reach this run: {}\n", error.what());
    return nullptr;
  }
}

// Starts the server of the panel.  The server reaches the run through the socket of `live`.
// Returns null if the run has no panel.
std::unique_ptr<PanelProcess> StartPanel(const RunFlags& flags, const LiveServer* live,
                                         const std::string& name) {
  if (live == nullptr && flags.listen.is_on())
    throw std::runtime_error("--listen: the panel cannot reach this run, as said above");
  if (live == nullptr || !WantsPanel(flags)) return nullptr;
  const std::filesystem::path socket = LiveSocketPath(name);
  return std::make_unique<PanelProcess>(PanelOptions{.port = flags.panel_port,
                                                     .run = socket.filename(),
                                                     .listen = flags.listen,
                                                     .robots = flags.simulation.robots});
}

// Carries out `openr run`: makes the run that the flags describe, and writes its report.
class CommandedRun {
 public:
  explicit CommandedRun(const RunFlags& flags);

  // Runs the simulation and writes the report.  Returns the exit code.
  int Run();

 private:
  SimulationOptions Options();
  void ReportNoBoot(const std::string& problem);
  std::string LiveName() const;
  std::string ReasonNotRewindable() const;
  void BeginRewind(LiveServer* live, Runner* runner);
  // Returns the file descriptor to which the progress of the run is printed.  Returns -1, so that
  // no progress is printed, if the end of the run is not known, or if a program reads the output.
  int ProgressStream() const { return plan_.for_us && !flags_.json ? STDERR_FILENO : -1; }
  EndGuardOptions GuardOptions() const;
  void BeginRecording();
  void BeginDataLog();
  bool RunToTheEnd();
  bool FinishFiles();
  bool Report();

  bool records() const { return !flags_.record_file.empty(); }
  System& system() { return simulation_.system(); }

  const RunFlags flags_;
  RunPlan plan_;
  const RunStick stick_;
  const StickLock stick_lock_;
  Console console_;
  ConsoleLog console_log_;
  InterruptCounter interrupts_;
  EventScript events_;
  Recorder recorder_;
  std::unique_ptr<DataLog> data_log_;   // log of --log-data; null: the flag was not given
  std::unique_ptr<Timeline> timeline_;  // file of --timeline; null: the flag was not given
  DistributedRun distribution_;
  Rewind rewind_;
  const SimulationOptions options_;
  // Made before the simulation, because code of images runs while the simulation loads them, and
  // may crash.
  std::optional<EndGuards> guards_;
  Simulation simulation_;
  const SimulationRelease simulation_release_{&distribution_};
  RunClock clock_;
  Couplings couplings_{&clock_, &rewind_};
  MessageHistory history_;
  LiveEvents live_events_;
  const LiveContext live_context_;
  bool is_silent_ = false;     // true: a checkpoint or a view, which prints nothing
  bool is_assembled_ = false;  // true: `simulation_` has been assembled
  bool boots_ = false;
  RunFacts facts_;
};

CommandedRun::CommandedRun(const RunFlags& flags)
    : flags_(flags),
      plan_(PlanOf(flags)),
      stick_(flags.simulation.stick, flags.simulation.robots == 1),
      stick_lock_(stick_.is_default() || flags.simulation.robots > 1 ? "" : stick_.name()),
      console_(flags.console_file),
      interrupts_(plan_.for_us || plan_.until_idle ? HangUp::kIgnored : HangUp::kCounts),
      events_(ReadEvents(flags.events_file)),
      recorder_(flags.record_file, !flags.no_payloads),
      distribution_(flags.placement, flags.ros2, stick_, flags.handler_limit_us, &interrupts_),
      options_(Options()),
      guards_(std::in_place, GuardOptions()),
      simulation_(options_),
      clock_(plan_.rate, flags.placement.is_free),
      history_(&system()),
      live_events_({&simulation_, &clock_, &console_log_, &history_, nullptr, &rewind_}),
      live_context_{&simulation_, &clock_, &console_log_, &history_, &live_events_, &rewind_} {
  is_assembled_ = true;
  if (!stick_lock_.note().empty()) PrintPlain(stderr, "openr: note: {}\n", stick_lock_.note());
  facts_.seed = options_.seed;
  plan_.events = &events_;
  if (const std::string problem = events_.Check(system()); !problem.empty())
    throw CLI::ValidationError("--events", problem);
}

// Returns the options with which the simulation is made: the options from the flags, with the
// console, the recorder and the connections to other processes (`distribution_`) added.
SimulationOptions CommandedRun::Options() {
  SimulationOptions options = flags_.simulation;
  options.stick = stick_.folder();
  options.log_level = flags_.log == "error" ? 1 : flags_.log == "warning" ? 2 : 3;
  options.console = [this](std::string_view text) {
    if (!is_silent_) console_.Print(text);
    // Uses time 0 for text that images print while they are loaded, because the clock does not
    // exist yet.
    console_log_.Add(is_assembled_ ? system().now_us() : 0, text);
  };
  options.network_filter = [this](int robot, std::unique_ptr<Network> inner) {
    return rewind_.WrapNetwork(robot, std::move(inner));
  };
  if (records()) recorder_.RecordNetworks(&options);
  // Adds the network client of ROS 2 to `options` after the recorder has added itself, because the
  // recorder must see the commands of ROS 2 as input.
  distribution_.ChangeOptions(&options, plan_.say);
  return options;
}

int CommandedRun::Run() {
  if (simulation_.loaded()) distribution_.CheckPlaces();
  console_.Print(DescribeObjects(&simulation_));
  const bool is_refused = flags_.simulation.strict && system().findings().HasError();
  std::string problem;  // why the processes with objects of the run are not ready
  if (simulation_.loaded())
    problem = is_refused ? distribution_.Problem() : distribution_.Connect(&simulation_);
  boots_ = simulation_.loaded() && IsGood(problem) && !is_refused;
  bool good = boots_;
  if (!boots_) ReportNoBoot(problem);
  // Sets `boots_` to true after a Ctrl-C while the run waited for its workers.  Nobody knows
  // whether the robot would have booted, so openr must not print that the robot does not boot.
  if (!boots_ && interrupts_.count() > 0) boots_ = true;
  if (good) {
    good = RunToTheEnd();
  } else {
    facts_.standing.assign(simulation_.robots().size(), StandingMonitor(simulation_.model()));
  }
  // Ends the guards before the report is written, because a crash after that would replace the
  // report.
  guards_.reset();
  good = Report() && good;
  // Waits for the branch that goes on in place of this process, because the shell waits only for
  // this process.
  if (rewind_.has_branched()) return rewind_.WaitForBranch([this] { return interrupts_.count(); });
  return good && !system().findings().HasError() ? kExitGood : kExitWrong;
}

// Records why the run ends before the robot boots.  `problem` says why the processes with objects
// of the run are not ready; "" if that is not the reason.  It is more exact than the text about
// --strict, which refuses a run also because of the finding about a process.
void CommandedRun::ReportNoBoot(const std::string& problem) {
  RunEnd end{EndKind::kNoBoot, "the robot does not boot; the findings say why"};
  if (simulation_.loaded()) {
    end.why = problem.empty() ? "--strict refuses what the findings name; no object was started"
                              : problem;
    if (interrupts_.count() > 0)
      end = {EndKind::kSignal, "Ctrl-C or SIGTERM came while a process was waited for"};
  }
  system().robot_table().NoteRunEnd(end);
}

// Returns the name by which `openr poke` finds this run: the value of --run-name; without it
// "default" for the default stick, or the name of the stick's folder.
std::string CommandedRun::LiveName() const {
  if (!flags_.placement.bus.run.empty()) return flags_.placement.bus.run;
  if (stick_.is_default()) return "default";
  return std::filesystem::absolute(stick_.name()).lexically_normal().filename();
}

// Returns the reason why clients cannot rewind this run; "" if they can.
std::string CommandedRun::ReasonNotRewindable() const {
  if (distribution_.has_processes()) return "its objects are in several processes";
  if (flags_.ros2.is_on) return "it is connected to ROS 2 (--ros2)";
  return "";
}

// Sets up the run so that clients of its server can go back to earlier moments.
void CommandedRun::BeginRewind(LiveServer* live, Runner* runner) {
  RewindParts parts;
  parts.simulation = &simulation_;
  parts.no_rewind_reason = live == nullptr ? "no client can reach it" : ReasonNotRewindable();
  parts.answer = [this](const nlohmann::json& request) {
    return AnswerLive(live_context_, request);
  };
  parts.become_copy = [this, live] {
    is_silent_ = true;
    if (live != nullptr) live->Forget();
  };
  parts.become_view = [this](const SavedStick& changed) {
    if (records()) recorder_.AddStick(EntriesOf(changed));
  };
  parts.after_frame = [this, runner] {
    runner->SampleStanding();
    if (timeline_ != nullptr) timeline_->Rest();
    if (data_log_ != nullptr) data_log_->Sample();
  };
  parts.before_input = [this](int robot, const std::string& line) { events_.Skip(robot, line); };
  parts.become_branch = [this, live](double rate) {
    live->OpenAgain();
    guards_->StartAgain();
    interrupts_.StartAgain();
    clock_.set_rate(rate);
    clock_.GoOn();
    is_silent_ = false;
    return std::filesystem::path(LiveSocketPath(LiveName())).filename().string();
  };
  rewind_.Begin(std::move(parts));
}

EndGuardOptions CommandedRun::GuardOptions() const {
  EndGuardOptions options = GuardsOf(flags_, stick_);
  options.adds_to_crash_logs = distribution_.has_processes();
  return options;
}

void CommandedRun::BeginRecording() {
  if (!records()) return;
  recorder_.Begin(&simulation_, options_, stick_.name(), flags_.placement.is_free);
  plan_.recorder = &recorder_;
}

// Creates the files of --log-data and --timeline.  The run then adds its data to these files after
// each frame.
void CommandedRun::BeginDataLog() {
  if (!flags_.data_log.file.empty()) data_log_ = MakeDataLog(flags_.data_log, &simulation_);
  if (!flags_.timeline_file.empty())
    timeline_ = std::make_unique<Timeline>(flags_.timeline_file, &system());
  if (data_log_ == nullptr && timeline_ == nullptr) return;
  plan_.after_frame = [this, before = plan_.after_frame] {
    if (timeline_ != nullptr) timeline_->Rest();
    if (before) before();
    if (data_log_ != nullptr) data_log_->Sample();
  };
}

// Boots the robots and runs the simulation to its end.  Returns false after printing an error.
bool CommandedRun::RunToTheEnd() {
  BeginRecording();
  distribution_.Begin(&simulation_, &plan_);
  BeginDataLog();
  const std::unique_ptr<LiveServer> live = MakeLiveServer(live_context_, LiveName(), &couplings_);
  plan_.live = live.get();
  if (live != nullptr) {
    plan_.clock = &clock_;
    plan_.rewind = &rewind_;
  }
  const std::unique_ptr<PanelProcess> panel = StartPanel(flags_, live.get(), LiveName());
  RunProgressLine progress(ProgressStream(), 0, plan_.for_us.value_or(0));
  plan_.after_frame = [this, &progress, also = plan_.after_frame] {
    if (also) also();
    progress.Show(system().now_us());
  };
  Runner runner(&simulation_, plan_, &interrupts_);
  BeginRewind(live.get(), &runner);
  const auto learn_facts = [this, &runner] {
    facts_.wall_time_s = runner.wall_time_s();
    facts_.standing = runner.standing();
  };
  const EndingAction ending_action([&](Ending* ending) {
    learn_facts();
    if (data_log_ != nullptr) data_log_->Finish();
    if (timeline_ != nullptr) timeline_->Finish();
    ReportTheEnding(ending, &simulation_, &distribution_, facts_, flags_);
  });
  bool good = runner.Run();
  distribution_.RunIsOver();
  learn_facts();
  good = FinishFiles() && good;
  boots_ = system().booted() || !system().powered_off() || interrupts_.count() >= 2;
  return good;
}

// Finishes the files of --record, --log-data and --timeline.  Returns false after printing an error
// for each file that could not be written.
bool CommandedRun::FinishFiles() {
  bool good = true;
  if (records()) good = IsGood(recorder_.Finish(&system()));
  if (data_log_ != nullptr) good = IsGood(data_log_->Finish()) && good;
  if (timeline_ != nullptr) good = IsGood(timeline_->Finish()) && good;
  return good;
}

// Writes the report of the run, which also describes the worker processes, and ends these
// processes.  Returns false after printing an error.
bool CommandedRun::Report() {
  distribution_.ReportLosses();
  const bool is_stopped = system().end() && system().end()->kind == EndKind::kStrict;
  if (!boots_ && !is_stopped) PrintPlain(stderr, "openr: the robot does not boot\n");
  EndConsoleLine();
  nlohmann::ordered_json report = MakeReport(&simulation_, facts_);
  // Writes the bytes that still wait in the buffers of objects' open files, but only after
  // MakeReport() has computed the state hash, which contains the files of the stick.  A replay
  // computes this hash before these bytes are written, too; otherwise the two hashes would differ.
  for (const auto& object : system().objects()) {
    if (object != nullptr) FlushStreams(object.get());
  }
  report["findings"] = ReportOfFindings(system());
  distribution_.Describe(&report);
  distribution_.EndProcesses();
  fmt::print(stderr, "{}{}", DescribeFindings(&simulation_, HasColours(STDERR_FILENO)),
             TerminalText(Summary(report, system().end())));
  const bool is_written = WriteReport(report, flags_);
  return IsGood(console_.Problem()) && is_written;
}

// Runs robots that have a process each (--jobs).  Returns the exit code.
int RunJobs(const RunFlags& flags) {
  RefuseFlagsBesideJobs(flags);
  RobotJobs jobs(flags);
  const nlohmann::ordered_json report = jobs.Run();
  const auto& findings = report["findings"];
  const bool has_error = std::any_of(findings.begin(), findings.end(), [](const auto& finding) {
    return finding["severity"] == SeverityName(Severity::kError);
  });
  const bool is_good = !has_error && report["ended_by"] != EndName(EndKind::kNoBoot);
  return WriteReport(report, flags) && is_good ? kExitGood : kExitWrong;
}

// Prints a note if the run uses the default stick although the current folder has a stick with the
// name MS, which `openr new` creates.  The user may expect that the run uses the stick MS.
void NoteOwnStick(const SimulationOptions& options) {
  if (options.stick.empty() && HoldsOpenR("MS"))
    PrintPlain(stderr,
               "openr: note: the default stick runs; --stick MS runs the stick of this folder\n");
}

}  // namespace

void AddRunCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command =
      app->add_subcommand("run", "Runs the objects of a stick; Ctrl-C is the pause button");
  auto flags = std::make_shared<RunFlags>();
  DescribeRunFlags(command, flags.get());
  command->callback([command, flags, exit_code] {
    // Chooses full speed for robots with processes of their own, because nobody can watch them on a
    // panel.
    if (flags->jobs > 0 && command->count("--rate") == 0) flags->rate = "max";
    if (!flags->gdb.empty()) StartUnderGdb(flags->gdb, flags->simulation.stick);
    StartWithSanitizerOf(flags->simulation.stick);
    for (const std::string& stick : flags->simulation.more_sticks) StartWithSanitizerOf(stick);
    NoteOwnStick(flags->simulation);
    *exit_code = flags->jobs > 0 ? RunJobs(*flags) : CommandedRun(*flags).Run();
  });
}

}  // namespace openr_host
