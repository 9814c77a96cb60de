#include "openr/commands/show_run.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "cli/print_plain.h"
#include "openr/commands/common_flags.h"
#include "openr/live/console_log.h"
#include "openr/live/live_answers.h"
#include "openr/live/live_context.h"
#include "openr/live/live_events.h"
#include "openr/live/live_folder.h"
#include "openr/live/live_server.h"
#include "openr/live/message_history.h"
#include "openr/live/run_clock.h"
#include "openr/panel/panel_process.h"
#include "openr/rewind/rewind.h"
#include "openr/run/interrupt.h"
#include "openr/run/known_runner.h"
#include "openr/simulation/known_run.h"
#include "openr/simulation/simulation.h"
#include "runtime/core/system.h"

namespace openr_host {

void AddShowFlags(CLI::App* command, CLI::Option* panel, ShowOptions* options) {
  command
      ->add_option("--panel-port", options->panel_port,
                   "Port of the web panel, or the next free one; 0: any free one")
      ->needs(panel);
  command->add_option_function<std::string>(
      "--rate", [options](const std::string& text) { options->rate = RateOf(text); },
      "With --panel or --continue-at: virtual seconds per second, or max");
}

int ShowRun(const MakeKnownRun& make, const ShowOptions& options) {
  if (!HasPanel())
    throw std::runtime_error(
        "--panel: this openr was built without the panel; docs/panel.md says "
        "what it needs");
  InterruptCounter interrupts;
  ConsoleLog console;
  // The run; null while make() assembles it.  Images may already print during this time, so the
  // console then uses the time 0.
  KnownRun* run_made = nullptr;
  const std::unique_ptr<KnownRun> run = make([&](std::string_view text) {
    console.Add(run_made == nullptr ? 0 : run_made->simulation().system().now_us(), text);
  });
  run_made = run.get();
  Simulation& simulation = run->simulation();
  RunClock clock(options.rate);
  MessageHistory history(&simulation.system());
  Rewind rewind;
  LiveContext context{&simulation, &clock, &console, &history, nullptr, &rewind, run.get()};
  LiveEvents events(context);
  context.events = &events;
  const auto answer = [&context](const nlohmann::json& request) {
    return AnswerLive(context, request);
  };
  LiveServer live(options.name, answer, &events);
  RewindParts parts;
  parts.simulation = &simulation;
  parts.known = run.get();
  parts.span_us = INT64_MAX;
  parts.answer = answer;
  parts.after_frame = [] {};
  parts.become_copy = [&live] { live.Forget(); };
  parts.become_branch = [&](double rate) {
    live.OpenAgain();
    interrupts.StartAgain();
    clock.set_rate(rate);
    clock.GoOn();
    return std::filesystem::path(LiveSocketPath(options.name)).filename().string();
  };
  rewind.Begin(std::move(parts));
  const std::string socket = std::filesystem::path(LiveSocketPath(options.name)).filename();
  const PanelProcess panel({.port = options.panel_port, .run = socket});
  const auto say = [](const std::string& line) { PrintPlain(stderr, "openr: {}\n", line); };
  say(fmt::format("{:.3f} s can be watched; Ctrl-C ends this",
                  static_cast<double>(run->length_us()) / 1e6));
  return RunKnown({run.get(), &live, &clock, &rewind, &interrupts, say});
}

}  // namespace openr_host
