#include "openr/commands/robot_jobs.h"

#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <exception>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "cli/colour.h"
#include "cli/counted.h"
#include "cli/exit_code.h"
#include "cli/json_text.h"
#include "cli/output_file.h"
#include "cli/print_plain.h"
#include "cli/process_copy.h"
#include "cli/progress_line.h"
#include "openr/run/report.h"
#include "openr/run/runner.h"
#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "runtime/base/terminal_text.h"
#include "runtime/base/wall_clock.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

// Longest wait for data from the processes of the robots, so that Ctrl-C is noticed soon.
constexpr int kInterruptMs = 200;
// Largest number of findings that are printed; the report has all findings.
constexpr size_t kFindingsPrinted = 20;

struct RunningCopy {
  int robot = 0;
  ProcessCopy process;
  std::string said;  // the part of the report that the robot's process has sent so far
};

// Reads the data that `copy`, the process of one robot, has sent.  Does not wait for more data.
// Returns false when the copy has ended, so that no more data can come.
bool ReadSome(RunningCopy* copy) {
  char buffer[65536];
  const ssize_t size = read(copy->process.answers, buffer, sizeof buffer);
  if (size < 0 && errno == EINTR) return true;
  if (size <= 0) return false;
  copy->said.append(buffer, static_cast<size_t>(size));
  return true;
}

// Returns a report about a robot whose process has ended without sending its report.
Json LostReport(const std::string& model, int status) {
  const std::string why = WIFSIGNALED(status) ? fmt::format("signal {} ({})", WTERMSIG(status),
                                                            strsignal(WTERMSIG(status)))
                                              : fmt::format("status {}", WEXITSTATUS(status));
  const Json finding = {{"severity", "error"},
                        {"robot", 0},
                        {"object", ""},
                        {"message", 0},
                        {"time_s", 0.0},
                        {"count", 1},
                        {"text", "the process of this robot ended with " + why}};
  return {{"virtual_time_s", 0.0},
          {"ended_by", EndName(EndKind::kLostProcess)},
          {"ended_why", finding["text"]},
          {"frames", 0},
          {"messages", 0},
          {"state_hash", ""},
          {"trace_hash", ""},
          {"robots", Json::array({{{"model", model}, {"standing", false}}})},
          {"objects", Json::array()},
          {"findings", Json::array({finding})}};
}

RunPlan PlanOfJobs(const RunFlags& flags) {
  RunPlan plan = PlanOf(flags);
  plan.has_ports = false;
  return plan;
}

// A finding, and all robots that have it.
struct SharedFinding {
  std::string severity, text;  // `text` begins with the name of the object
  std::vector<int> robots;
};

// Prints the first kFindingsPrinted findings, errors first.  Prints equal findings of several
// robots as one line, because they would otherwise hide the finding of a single robot.
void PrintFindings(const Json& findings) {
  std::vector<SharedFinding> shared;
  // Index of each finding in the list `shared`.  The key is the severity and the text of a finding,
  // so equal findings of several robots have the same index.
  std::map<std::pair<std::string, std::string>, size_t> places;
  for (const Json& finding : findings) {
    const std::string severity = finding["severity"].get<std::string>();
    const std::string object = finding["object"].get<std::string>();
    const std::string text =
        (object.empty() ? "" : object + ": ") + finding["text"].get<std::string>();
    const auto [place, is_new] = places.try_emplace({severity, text}, shared.size());
    if (is_new) shared.push_back({severity, text, {}});
    shared[place->second].robots.push_back(finding["robot"].get<int>());
  }
  std::stable_partition(shared.begin(), shared.end(), [](const SharedFinding& finding) {
    return finding.severity == SeverityName(Severity::kError);
  });
  for (size_t i = 0; i < std::min(shared.size(), kFindingsPrinted); ++i) {
    const SharedFinding& finding = shared[i];
    const std::string others =
        finding.robots.size() == 1
            ? ""
            : fmt::format(" and {}", Counted(finding.robots.size() - 1, "other robot"));
    PrintPlain(stderr, "{}: robot {}{}: {}\n", finding.severity, finding.robots.front(), others,
               finding.text);
  }
  if (shared.size() > kFindingsPrinted) {
    PrintPlain(stderr, "and {}, which are in the report\n",
               Counted(shared.size() - kFindingsPrinted, "more finding"));
  }
}

}  // namespace

