#include "openr/run/runner.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "cli/install_paths.h"
#include "openr/live/live_server.h"
#include "openr/rewind/rewind.h"
#include "openr/run/console_feed.h"
#include "openr/run/event_script.h"
#include "openr/run/interrupt.h"
#include "openr/run/run_step.h"
#include "openr/simulation/activity.h"
#include "openr/simulation/pacer.h"
#include "openr/simulation/simulation.h"
#include "runtime/base/assert.h"
#include "runtime/base/duration.h"
#include "runtime/base/wall_clock.h"
#include "runtime/core/leaks.h"
#include "runtime/core/stack_report.h"
#include "runtime/core/stalls.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// The longest virtual time that a shutdown by the runner may take, that is, DoStop and DoDestroy of
// all objects on all robots.  The runner begins the shutdown kPauseUs after the pause button was
// pressed.  After this limit the run ends anyway, because a shutdown that takes so long may never
// complete.
constexpr int64_t kShutdownMaxUs = 60'000'000;

}  // namespace

Runner::Runner(Simulation* simulation, RunPlan plan, const InterruptCounter* interrupts)
    : simulation_(simulation),
      plan_(std::move(plan)),
      interrupts_(interrupts),
      standing_(simulation->robots().size(), StandingMonitor(simulation->model())),
      taken_(plan_.snapshots.size(), false),
      announced_(simulation->robots().size()) {
  ASSERT(plan_.rate > 0 || plan_.pump == nullptr);
}

void Runner::WatchActivity() {
  if (!plan_.until_idle) return;
  System& system = simulation_->system();
  activity_sink_ =
      system.trace().AddSink([this, &system](const TraceRecord& record, const Message& message) {
        if (IsActivity(system, message)) last_activity_us_ = record.time_us;
      });
}

std::optional<RunEnd> Runner::EndOfRun() const {
  System& system = simulation_->system();
  const int64_t now_us = system.now_us();
  if (system.powered_off()) return {};
  if (interrupts_->count() >= 2)
    return RunEnd{EndKind::kSignal, "Ctrl-C or SIGTERM came again; no object was told"};
  if (plan_.rewind != nullptr && plan_.rewind->has_branched())
    return RunEnd{EndKind::kBranch, "a copy of the run goes on from an earlier moment"};
  if (pause_pressed_us_ >= 0) {
    if (now_us - pause_pressed_us_ < kPauseUs + kShutdownMaxUs) return {};
    return RunEnd{EndKind::kPause, "the shutdown after the pause button took more than 60 s"};
  }
  if (plan_.for_us && now_us >= *plan_.for_us)
    return RunEnd{EndKind::kTime, fmt::format("--for {} is over", plan_.for_text)};
  const bool waits_for_boot = !system.robot_table().off_robots().empty();
  if (plan_.until_idle && system.booted() && !waits_for_boot &&
      now_us - last_activity_us_ >= kIdleUs)
    return RunEnd{EndKind::kIdle, "no object has sent anything for 1 s (--until-idle)"};
  return {};
}

int64_t Runner::NextStop() const { return NextStopAfter(simulation_->system().now_us()); }

int64_t Runner::NextStopAfter(int64_t now_us) const {
  int64_t stop_us = (now_us / kFrameUs + 1) * kFrameUs;
  if (plan_.for_us && *plan_.for_us > now_us) stop_us = std::min(stop_us, *plan_.for_us);
  return stop_us;
}

void Runner::AddInputToAll(std::string_view line) {
  System& system = simulation_->system();
  for (int robot = 0; robot < system.robot_count(); ++robot) system.inputs().Add(robot, line);
}

void Runner::PressPause() {
  pause_pressed_us_ = simulation_->system().now_us();
  plan_.say("pause button pressed; again to end at once");
  AddInputToAll("press pause");
}

void Runner::WritePictures(bool at_end) {
  System& system = simulation_->system();
  for (size_t i = 0; i < plan_.snapshots.size(); ++i) {
    const PictureRequest& snapshot = plan_.snapshots[i];
    if (taken_[i]) continue;
    const bool wants_end = snapshot.time_us < 0;
    if (wants_end ? at_end : system.now_us() >= snapshot.time_us) {
      taken_[i] = true;
      WritePictureOf(snapshot);
    } else if (at_end) {
      system.AddFindingAbout(
          nullptr, Severity::kError,
          fmt::format("no picture {}: the run was over before t={}; t=end is its end",
                      snapshot.file, FormatDuration(snapshot.time_us)));
    }
  }
}

