#include "openr/commands/run_flags.h"

#include <fmt/format.h>
#include <unistd.h>

#include <charconv>
#include <cstdio>
#include <filesystem>
#include <map>
#include <system_error>
#include <utility>

#include "cli/counted.h"
#include "cli/output_file.h"
#include "cli/print_plain.h"
#include "cli/progress_line.h"
#include "cli/standard_streams.h"
#include "openr/commands/common_flags.h"
#include "openr/commands/listen_flags.h"
#include "openr/panel/panel_process.h"
#include "openr/simulation/network_setup.h"
#include "openr/timeline/timeline.h"
#include "runtime/base/duration.h"

namespace openr_host {
namespace {

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
  AddRobotsFlags(command, &flags->simulation);
  command
      ->add_option("--jobs", flags->jobs,
                   "Run each robot in a process of its own, so many at a time; without it all run "
                   "in this process, on one clock")
      ->check(CLI::Range(1, 256));
  command
      ->add_option("--body", flags->simulation.body, "ode: physics; ideal: joints follow exactly")
      ->check(CLI::IsMember({"ode", "ideal"}))
      ->capture_default_str();
  AddBatteryFlag(command, &flags->simulation);
  command->add_option(
      "--gdb", flags->gdb,
      "Start gdb on the run, with breakpoints in the handlers of this object (in upper "
      "or lower case)");
  command->add_flag("--leaks", flags->simulation.find_leaks,
                    "Name blocks and regions of objects that nothing points to at the end");
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
  AddImagesFlag(command, &flags->simulation);
  AddDurationFlag(command, "--handler-limit", &flags->handler_limit_us,
                  "End the run when a handler uses more processor time; 0s: never");
  AddPlacementFlags(command, &flags->placement);
  AddRos2Flags(command, &flags->ros2);
}

std::string PortNumberProblem(const std::string& text) {
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
  AddDataLogFlags(command, &flags->data_log, &flags->timeline_file);
  command->add_option("--log", flags->log, "Lines of objects to print")
      ->check(CLI::IsMember({"error", "warning", "info"}))
      ->capture_default_str();
  command
      ->add_option("--console", flags->console_file,
                   "File for what objects print (default: standard error)")
      ->check(IsWritable());
  const auto is_typed = [](const std::string& file) -> std::string {
    if (file != "-") RefuseInput("--stdin", file, FileReadProblem(file, "file of lines", ".txt"));
    return "";
  };
  command
      ->add_option("--stdin", flags->stdin_file,
                   "What is typed on the robots' console: a file, from the start; -: lines of "
                   "standard input as they come (default if it is a terminal)")
      ->check(CLI::Validator(is_typed, ""));
  command
      ->add_option("--events", flags->events_file,
                   "What people do to the robots, from a file of lines such as '2s press chin for "
                   "300ms' (docs/inputs.md)")
      ->check(IsReadable("--events", "script of events (docs/inputs.md)", ".events"));
  command
      ->add_option(
          "--snapshot", flags->snapshots,
          "Take a picture: t=5s,view=side (front, top, iso, follow, world; camera: what the robot "
          "sees),size=1280x720")
      ->take_all();
  command->add_option("-o", flags->snapshot_files, "PNG file of the --snapshot before it")
      ->take_all()
      ->check(IsWritable());
}

// Adds the flags of the remote control and of the web panel, and the flag --ip.  Each value of --ip
// has an address that programs have in their code, and the address that this host uses instead.
void DescribeNetwork(CLI::App* command, RunFlags* flags) {
  command
      ->add_option("--rc-port", flags->simulation.rc_port,
                   "Port of the remote control; 0: any free one")
      ->check(CLI::Validator(&PortNumberProblem, "UINT"));
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
  CLI::Option* const no_panel = command->add_flag("--no-panel", flags->no_panel, "No web panel");
  command
      ->add_flag("--panel", flags->panel,
                 "Web panel (default if standard output is a terminal and --json is absent)")
      ->excludes(no_panel);
  command
      ->add_option("--panel-port", flags->panel_port,
                   "Port of the web panel, or the next free one; 0: any free one")
      ->capture_default_str();
  AddListenFlags(command, &flags->listen);
  no_panel->excludes(command->get_option("--listen"));
}

// Returns the reason why a run with the flags `flags` cannot take the picture that `plan`, a value
// of --snapshot, asks for; "" if it can.
std::string PictureProblem(const PictureRequest& plan, const RunFlags& flags) {
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
    if (problem.empty()) problem = PictureProblem(plan, flags);
    if (!problem.empty()) throw CLI::ValidationError("--snapshot", problem);
    plans.push_back(std::move(plan));
  }
  return plans;
}

