// The command openr explore: runs the objects of a stick many times, with many legal orders of
// their messages.
#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/counted.h"
#include "cli/exit_code.h"
#include "cli/growing_file.h"
#include "cli/install_paths.h"
#include "cli/json_text.h"
#include "cli/output_file.h"
#include "cli/progress_line.h"
#include "kit/shell_words.h"
#include "openr/commands/commands.h"
#include "openr/commands/common_flags.h"
#include "openr/commands/show_run.h"
#include "openr/ending/crash_log.h"
#include "openr/ending/ending.h"
#include "openr/ending/watchdog.h"
#include "openr/explore/explorer.h"
#include "openr/explore/failing_run.h"
#include "openr/explore/schedule_file.h"
#include "openr/inspect/recorder.h"
#include "openr/simulation/cost_file.h"
#include "openr/simulation/pacing.h"
#include "openr/simulation/sanitizer_start.h"
#include "runtime/base/duration.h"
#include "runtime/base/wall_clock.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

constexpr uint64_t kRunsMax = 1'000'000'000;

struct ExploreFlags {
  ExploredStick stick;
  ExplorePlan plan;
  std::vector<std::string> vary;
  int faults = 0;
  bool exhaustive = false;
  bool no_reduction = false;
  bool verify = false;
  bool keep_going = false;
  bool guard = false;
  bool no_guard = false;
  std::string replay_file;
  std::string console_file;
  std::string file;
  bool json = false;
  bool panel = false;
  ShowOptions show;
  std::string record_file;
};

// Checks `name`, a value of --property.  A value with a space is itself the text of a property.  A
// value without a space but with a dot or a slash is a file, because the names of built-in
// properties have no dot and no slash.  Throws CLI::ParseError if the value is a file that cannot
// be read; else returns "".
std::string CheckProperty(const std::string& name) {
  const bool is_line = name.find(' ') != std::string::npos;
  if (is_line || name.find_first_of("./") == std::string::npos) return "";
  RefuseInput("--property", name,
              WhyNotReadable(name, "file of properties (docs/exploring.md)", ".txt"));
  return "";
}

void DescribeWhat(CLI::App* command, ExploreFlags* flags) {
  SimulationOptions& simulation = flags->stick.simulation;
  AddCommonFlags(command, &simulation);
  command->get_option("--seed")->description("The first seed");
  AddDurationFlag(command, "--for", &flags->stick.for_us, "Virtual time of each run");
  command->add_option("--body", simulation.body, "ode or ideal")
      ->check(CLI::IsMember({"ode", "ideal"}))
      ->capture_default_str();
  AddRobotsFlags(command, &simulation);
  AddBatteryFlag(command, &simulation);
  AddImagesFlag(command, &simulation);
  command->add_flag("--strict", simulation.strict, "Enforce the limits of the robot");
  AddCostFlag(command, &simulation);
  command
      ->add_option("--property", flags->stick.properties,
                   "What must hold: 'default', a built-in name or a file of properties; may be "
                   "repeated")
      ->take_all()
      ->check(CLI::Validator(&CheckProperty, ""));
}