void Runner::WritePictureOf(const PictureRequest& snapshot) {
  const int64_t begin_ns = WallClockNs();
  VirtualRobot* const robot = simulation_->robots().at(static_cast<size_t>(snapshot.robot));
  const std::string problem = WritePicture(
      snapshot, robot,
      simulation_->is_together() ? simulation_->robots() : std::vector<VirtualRobot*>{});
  good_ = good_ && problem.empty();
  // Leaves out the time in which a picture is drawn, because it says nothing about the speed of the
  // simulation.
  wall_time_ns_ -= WallClockNs() - begin_ns;
  const double time_s = static_cast<double>(simulation_->system().now_us()) / 1e6;
  plan_.say(problem.empty() ? fmt::format("wrote {} (t={:.3f} s)", snapshot.file, time_s)
                            : problem);
}

void Runner::AnnouncePorts() {
  if (!plan_.has_ports) return;
  for (size_t i = 0; i < announced_.size(); ++i) {
    const uint16_t port = simulation_->RcPort(static_cast<int>(i));
    if (port == 0 || announced_[i].port == port) continue;
    announced_[i].port = port;
    plan_.say(announced_.size() == 1
                  ? fmt::format("remote control: {} rc 127.0.0.1:{} info", ProgramCall(), port)
                  : fmt::format("remote control of robot {}: {} rc 127.0.0.1:{} info", i,
                                ProgramCall(), port));
  }
}

// Prints a line when a robot waits for its boot timer, and when the robot boots again.
void Runner::AnnounceBoots() {
  System& system = simulation_->system();
  for (size_t i = 0; i < announced_.size(); ++i) {
    const int robot = static_cast<int>(i);
    PrintedFacts& announced = announced_[i];
    const std::string name = announced_.size() == 1 ? "the robot" : fmt::format("robot {}", i);
    const bool has_booted =
        std::exchange(announced.boots, system.robot(robot).boots) != system.robot(robot).boots;
    if (has_booted && !system.robot(robot).powered_off)
      plan_.say(fmt::format("{} has booted again; all its images are new loads", name));
    const bool is_off = system.robot_table().off_robots().Contains(robot);
    if (std::exchange(announced.is_off, is_off) == is_off || !is_off) continue;
    plan_.say(
        fmt::format("{} is off, and boots again at t={:.3f} s", name,
                    static_cast<double>(system.robot_table().off_robots().BootUs(robot)) / 1e6));
  }
}

void Runner::SampleStanding() {
  for (size_t i = 0; i < standing_.size(); ++i) {
    standing_[i].Sample(simulation_->robots()[i]->body().state(), simulation_->system().now_us());
  }
}

void Runner::AfterFrame() {
  SampleStanding();
  if (plan_.after_frame) plan_.after_frame();
  AnnounceBoots();
  AnnouncePorts();
  WritePictures(false);
  if (plan_.rewind != nullptr && plan_.live != nullptr)
    is_new_branch_ = plan_.rewind->AfterFrame(plan_.live->is_watched());
}

// Presses the pause button of the robots after the first Ctrl-C.  If no object has shut the robots
// down within kPauseUs, shuts all of them down.
void Runner::HandleInterrupt() {
  System& system = simulation_->system();
  if (interrupts_->count() == 1 && pause_pressed_us_ < 0) PressPause();
  if (pause_pressed_us_ >= 0 && !shutdown_posted_ &&
      system.now_us() - pause_pressed_us_ >= kPauseUs) {
    shutdown_posted_ = true;
    plan_.say("no object handles the pause button; shutting down");
    for (int robot = 0; robot < system.robot_count(); ++robot) {
      system.robot_table().NoteEnd(
          robot, {EndKind::kPause,
                  "no object shut the robot down within 1 s after the pause button, so "
                  "openr did"});
    }
    AddInputToAll("shutdown");
  }
}

double Runner::wall_time_s() const {
  const int64_t running_ns = begin_ns_ == 0 ? 0 : WallClockNs() - begin_ns_;
  return static_cast<double>(wall_time_ns_ + running_ns) / 1e9;
}