// Throws CLI::ValidationError if two flags name the same file, because each would overwrite the
// output of the other.
void CheckThatFilesDiffer(const RunFlags& flags) {
  std::vector<std::pair<std::string, std::string>> named = {
      {"--report", flags.report_file},       {"--record", flags.record_file},
      {"--log-data", flags.data_log.file},   {"--timeline", flags.timeline_file},
      {"--console", flags.console_file},     {"--speaker", flags.simulation.speaker},
      {"--stdin", flags.stdin_file},         {"--events", flags.events_file},
      {"--mic", flags.simulation.microphone}};
  for (const std::string& file : flags.snapshot_files) named.emplace_back("-o", file);
  std::map<std::string, std::string> flag_of;
  for (const auto& [flag, file] : named) {
    // Allows /dev/null for several flags, because nothing is lost there.
    if (file.empty() || file == "-" || file == "/dev/null") continue;
    std::error_code error;  // set if `file` is a stream, such as /dev/stdout; `real` is then unused
    const std::string real = std::filesystem::weakly_canonical(file, error);
    const auto [first, is_new] = flag_of.emplace(error ? file : real, flag);
    if (!is_new) {
      throw CLI::ValidationError(flag,
                                 fmt::format("{} is the file of {} already", file, first->second));
    }
  }
}

// Throws CLI::ValidationError if --json is given and another flag also sends its output to standard
// output.
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

}  // namespace

void DescribeRunFlags(CLI::App* command, RunFlags* flags) {
  DescribeRun(command, flags);
  DescribeOutput(command, flags);
  DescribeNetwork(command, flags);
}

void AddDataLogFlags(CLI::App* command, DataLogOptions* options, std::string* timeline) {
  CLI::Option* const log =
      command
          ->add_option("--log-data", options->file,
                       "Write joints, sensors and poses to this file, .csv or .mcap; .mcap has "
                       "pictures, findings and inputs as well (docs/data.md)")
          ->check(CLI::Validator(&DataLogNameProblem, ""))
          ->check(IsWritable());
  AddDurationFlag(command, "--log-images", &options->image_distance_us,
                  "Virtual time between two pictures in an .mcap file; 0s: no pictures")
      ->needs(log);
  command
      ->add_option("--timeline", *timeline,
                   "Write when handlers ran, and how long: FILE.json for ui.perfetto.dev, or "
                   "FOLDER.ctf for babeltrace2")
      ->check(CLI::Validator(&TimelineNameProblem, ""));
}

bool WantsPanel(const RunFlags& flags) {
  if (flags.panel || flags.no_panel) return flags.panel;
  if (flags.listen.is_on()) return true;
  return !flags.json && isatty(StandardOutput()) == 1 && HasPanel();
}

RunPlan PlanOf(const RunFlags& flags) {
  CheckRobots(flags.simulation);
  CheckThatFilesDiffer(flags);
  CheckStandardOutput(flags);
  const int rc_port = flags.simulation.rc_port;
  if (const std::string problem = PortProblem(rc_port); !problem.empty())
    throw CLI::ValidationError("--rc-port", problem);
  try {
    if (flags.listen.is_on()) CheckListen(flags.listen);
  } catch (const std::exception& error) {
    throw CLI::ValidationError("--listen", error.what());
  }
  RunPlan plan;
  plan.for_us = flags.for_us;
  if (flags.for_us) plan.for_text = flags.for_flag->as<std::string>();
  plan.until_idle = flags.until_idle;
  plan.rate = RateOf(flags.rate);
  plan.snapshots = PictureRequests(flags);
  plan.stdin_file = flags.stdin_file;
  plan.say = [](const std::string& line) {
    ClearProgressLine();
    PrintPlain(stderr, "openr: {}\n", line);
  };
  if (flags.placement.is_free && plan.rate <= 0)
    throw CLI::ValidationError("--free-running", "needs a clock: --rate max has none");
  return plan;
}

EndGuardOptions GuardsOf(const RunFlags& flags, const RunStick& stick) {
  EndGuardOptions options;
  options.answer = flags.json ? StandardOutput() : -1;
  options.answer_file = flags.report_file;
  options.crash_logs.assign(static_cast<size_t>(flags.simulation.robots), stick.crash_log());
  if (stick.is_default()) options.crash_log_place = "";
  options.handler_limit_us = flags.handler_limit_us;
  return options;
}

}  // namespace openr_host