void DescribeHow(CLI::App* command, ExploreFlags* flags) {
  command->add_option("--runs", flags->plan.runs, "Number of seeds; of --exhaustive the most runs")
      ->check(CLI::Range(uint64_t{1}, kRunsMax))
      ->capture_default_str();
  command
      ->add_option("--vary", flags->vary,
                   "What seeds may change: starts,ties,delays,network,costs,frames (all)")
      ->delimiter(',')
      ->check(CLI::IsMember({"starts", "ties", "delays", "network", "costs", "frames"}));
  CLI::Option* const faults =
      command
          ->add_option("--faults", flags->faults,
                       "Number of faults of joints and sensors that each seed gives the robots")
          ->check(CLI::Range(0, 1000));
  CLI::Option* const exhaustive = command->add_flag("--exhaustive", flags->exhaustive,
                                                    "All orders of starts and ties, depth first");
  exhaustive->excludes(command->get_option("--vary"))->excludes(faults);
  command
      ->add_flag("--no-reduction", flags->no_reduction,
                 "With --exhaustive: also orders that nobody could tell from others")
      ->needs(exhaustive);
  command
      ->add_flag("--verify", flags->verify,
                 "Each seed twice, in two processes; count differing hashes")
      ->excludes(exhaustive);
  command->add_flag("--keep-going", flags->keep_going, "Do not stop at the first failure");
  CLI::Option* const guard = command->add_flag(
      "--guard", flags->guard, "Watch received data in --verify and --exhaustive too");
  command->add_flag("--no-guard", flags->no_guard, "Do not watch received data")->excludes(guard);
  command->add_option("--jobs", flags->plan.jobs, "Worker processes (default: one per core)")
      ->check(CLI::Range(1, 256));
  AddDurationFlag(command, "--handler-limit", &flags->plan.limits.handler_us,
                  "Processor time of one handler");
  CLI::Option* const replay =
      command->add_option("--replay", flags->replay_file, "Run a failure again that -o wrote")
          ->check(IsReadable("--replay", "failing order that openr explore -o wrote", ".json"));
  for (const char* other : {"--runs", "--vary", "--exhaustive", "--verify", "--keep-going",
                            "--guard", "--seed", "--for", "--property", "--faults"}) {
    replay->excludes(command->get_option(other));
  }
  CLI::Option* const panel =
      command
          ->add_flag("--panel", flags->panel,
                     "With --replay: show the failing run on the web panel, until Ctrl-C")
          ->needs(replay);
  AddShowFlags(command, panel, &flags->show);
  command->get_option("--rate")->needs(panel);
  command->add_option("--console", flags->console_file, "File for what objects print")
      ->check(IsWritable());
  command->add_option("-o,--output", flags->file, "File for the failing order, if there is one")
      ->check(IsWritable());
  command
      ->add_option("--record", flags->record_file,
                   "File for the recording of the failing run, if there is one, for openr replay "
                   "--step")
      ->check(IsWritable());
  command->add_flag("--json", flags->json, "Print the result, and nothing else, as JSON");
}