void RefuseFlagsBesideJobs(const RunFlags& flags) {
  const auto refuse = [](bool is_given, const char* flag, const char* why) {
    if (is_given) throw CLI::ValidationError(flag, fmt::format("does not go with --jobs: {}", why));
  };
  constexpr char kOneProcess[] =
      "its robots have a process each, and no other processes; leave out one of the two";
  constexpr char kNobody[] = "nobody can reach its robots while they run; leave out one of the two";
  constexpr char kAllAlike[] =
      "it is for one robot of several, and those of --jobs are all alike; leave out one of the two";
  refuse(flags.rate != "max", "--rate", "it runs at full speed; leave out --rate");
  refuse(flags.simulation.together, "--together",
         "robots of one world are in one process; leave out one of the two");
  refuse(!flags.simulation.more_sticks.empty(), "--stick",
         "its robots have one stick; give --stick once");
  refuse(!flags.placement.places.empty(), "--place", kOneProcess);
  refuse(!flags.placement.file.empty(), "--placement", kOneProcess);
  refuse(!flags.placement.isolated.empty(), "--isolate", kOneProcess);
  refuse(flags.placement.is_monitored, "--monitor", kNobody);
  refuse(flags.ros2.is_on, "--ros2", kNobody);
  refuse(flags.panel, "--panel", kNobody);
  refuse(flags.listen.is_on(), "--listen", kNobody);
  refuse(flags.simulation.rc_port >= 0, "--rc-port", kNobody);
  refuse(!flags.simulation.addresses.empty(), "--ip", kNobody);
  refuse(!flags.stdin_file.empty(), "--stdin", kNobody);
  refuse(!flags.events_file.empty(), "--events", kAllAlike);
  refuse(!flags.snapshots.empty(), "--snapshot", kAllAlike);
  refuse(!flags.simulation.speaker.empty(), "--speaker", kAllAlike);
  refuse(!flags.simulation.microphone.empty(), "--mic", kAllAlike);
  refuse(IsImageFolder(flags.simulation.images), "--images", kAllAlike);
  refuse(!flags.record_file.empty(), "--record",
         "a recording is of one process; record a run of one robot");
  refuse(!flags.data_log.file.empty(), "--log-data",
         "a log of data is of one process; log a run of one robot");
  refuse(!flags.timeline_file.empty(), "--timeline",
         "a timeline is of one process; give it a run of one robot");
  RefuseIdleFlags(flags.placement, false, false);
}

RobotJobs::RobotJobs(const RunFlags& flags)
    : flags_(flags),
      plan_(PlanOfJobs(flags)),
      stick_(flags.simulation.stick, false),
      console_(flags.console_file),
      interrupts_(plan_.for_us || plan_.until_idle ? HangUp::kIgnored : HangUp::kCounts),
      guards_(std::in_place, GuardsOf(flags_, stick_)),
      simulation_(Options()),
      reports_(static_cast<size_t>(flags.simulation.robots)) {
  ASSERT(flags.jobs > 0);
  guards_.reset();
  CrashLog::RemoveOldRecords(stick_.crash_log());
}

SimulationOptions RobotJobs::Options() {
  SimulationOptions options = flags_.simulation;
  options.stick = stick_.folder();
  options.robots = 1;
  // Does not let the robots write to the stick, because all robots share it.
  options.writable_stick = false;
  // Opens no ports, because all robots would open the same ports.
  options.host_network = false;
  options.log_level = flags_.log == "error" ? 1 : flags_.log == "warning" ? 2 : 3;
  options.console = [this](std::string_view text) { Print(text); };
  return options;
}

// Prints the whole lines of `text`, each with the number of its robot in front, because the lines
// of several robots mix on the console.
void RobotJobs::Print(std::string_view text) {
  if (robot_ < 0) return console_.Print(text);
  line_ += text;
  for (size_t end = line_.find('\n'); end != std::string::npos; end = line_.find('\n')) {
    console_.Print(fmt::format("robot {}: {}", robot_, line_.substr(0, end + 1)));
    line_.erase(0, end + 1);
  }
}

