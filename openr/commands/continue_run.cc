#include "openr/commands/continue_run.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

#include "cli/exit_code.h"
#include "cli/print_plain.h"
#include "cli/progress_line.h"
#include "openr/inspect/recorder.h"
#include "openr/live/console_log.h"
#include "openr/live/live_answers.h"
#include "openr/live/live_context.h"
#include "openr/live/live_events.h"
#include "openr/live/live_folder.h"
#include "openr/live/live_server.h"
#include "openr/live/message_history.h"
#include "openr/live/run_clock.h"
#include "openr/panel/panel_process.h"
#include "openr/rewind/branch_network.h"
#include "openr/rewind/rewind.h"
#include "openr/run/interrupt.h"
#include "openr/run/report.h"
#include "openr/run/runner.h"
#include "runtime/base/duration.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// A recorded run that is first replayed and then goes on live.  Each robot has a BranchNetwork.
// During the replay this network repeats the recorded data; afterwards it uses a real network.
class ContinuedRun {
 public:
  explicit ContinuedRun(const ContinueOptions& options) : options_(options) {
    ReplayOptions replay = options.replay;
    if (!options.record_file.empty())
      recorder_ = std::make_unique<Recorder>(options.record_file, true);
    replay.console = [this, also = options.replay.console](std::string_view text) {
      also(text);
      console_.Add(replayer_ == nullptr ? 0 : replayer_->system().now_us(), text);
    };
    replay.prepare = [this](SimulationOptions* simulation) { Prepare(simulation); };
    replay.begin = [this](Simulation* simulation, const SimulationOptions& simulation_options,
                          const std::vector<TraceEntry>& changes) {
      if (recorder_ == nullptr) return;
      recorder_->Begin(simulation, simulation_options, StickName());
      recorder_->AddStick(changes);
    };
    replayer_ = std::make_unique<Replayer>(replay);
    ReplayUpToTheMoment();
  }

  Simulation& simulation() { return replayer_->simulation(); }
  ConsoleLog* console() { return &console_; }

  // Opens the ports of the robots on the network.  From now on the run is live: its input comes
  // from the real network and not from the recording.
  void GoLive() {
    replayer_->EndComparison();
    for (BranchNetwork* const network : networks_) network->GoOn();
  }

  // Drops the network events that log_ has kept, because only a run that can be rewound needs them,
  // and this run cannot be rewound.
  void ForgetEvents() { log_.DropBefore(log_.end()); }

  // Completes the recording of the run.  Returns "", or the error that happened while the recording
  // was written.
  std::string Finish() {
    return recorder_ == nullptr ? "" : recorder_->Finish(&simulation().system());
  }

 private:
  // Gives each robot a network that first repeats the recorded data, and then uses a real network.
  void Prepare(SimulationOptions* simulation) {
    // Gives the robots real networks.  A BranchNetwork does not use its real network during the
    // replay, but needs it when the run goes on live.
    simulation->host_network = true;
    simulation->network_filter = [this, recorded = simulation->network_filter](
                                     int robot, std::unique_ptr<Network> inner) {
      const std::shared_ptr<Network> replayed = recorded(robot, nullptr);
      auto network = std::make_unique<BranchNetwork>(std::move(inner), robot, &log_);
      network->RepeatFrom([replayed] { return replayed->Poll(); });
      networks_.push_back(network.get());
      return network;
    };
    if (recorder_ != nullptr) recorder_->RecordNetworks(simulation);
  }

  // Returns the folder of the Memory Stick of which the replay uses a copy.  This is the folder
  // that the user has given.  If the user has given none, it is the folder with which the run was
  // recorded.
  std::string StickName() const {
    if (!options_.replay.stick.empty()) return options_.replay.stick;
    return TraceReader(options_.replay.file).header().stick;
  }

