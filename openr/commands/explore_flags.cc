#include "openr/commands/explore_flags.h"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string>

#include "cli/input_file.h"
#include "openr/commands/common_flags.h"
#include "openr/explore/property.h"

namespace openr_host {
namespace {

constexpr uint64_t kRunsMax = 1'000'000'000;

// Checks `name`, a value of --property.  A value with a space is itself the text of a property.  A
// value without a space but with a dot or a slash is a file, because the names of built-in
// properties have no dot and no slash.  Throws CLI::ParseError if the value is a file that cannot
// be read.  Otherwise returns "", so that CLI11 accepts the value.
std::string CheckProperty(const std::string& name) {
  const bool is_line = name.find(' ') != std::string::npos;
  if (is_line || name.find_first_of("./") == std::string::npos) return "";
  RefuseInput("--property", name,
              FileReadProblem(name, "file of properties (docs/exploring.md)", ".txt"));
  return "";
}

void AddTargetOptions(CLI::App* command, ExploreFlags* flags) {
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

void AddSearchOptions(CLI::App* command, ExploreFlags* flags) {
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
      ->check(IsWritable())
      ->excludes(panel);
  command->add_flag("--json", flags->json, "Print the result, and nothing else, as JSON");
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

void AddExploreFlags(CLI::App* command, ExploreFlags* flags) {
  flags->plan.jobs = static_cast<int>(std::max(1L, sysconf(_SC_NPROCESSORS_ONLN)));
  flags->stick.simulation.body = "ideal";
  AddTargetOptions(command, flags);
  AddSearchOptions(command, flags);
  command->footer(ListOfProperties());
}

}  // namespace openr_host