// Runs to the virtual time `stop_us` in a free run, in which virtual time goes on while handlers
// run in worker processes.  The run goes no faster than the clock of this computer.  While it waits
// for the clock, it applies the results of these handlers when they come.
void Runner::RunFreely(int64_t stop_us, Pacer* pacer) {
  // Longest wait in `pump`, the function that waits for results of worker processes, in
  // microseconds.  Whatever else comes meanwhile, such as Ctrl-C, is delayed by at most this time.
  constexpr double kSliceUs = 1000;
  System& system = simulation_->system();
  while (!system.powered_off()) {
    const int64_t clock_us = pacer->TimeNow(system.now_us());
    system.RunUntil(std::clamp(clock_us, system.now_us(), stop_us));
    const double left_us = static_cast<double>(stop_us - clock_us) / plan_.rate;
    plan_.pump(static_cast<int64_t>(std::clamp(left_us, 0.0, kSliceUs)));
    if (clock_us >= stop_us) return;
  }
}

// If the run is paused, makes the step that a user has asked for, or waits a moment for such a
// request.  Returns false if the run is not paused.  Also returns false after the robot's pause
// button was pressed: this button shuts the robot down, so the user wants the run to end.
bool Runner::WaitWhilePaused(Pacer* pacer) {
  if (plan_.clock == nullptr || !plan_.clock->paused() || pause_pressed_us_ >= 0) return false;
  constexpr int kWaitMs = 50;  // longest time for which Ctrl-C and typed text may go unnoticed
  const RunClock::Step step = plan_.clock->TakeStep();
  if (step == RunClock::Step::kNone) {
    plan_.live->WaitAndServe(kWaitMs);
  } else {
    System& system = simulation_->system();
    MakeStep(simulation_, step, NextStop(), [&](int64_t time_us) { system.RunOne(time_us); });
  }
  pacer->Restart();
  return true;
}

// Lets the run go on to the next frame boundary or to the end of --for, at the rate that the user
// wants.
void Runner::GoOn(Pacer* pacer) {
  const int64_t stop_us = NextStop();
  if (plan_.clock != nullptr && plan_.clock->rate() != pacer->rate())
    pacer->set_rate(plan_.clock->rate());
  if (plan_.pump) return RunFreely(stop_us, pacer);
  // Does not wait for the clock after the pause button was pressed, because the user wants the run
  // to end.
  if (pause_pressed_us_ < 0) pacer->WaitFor(stop_us);
  simulation_->system().RunUntil(stop_us);
}

bool Runner::Run() {
  System& system = simulation_->system();
  Pacer pacer(plan_.rate);
  WatchActivity();
  begin_ns_ = WallClockNs();
  ConsoleFeed typed(plan_.stdin_file);
  if (!plan_.has_begun) system.Boot();
  std::optional<RunEnd> end = EndOfRun();
  for (; !end && !system.powered_off(); end = EndOfRun()) {
    typed.Feed(&system);
    if (plan_.events != nullptr) plan_.events->Feed(&system);
    if (plan_.live != nullptr) plan_.live->Serve();
    const int64_t before_us = system.now_us();
    if (!WaitWhilePaused(&pacer)) GoOn(&pacer);
    // Does not end the frame if the run has stopped within the frame.  A paused run can stop within
    // a frame when the user asks for a step to the next message.
    const bool is_within_frame = system.now_us() < NextStopAfter(before_us);
    if (!is_within_frame || system.powered_off()) AfterFrame();
    // Restarts the pacer in a branch, a run that goes on from an earlier moment, because the pacer,
    // which keeps virtual time in step with the clock of this computer, still counts from the
    // moment of the checkpoint.
    if (std::exchange(is_new_branch_, false)) pacer.Restart();
    HandleInterrupt();
  }
  if (end) system.robot_table().NoteRunEnd(*end);
  system.trace().RemoveSink(activity_sink_);
  Finish();
  wall_time_ns_ += WallClockNs() - std::exchange(begin_ns_, 0);
  return good_;
}

// Adds the findings that are known only at the end of the run, and completes the files of the run.
void Runner::Finish() {
  System& system = simulation_->system();
  // Reports objects that wait for something that cannot come, for example for an observer that
  // never asks for more data (runtime/core/stalls.h).  Does not do so when all robots are off,
  // because no object waits any more then, nor when the run goes on in a branch.
  const bool goes_on = plan_.rewind != nullptr && plan_.rewind->has_branched();
  if (!system.powered_off() && !goes_on) {
    const bool is_silent = plan_.until_idle && system.now_us() - last_activity_us_ >= kIdleUs;
    ReportStalls(&system, is_silent);
  }
  if (plan_.events != nullptr && !goes_on) plan_.events->ReportRest(&system);
  ReportStacks(&system);
  if (system.options().find_leaks && !goes_on) ReportLeaks(&system);
  simulation_->ReportUnusedCosts();
  simulation_->CloseFiles();
  if (!goes_on) WritePictures(true);
}

}  // namespace openr_host
