// The command openr explore: runs the objects of a stick many times, with many legal orders of
// their messages.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/counted.h"
#include "cli/exit_code.h"
#include "cli/install_paths.h"
#include "cli/json_text.h"
#include "cli/output_file.h"
#include "cli/print_plain.h"
#include "cli/progress_line.h"
#include "kit/shell_words.h"
#include "openr/commands/commands.h"
#include "openr/commands/common_flags.h"
#include "openr/commands/explore_flags.h"
#include "openr/commands/explore_replay.h"
#include "openr/commands/explore_setup.h"
#include "openr/explore/explorer.h"
#include "openr/explore/schedule_file.h"
#include "openr/simulation/cost_file.h"
#include "runtime/base/duration.h"
#include "runtime/base/wall_clock.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

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

// Writes the failing run of `result`, the run that broke a property, to the file that the flag -o
// names.  `openr explore --replay` can repeat the run from this file.  Does nothing without -o.
// Returns false after printing an error.
bool WriteFailure(const Json& result, const ExploreFlags& flags) {
  if (flags.file.empty()) return true;
  if (!result.contains("failure")) {
    // Removes the schedule file of an earlier exploration, because it would look like the result of
    // this exploration.
    RemoveFile(flags.file);
    return true;
  }
  const Json schedule = ScheduleToJson(flags.stick, result["failure"]);
  const std::string problem = WriteFile(flags.file, JsonText(schedule, 2) + "\n");
  PrintPlain(stderr, "openr explore: {}\n",
             problem.empty() ? fmt::format("wrote {}; again: {} explore --replay {}", flags.file,
                                           ShellWord(ProgramCall()), ShellWord(flags.file))
                             : problem);
  return problem.empty();
}

int Explore(ExploreFlags flags) {
  if (!flags.replay_file.empty()) return ReplayFailure(std::move(flags));
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
  PrintResult(result, Summary(result, flags), flags.json);
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

}  // namespace

void AddExploreCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command = app->add_subcommand(
      "explore", "Runs a stick under many legal orders of its messages and checks properties");
  auto flags = std::make_shared<ExploreFlags>();
  AddExploreFlags(command, flags.get());
  command->callback([flags, exit_code] {
    StartWithSanitizersOf(flags->stick.simulation);
    *exit_code = Explore(*flags);
  });
}

}  // namespace openr_host