// Runs the robot number `robot` to the end of its run, and writes its report to the descriptor
// `answer`.
void RobotJobs::RunInCopy(int robot, int answer) {
  robot_ = robot;
  EndGuardOptions options = GuardsOf(flags_, stick_);
  // Lets the original process write the report, which it combines from the reports of its copies.
  options.answer = -1;
  options.answer_file = "";
  options.adds_to_crash_logs = true;
  const EndGuards guards(options);
  simulation_.robots()[0]->parts().UseNoiseOf(robot);
  Runner runner(&simulation_, plan_, &interrupts_);
  const auto report = [&] {
    simulation_.CloseFiles();
    const RunFacts facts = {runner.wall_time_s(), flags_.simulation.seed, runner.standing()};
    return MakeReport(&simulation_, facts);
  };
  const EndingAction action([&](Ending* ending) {
    NoteTheEnding(*ending, &simulation_);
    // Ends a line that the robot has begun to print, because Print() prints only whole lines.
    if (!line_.empty()) Print("\n");
    WriteAll(answer, JsonText(report()));
    ending->answered = true;
  });
  runner.Run();
  if (!line_.empty()) Print("\n");
  WriteAll(answer, JsonText(report()));
}

// Stores `said`, the report that the process of `robot` has sent.  If the report is not complete,
// stores a report about the end of the process instead; `status` is its exit status.
void RobotJobs::StoreReport(int robot, const std::string& said, int status) {
  Json report = TryParseJson<Json>(said);
  if (!report.is_object() || !report.contains("robots"))
    report = LostReport(simulation_.model().name, status);
  reports_[static_cast<size_t>(robot)] = std::move(report);
}

// Starts the process of `robot`, which is a copy of this process.  Blocks SIGINT and SIGTERM until
// the copy has been made, because only the original process may count a Ctrl-C; it passes the
// Ctrl-C on to its copies.
ProcessCopy RobotJobs::Start(int robot) {
  sigset_t signals, before;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  sigprocmask(SIG_BLOCK, &signals, &before);
  // Makes a copy of this process that is killed when this process ends, because signals of the
  // terminal do not reach the process group of the copy.
  const ProcessCopy copy = StartCopy(Orphan::kIsKilled, [&](int answer) {
    // Gives the robot's process a process group of its own.  So Ctrl-C on the terminal reaches only
    // the process that the user has started.
    setpgid(0, 0);
    interrupts_.StartAgain();
    sigprocmask(SIG_SETMASK, &before, nullptr);
    try {
      RunInCopy(robot, answer);
    } catch (const std::exception& error) {
      PrintPlain(stderr, "openr: robot {}: {}\n", robot, error.what());
      _exit(kExitWrong);
    }
  });
  sigprocmask(SIG_SETMASK, &before, nullptr);
  return copy;
}

void RobotJobs::RunAll() {
  // Shows progress only if the robots print to a file, because their lines on the terminal would
  // mix with the progress line.
  const int progress_stream = flags_.console_file.empty() || flags_.json ? -1 : STDERR_FILENO;
  ProgressLine progress(progress_stream, reports_.size(), "robots");
  std::vector<RunningCopy> running;
  int next = 0, passed_on = 0;
  for (;;) {
    for (; passed_on < interrupts_.count(); ++passed_on) {
      for (const RunningCopy& copy : running) kill(copy.process.pid, SIGINT);
    }
    const bool goes_on = interrupts_.count() == 0 && next < flags_.simulation.robots;
    if (goes_on && static_cast<int>(running.size()) < flags_.jobs) {
      const int robot = next++;
      running.push_back({robot, Start(robot), ""});
      continue;
    }
    if (running.empty()) return;
    std::vector<pollfd> wanted;
    for (const RunningCopy& copy : running) wanted.push_back({copy.process.answers, POLLIN, 0});
    // Looks for a Ctrl-C again after each wait, because poll() also ends when a signal comes.
    if (poll(wanted.data(), wanted.size(), kInterruptMs) <= 0) continue;
    for (size_t i = running.size(); i-- > 0;) {  // goes backwards, because the loop erases elements
      if (wanted[i].revents == 0 || ReadSome(&running[i])) continue;
      close(running[i].process.answers);
      StoreReport(running[i].robot, running[i].said, WaitForEnd(running[i].process.pid));
      running.erase(running.begin() + static_cast<ptrdiff_t>(i));
    }
    progress.Show(static_cast<uint64_t>(next) - running.size());
  }
}

// Returns one report that stands for all robots when they do not boot, because the report would be
// the same for each of them.
Json RobotJobs::ReportOfNoBoot() {
  simulation_.system().robot_table().NoteRunEnd(
      {EndKind::kNoBoot, simulation_.loaded()
                             ? "--strict refuses what the findings name; no object was started"
                             : "the robots do not boot; the findings say why"});
  RunFacts facts;
  facts.seed = flags_.simulation.seed;
  facts.standing.assign(1, StandingMonitor(simulation_.model()));
  return MakeReport(&simulation_, facts);
}