  void ReplayUpToTheMoment() {
    const std::string& file = options_.replay.file;
    if (!replayer_->reader().header().schedule.empty()) {
      throw std::runtime_error(
          fmt::format("{}: is a run of openr explore, whose order of messages was chosen up to its "
                      "end; it cannot go on otherwise",
                      file));
    }
    if (options_.at_us > replayer_->length_us()) {
      throw std::runtime_error(fmt::format("{}: has nothing at t={}; it ends at t={}", file,
                                           FormatDuration(options_.at_us),
                                           FormatDuration(replayer_->length_us())));
    }
    replayer_->RunWithProgress(options_.at_us, STDERR_FILENO);
    if (!replayer_->difference().empty() || !replayer_->loss().empty())
      throw std::runtime_error(fmt::format("{}: {}", file, replayer_->EndReason()));
    if (simulation().system().powered_off()) {
      throw std::runtime_error(
          fmt::format("{}: the robots are off at t={}", file, FormatDuration(options_.at_us)));
    }
  }

  const ContinueOptions& options_;
  ConsoleLog console_;
  InputLog log_;
  // The network of each robot; the index is the number of the robot.
  std::vector<BranchNetwork*> networks_;
  std::unique_ptr<Recorder> recorder_;  // null: the run is not recorded
  std::unique_ptr<Replayer> replayer_;
};

RunPlan PlanOf(const ContinueOptions& options) {
  RunPlan plan;
  plan.has_begun = true;
  if (options.for_us) {
    plan.for_us = options.at_us + *options.for_us;
    plan.for_text = FormatDuration(*options.for_us);
  }
  plan.rate = options.rate;
  plan.say = [](const std::string& line) {
    ClearProgressLine();
    PrintPlain(stderr, "openr: {}\n", line);
  };
  return plan;
}

}  // namespace

int ContinueRun(const ContinueOptions& options) {
  // Ends a run without a fixed end when the terminal is closed (SIGHUP), because nobody could press
  // Ctrl-C later.  A run with a fixed end (`for_us`) ignores SIGHUP.
  InterruptCounter interrupts(options.for_us ? HangUp::kIgnored : HangUp::kCounts);
  ContinuedRun run(options);
  System& system = run.simulation().system();
  RunPlan plan = PlanOf(options);
  plan.say(fmt::format("{} goes on from t={:.3f} s", options.replay.file,
                       static_cast<double>(system.now_us()) / 1e6));
  run.GoLive();
  RunClock clock(options.rate);
  MessageHistory history(&system);
  Rewind rewind;
  LiveContext context{&run.simulation(), &clock, run.console(), &history, nullptr, &rewind};
  LiveEvents events(context);
  context.events = &events;
  const std::string name = std::filesystem::path(options.replay.file).stem();
  LiveServer live(
      name, [&context](const nlohmann::json& request) { return AnswerLive(context, request); },
      &events);
  RewindParts parts;
  parts.simulation = &run.simulation();
  parts.no_rewind_reason = "it goes on from a recording; openr replay goes back in that";
  rewind.Begin(std::move(parts));
  std::unique_ptr<PanelProcess> panel;
  const std::string socket = std::filesystem::path(LiveSocketPath(name)).filename();
  if (options.panel)
    panel = std::make_unique<PanelProcess>(PanelOptions{.port = options.panel_port, .run = socket});
  plan.live = &live;
  plan.clock = &clock;
  RunProgressLine progress(options.for_us ? STDERR_FILENO : -1, options.at_us,
                           plan.for_us.value_or(0));
  plan.after_frame = [&run, &system, &progress] {
    run.ForgetEvents();
    progress.Show(system.now_us());
  };
  Runner runner(&run.simulation(), plan, &interrupts);
  bool good = runner.Run();
  const std::string problem = run.Finish();
  PrintPlain(stderr, "{}", DescribeFindings(&run.simulation()));
  if (!problem.empty()) PrintPlain(stderr, "openr: {}\n", problem);
  if (system.end()) PrintPlain(stderr, "{}\n", DescribeEnd(*system.end()));
  good = good && problem.empty() && !system.findings().HasError();
  return good ? kExitGood : kExitWrong;
}

}  // namespace openr_host