ScheduleChoices ScheduleChoicesOf(const std::vector<std::string>& names) {
  if (names.empty()) return {};
  const auto has = [&names](const char* name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  ScheduleChoices vary;
  vary.starts = has("starts");
  vary.ties = has("ties");
  vary.delays = has("delays");
  vary.network = has("network");
  vary.costs = has("costs");
  vary.frames = has("frames");
  return vary;
}

// The file to which the objects of all runs print.  All processes of the exploration write to this
// file.  Without a file, the output is discarded.
class SharedConsole {
 public:
  // Opens `file` for the output of objects; "" means that the output is discarded.  Throws
  // std::runtime_error when the file cannot be written.
  explicit SharedConsole(const std::string& file) : file_(file) {
    if (file.empty()) return;
    std::string problem;
    descriptor_ = OpenGrowingFile(file, &problem);
    if (descriptor_ < 0) throw std::runtime_error(problem);
    error_ = static_cast<int*>(
        mmap(nullptr, sizeof(int), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
    if (error_ == MAP_FAILED) throw std::bad_alloc();
    fcntl(descriptor_, F_SETFL, O_APPEND);
  }
  ~SharedConsole() {
    if (descriptor_ < 0) return;
    munmap(error_, sizeof(int));
    close(descriptor_);
  }
  SharedConsole(const SharedConsole&) = delete;
  SharedConsole& operator=(const SharedConsole&) = delete;

  void Print(std::string_view text) const {
    if (descriptor_ < 0 || *error_ != 0) return;
    *error_ = WriteAll(descriptor_, text);
  }

  // Returns "FILE: cannot be written: reason" if a write has failed in this process or in a child
  // process; else "".  All these processes share `error_`.
  std::string Problem() const {
    return descriptor_ < 0 || *error_ == 0 ? "" : WhyNotWritten(file_, *error_);
  }

 private:
  const std::string file_;
  int descriptor_ = -1;
  int* error_ = nullptr;  // errno of the first failed write; shared by all processes
};

// Returns `exit_code`; if the output of the objects could not be written to its file, prints an
// error and returns 1 instead.
int WithConsole(int exit_code, const SharedConsole& console) {
  const std::string problem = console.Problem();
  if (problem.empty()) return exit_code;
  fmt::print(stderr, "openr explore: {}\n", problem);
  return kExitWrong;
}

// Sets the members of `plan` that depend on `stick`: the length of the runs, the properties and the
// function that prepares a run.  The objects of the runs print to `console`, which must outlive
// `plan`.
void SetStick(const ExploredStick& stick, const SharedConsole& console, ExplorePlan* plan) {
  // Loads the cost file here only to report its errors once.  Later each process loads the file
  // again.
  LoadCostFile(stick.simulation.cost_file);
  plan->run.for_us = stick.for_us;
  plan->run.properties.names = stick.properties;
  plan->run.properties.Make();
  SimulationOptions simulation = stick.simulation;
  simulation.console = [&console](std::string_view text) { console.Print(text); };
  plan->prepare_run = [simulation] { return PrepareSimulation(simulation); };
}

// Returns a line about the runs that ended early and the reasons, such as "ended before their time:
// 2 by battery\n"; "" if no run ended early.
std::string EndsBeforeTime(const Json& result) {
  std::string text;
  for (const auto& [reason, runs] : result.at("ended_by").items()) {
    if (reason == EndName(EndKind::kTime)) continue;
    text += fmt::format("{} {} by {}", text.empty() ? "ended before their time:" : ",",
                        runs.get<uint64_t>(), reason);
  }
  return text.empty() ? "" : text + "\n";
}

std::string Summary(const Json& result, const ExploreFlags& flags) {
  const uint64_t runs = result["runs"].get<uint64_t>();
  std::string text =
      fmt::format("{}{} of {}, {:.1f} a second: ", Counted(runs, flags.verify ? "seed" : "run"),
                  flags.verify ? " twice" : "", FormatDuration(flags.stick.for_us),
                  result["runs_per_s"].get<double>());
  if (flags.verify) text += Counted(result["differences"].get<uint64_t>(), "difference") + ", ";
  if (flags.exhaustive) {
    text += fmt::format("{}, {} cut as equal to others, {:.4g} % covered",
                        Counted(result["orders"].get<uint64_t>(), "order"),
                        Counted(result["cut"].get<uint64_t>(), "run"),
                        result["covered"].get<double>() * 100);
    text += result["complete"]
                ? ", complete; "
                : fmt::format("; stopped {}; ", result["stopped"].get<std::string>());
  }
  const uint64_t broken = result["broken"].get<uint64_t>();
  text += broken == 0 ? "no property broken\n" : fmt::format("{} broke a property\n", broken);
  text += EndsBeforeTime(result);
  if (result.contains("failure")) text += DescribeFailure(result["failure"]);
  if (const uint64_t dependent = result.value("address_dependent", uint64_t{0}); dependent > 0) {
    text += fmt::format(
        "finding: with {} of these seeds the program does something else when its memory lies at "
        "other addresses, as on the robot after each start; the first is seed {}\n",
        dependent, result["address_dependent_seeds"][0].get<uint64_t>());
  }
  if (const uint64_t count = result.value("not_compared", uint64_t{0}); count > 0) {
    text += fmt::format(
        "{} of these seeds were not compared, because a run did not end within {} s of real time; "
        "the first is seed {}\n",
        count, ForkLimits().wall_s, result["not_compared_seeds"][0].get<uint64_t>());
  }
  return text;
}

// Writes the run in `result` that broke a property to the file that the flag -o names.  `openr
// explore --replay` can repeat the run from this file.  Does nothing without -o.  Returns false
// after printing an error.
bool WriteFailure(const Json& result, const ExploreFlags& flags) {
  if (flags.file.empty()) return true;
  if (!result.contains("failure")) {
    // Removes an old schedule file, which would look like the result of this exploration.
    RemoveFile(flags.file);
    return true;
  }
  const Json schedule = ScheduleToJson(flags.stick, result["failure"]);
  const std::string problem = WriteFile(flags.file, JsonText(schedule, 2) + "\n");
  fmt::print(stderr, "openr explore: {}\n",
             problem.empty() ? fmt::format("wrote {}; again: {} explore --replay {}", flags.file,
                                           ShellWord(ProgramCall()), ShellWord(flags.file))
                             : problem);
  return problem.empty();
}

void Tell(const Json& result, const std::string& text, bool as_json) {
  if (as_json) fmt::print("{}\n", JsonText(result));
  fmt::print(as_json ? stderr : stdout, "{}", text);
}

// Shows the failing run of a schedule file on the panel.  `answer` is the answer of
// ReplayDeviations().  Returns the exit code.
int ShowFailure(const ExploreFlags& flags, const ExploredStick& stick, uint64_t seed,
                const Json& deviations, const Json& answer) {
  ShowOptions show = flags.show;
  show.name = std::filesystem::path(flags.replay_file).filename();
  const auto make = [&](const std::function<void(std::string_view)>& console) {
    SimulationOptions simulation = stick.simulation;
    simulation.console = console;
    const auto prepare = [simulation] { return PrepareSimulation(simulation); };
    return std::make_unique<FailingRun>(prepare, deviations, seed, stick.for_us, answer);
  };
  return ShowRun(make, show);
}

// Runs the failing run once more and writes its recording.  `answer` is the answer of
// ReplayDeviations().  Must be called last, because this process ends if an object crashes in the
// run.  The recording then ends at the crash.  Returns false after printing an error.
bool RecordFailure(const ExploreFlags& flags, const ExploredStick& stick, uint64_t seed,
                   const Json& deviations, const Json& answer) {
  const EndingAnswer ending_answer(-1);
  const CrashLog crash_log({});
  const Watchdog watchdog(flags.plan.limits.handler_us);
  fmt::print(stderr, "openr explore: writing {}; openr replay {} --step goes through it\n",
             flags.record_file, ShellWord(flags.record_file));
  SimulationOptions simulation = stick.simulation;
  simulation.console = [](std::string_view) {};
  simulation.host_network = false;
  Recorder recorder(flags.record_file, true);
  recorder.Listen(&simulation);
  const Json schedule = {{"seed", seed},
                         {"for_us", stick.for_us},
                         {"guard", simulation.guard_regions},
                         {"deviations", deviations}};
  const auto prepare = [&] {
    PreparedRun prepared = PrepareSimulation(simulation);
    if (prepared.problem.empty()) {
      recorder.Begin(prepared.simulation, simulation, StickFolder(simulation.stick), false,
                     JsonText(schedule));
    }
    return prepared;
  };
  FailingRun run(prepare, deviations, seed, stick.for_us, answer);
  run.RunUntil(run.length_us());
  System& system = run.simulation().system();
  system.robot_table().NoteRunEnd({EndKind::kTime, run.WhyOver()});
  const std::string problem = recorder.Finish(&system);
  if (!problem.empty()) fmt::print(stderr, "openr explore: {}\n", problem);
  return problem.empty();
}

void StartWithSanitizersOf(const SimulationOptions& simulation) {
  StartWithSanitizerOf(simulation.stick);
  for (const std::string& stick : simulation.more_sticks) StartWithSanitizerOf(stick);
}

int Replay(ExploreFlags flags) {
  Json deviations;
  const ScheduleFile schedule = ReadScheduleFile(flags.replay_file, &deviations);
  ExploredStick stick = schedule.stick;
  if (!flags.stick.simulation.stick.empty()) stick.simulation.stick = flags.stick.simulation.stick;
  StartWithSanitizersOf(stick.simulation);
  const SharedConsole console(flags.console_file);
  SetStick(stick, console, &flags.plan);
  const Json answer = ReplayDeviations(flags.plan, deviations, schedule.seed);
  const bool broken = !answer["broken"].is_null();
  std::string text;
  if (broken) {
    Json failure = {{"seed", schedule.seed}};
    failure.update(answer["broken"]);
    failure["deviations"] = deviations;
    failure["deviations_found"] = deviations.size();
    failure["shorten_runs"] = 0;
    failure["waits"] = answer.value("waits", Json::array());
    failure["tail"] = answer.value("tail", Json::array());
    text = DescribeFailure(failure);
  }
  const bool same = broken && answer["broken"]["property"] == schedule.property &&
                    answer["broken"]["text"] == schedule.text;
  if (same) {
    text += "the same as in the file\n";
  } else {
    text += fmt::format("{}the file says: {}: {}\n", broken ? "" : "no property is broken now; ",
                        schedule.property, schedule.text);
  }
  const size_t applied = answer["deviations"].size();
  if (applied < deviations.size()) {
    text += fmt::format("{} of {} did not come up\n", deviations.size() - applied,
                        Counted(deviations.size(), "deviation"));
  }
  Json result = answer;
  result["same"] = same;
  Tell(result, text, flags.json);
  if (flags.panel) return ShowFailure(flags, stick, schedule.seed, deviations, answer);
  bool good = !broken;
  if (broken && !flags.record_file.empty())
    good = RecordFailure(flags, stick, schedule.seed, deviations, answer) && good;
  return WithConsole(good ? kExitGood : kExitWrong, console);
}

int Explore(ExploreFlags flags) {
  if (!flags.replay_file.empty()) return Replay(std::move(flags));
  CheckRobots(flags.stick.simulation);
  const bool has_cost = LoadCostFile(flags.stick.simulation.cost_file).has_value();
  if (flags.exhaustive && has_cost) {
    throw CLI::ValidationError("--exhaustive", "does not go with --cost");
  }
  flags.stick.simulation.guard_regions =
      flags.guard || !(flags.no_guard || flags.verify || flags.exhaustive);
  const SharedConsole console(flags.console_file);
  SetStick(flags.stick, console, &flags.plan);
  ExplorePlan& plan = flags.plan;
  plan.first_seed = flags.stick.simulation.seed;
  plan.run.vary = ScheduleChoicesOf(flags.vary);
  plan.run.vary.faults = flags.faults;
  plan.stop_at_first = !flags.keep_going;
  plan.reduce = !flags.no_reduction;
  std::optional<ProgressLine> line(std::in_place, flags.json ? -1 : STDERR_FILENO, plan.runs,
                                   flags.exhaustive ? "runs at most" : "seeds");
  plan.progress = [&line](uint64_t done) { line->Show(done); };
  const int64_t begin_ns = WallClockNs();
  Json result = flags.exhaustive ? SearchOrders(plan)
                : flags.verify   ? VerifySeeds(plan)
                                 : ExploreSeeds(plan);
  line.reset();
  const double wall_time_s = static_cast<double>(WallClockNs() - begin_ns) / 1e9;
  result["for_s"] = static_cast<double>(flags.stick.for_us) / 1e6;
  result["first_seed"] = plan.first_seed;
  result["jobs"] = plan.jobs;
  result["wall_time_s"] = wall_time_s;
  result["runs_per_s"] = result["runs"].get<double>() / wall_time_s;
  Tell(result, Summary(result, flags), flags.json);
  const bool written = WriteFailure(result, flags);
  const bool good = result["broken"] == 0 && result.value("differences", 0) == 0 &&
                    result.value("not_compared", 0) == 0;
  if (result.contains("failure") && !flags.record_file.empty()) {
    const Json& failure = result["failure"];
    const uint64_t seed = failure["seed"];
    const Json answer = ReplayDeviations(plan, failure["deviations"], seed);
    RecordFailure(flags, flags.stick, seed, failure["deviations"], answer);
  }
  return WithConsole(good && written ? kExitGood : kExitWrong, console);
}

std::string ListOfProperties() {
  std::string text = "Properties (*: default; no-crash and handlers-return always):\n";
  for (const PropertyEntry& entry : PropertyTable()) {
    text +=
        fmt::format("  {} {:<21} {}\n", entry.by_default ? '*' : ' ', entry.name, entry.meaning);
  }
  return text;
}

}  // namespace

void AddExploreCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command = app->add_subcommand(
      "explore", "Runs a stick under many legal orders of its messages and checks properties");
  auto flags = std::make_shared<ExploreFlags>();
  flags->plan.jobs = static_cast<int>(std::max(1L, sysconf(_SC_NPROCESSORS_ONLN)));
  flags->stick.simulation.body = "ideal";
  DescribeWhat(command, flags.get());
  DescribeHow(command, flags.get());
  command->footer(ListOfProperties());
  command->callback([flags, exit_code] {
    StartWithSanitizersOf(flags->stick.simulation);
    *exit_code = Explore(*flags);
  });
}

}  // namespace openr_host