// Combines the reports of all robots into one report.
Json RobotJobs::Merge(double wall_time_s) {
  Json merged = {{"virtual_time_s", 0.0}};
  Json robots = Json::array(), objects = Json::array(), findings = Json::array();
  Hasher state, trace;
  uint64_t messages = 0;
  const Json* last = nullptr;  // the report of the robot that ended last
  for (size_t i = 0; i < reports_.size(); ++i) {
    // Leaves out a robot without a report: Ctrl-C came before this robot was started.
    if (reports_[i].is_null()) continue;
    const Json& report = reports_[i];
    if (last == nullptr || report["virtual_time_s"] >= (*last)["virtual_time_s"]) last = &report;
    Json robot = report["robots"][0];
    robot["number"] = i;
    robot["ended_by"] = report["ended_by"];
    robot["rc_port"] = 0;  // 0, because only the robot's own network has this port
    for (const char* const key : {"messages", "state_hash", "trace_hash"}) robot[key] = report[key];
    state.AddText(report["state_hash"].get<std::string>());
    trace.AddText(report["trace_hash"].get<std::string>());
    messages += report["messages"].get<uint64_t>();
    robots.push_back(std::move(robot));
    for (Json object : report["objects"]) {
      object["robot"] = i;
      objects.push_back(std::move(object));
    }
    for (Json finding : report["findings"]) {
      finding["robot"] = i;
      findings.push_back(std::move(finding));
    }
  }
  const double virtual_time_s = last == nullptr ? 0.0 : (*last)["virtual_time_s"].get<double>();
  merged["virtual_time_s"] = virtual_time_s;
  merged["wall_time_s"] = wall_time_s;
  merged["x_real_time"] = wall_time_s > 0 ? virtual_time_s / wall_time_s : 0.0;
  merged["ended_by"] = last == nullptr ? Json(EndName(EndKind::kSignal)) : (*last)["ended_by"];
  merged["ended_why"] = last == nullptr ? Json("Ctrl-C or SIGTERM came") : (*last)["ended_why"];
  merged["frames"] = last == nullptr ? Json(0) : (*last)["frames"];
  merged["messages"] = messages;
  merged["seed"] = flags_.simulation.seed;
  merged["state_hash"] = fmt::format("{:016x}", state.Digest());
  merged["trace_hash"] = fmt::format("{:016x}", trace.Digest());
  merged["rc_port"] = 0;
  merged["jobs"] = flags_.jobs;
  merged["robots"] = std::move(robots);
  merged["objects"] = std::move(objects);
  merged["findings"] = std::move(findings);
  return merged;
}

Json RobotJobs::Run() {
  console_.Print(DescribeObjects(&simulation_));
  const bool is_refused = flags_.simulation.strict && simulation_.system().findings().HasError();
  const int64_t begin_ns = WallClockNs();
  if (!simulation_.loaded() || is_refused) {
    Json report = ReportOfNoBoot();
    fmt::print(stderr, "openr: the robots do not boot\n{}{}\n",
               DescribeFindings(&simulation_, HasColours(STDERR_FILENO)),
               TerminalText(DescribeEnd(*simulation_.system().end())));
    return report;
  }
  RunAll();
  const double wall_time_s = static_cast<double>(WallClockNs() - begin_ns) / 1e9;
  Json report = Merge(wall_time_s);
  EndConsoleLine();
  PrintFindings(report["findings"]);
  const size_t count = report["robots"].size();
  const auto standing = std::count_if(report["robots"].begin(), report["robots"].end(),
                                      [](const Json& robot) { return robot["standing"] == true; });
  if (count < reports_.size()) {
    PrintPlain(stderr, "openr: {} not started, because Ctrl-C or SIGTERM came\n",
               Counted(reports_.size() - count, "robot"));
  }
  PrintPlain(stderr, "{}, {} standing, in {:.3f} s: {:.3f} s of virtual time each; state {}\n",
             Counted(count, "robot"), standing, wall_time_s, report["virtual_time_s"].get<double>(),
             report["state_hash"].get<std::string>());
  PrintPlain(stderr, "ended by {}: {}\n", report["ended_by"].get<std::string>(),
             report["ended_why"].get<std::string>());
  return report;
}

}  // namespace openr_host
