#include "openr/commands/explore_replay.h"

#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

#include "cli/counted.h"
#include "cli/exit_code.h"
#include "cli/json_text.h"
#include "cli/print_plain.h"
#include "kit/shell_words.h"
#include "openr/commands/common_flags.h"
#include "openr/commands/explore_setup.h"
#include "openr/ending/end_guards.h"
#include "openr/explore/failing_run.h"
#include "openr/explore/fork_server.h"
#include "openr/inspect/recorder.h"
#include "openr/simulation/pacer.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

// Shows the failing run of a schedule file (openr explore -o) on the panel.  `answer` describes how
// the run ended; ReplayDeviations() has returned it.  Returns the exit code.
int ShowFailure(const ExploreFlags& flags, const ExploredStick& stick, uint64_t seed,
                const Json& deviations, const Json& answer) {
  const EndGuards guards({.handler_limit_us = 0});
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

}  // namespace

bool RecordFailure(const ExploreFlags& flags, const ExploredStick& stick, uint64_t seed,
                   const Json& deviations, const Json& answer) {
  // Does not repeat a run that was killed because it did not end.  The repeated run might not end
  // either, and its recording would fill the disk.
  if (answer.contains(kNotEnded)) {
    PrintPlain(stderr, "openr explore: no recording: {}\n",
               answer["broken"]["text"].get<std::string>());
    return false;
  }
  const EndGuards guards({.handler_limit_us = flags.plan.limits.handler_us});
  PrintPlain(stderr, "openr explore: writing {}; openr replay {} --step goes through it\n",
             flags.record_file, ShellWord(flags.record_file));
  SimulationOptions simulation = stick.simulation;
  simulation.console = [](std::string_view) {};
  simulation.host_network = false;
  Recorder recorder(flags.record_file, true);
  recorder.RecordNetworks(&simulation);
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
  system.robot_table().NoteRunEnd({EndKind::kTime, run.EndReason()});
  const std::string problem = recorder.Finish(&system);
  if (!problem.empty()) PrintPlain(stderr, "openr explore: {}\n", problem);
  return problem.empty();
}

int ReplayFailure(ExploreFlags flags) {
  Json deviations;
  const ScheduleFile schedule = ReadScheduleFile(flags.replay_file, &deviations);
  ExploredStick stick = schedule.stick;
  if (!flags.stick.simulation.stick.empty()) stick.simulation.stick = flags.stick.simulation.stick;
  if (!flags.stick.simulation.more_sticks.empty())
    stick.simulation.more_sticks = flags.stick.simulation.more_sticks;
  const size_t sticks = stick.simulation.more_sticks.size() + 1;
  if (sticks > static_cast<size_t>(stick.simulation.robots)) {
    throw CLI::ValidationError(
        "--stick", fmt::format("{} sticks, but the failing run has {}", sticks,
                               Counted(static_cast<size_t>(stick.simulation.robots), "robot")));
  }
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
  PrintResult(result, text, flags.json);
  if (flags.panel) return ShowFailure(flags, stick, schedule.seed, deviations, answer);
  bool good = !broken;
  if (broken && !flags.record_file.empty())
    good = RecordFailure(flags, stick, schedule.seed, deviations, answer) && good;
  return WithConsole(good ? kExitGood : kExitWrong, console);
}

}  // namespace openr_host
