#include "openr/run/known_runner.h"

#include <algorithm>

#include "cli/exit_code.h"
#include "openr/live/live_server.h"
#include "openr/live/run_clock.h"
#include "openr/rewind/rewind.h"
#include "openr/run/interrupt.h"
#include "openr/run/run_step.h"
#include "openr/simulation/known_run.h"
#include "openr/simulation/pacer.h"
#include "openr/simulation/simulation.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

class KnownRunner {
 public:
  explicit KnownRunner(const KnownRunnerParts& parts)
      : parts_(parts), system_(parts.run->simulation().system()), pacer_(parts.clock->rate()) {}

  int Run() {
    while (parts_.interrupts->count() == 0 && !parts_.rewind->has_branched()) {
      parts_.live->Serve();
      if (parts_.clock->paused() || is_over_) {
        WaitOrStep();
      } else {
        GoOn();
      }
      if (system_.now_us() % kFrameUs == 0) AfterFrame();
      NoteEnd();
    }
    if (!parts_.rewind->has_branched()) return kExitGood;
    return parts_.rewind->WaitForBranch([this] { return parts_.interrupts->count(); });
  }

 private:
  int64_t FrameEnd() const { return (system_.now_us() / kFrameUs + 1) * kFrameUs; }

  void AfterFrame() {
    // Passes true, as if a client always watched the run, so that checkpoints are made from the
    // beginning of the run, and a later client can go back to it.
    if (!parts_.rewind->AfterFrame(true)) return;
    // Restarts the pacer, which keeps virtual time in step with the clock of this computer, because
    // this process has just become a branch, which goes on from an earlier moment.
    pacer_.Restart();
    is_over_ = false;
  }

  void WaitOrStep() {
    constexpr int kWaitMs = 50;  // longest time for which Ctrl-C may go unnoticed
    const RunClock::Step step = is_over_ ? RunClock::Step::kNone : parts_.clock->TakeStep();
    if (step == RunClock::Step::kNone) {
      parts_.live->WaitAndServe(kWaitMs);
    } else {
      MakeStep(&parts_.run->simulation(), step, FrameEnd(),
               [this](int64_t time_us) { parts_.run->RunOne(time_us); });
    }
    pacer_.Restart();
  }

  // Runs to the end of the frame, and waits for the clock so that the run has the rate that the
  // user wants.  Does not wait if the user has asked to go to a later moment.
  void GoOn() {
    RunClock& clock = *parts_.clock;
    const bool has_goal = clock.goal_us() != INT64_MAX;
    const int64_t stop_us = std::min(FrameEnd(), std::max(clock.goal_us(), system_.now_us()));
    if (has_goal) {
      pacer_.Restart();
    } else {
      if (clock.rate() != pacer_.rate()) pacer_.set_rate(clock.rate());
      pacer_.WaitFor(stop_us);
    }
    parts_.run->RunUntil(stop_us);
    if (system_.now_us() >= clock.goal_us()) clock.Pause();
  }

  void NoteEnd() {
    const std::string why = parts_.run->EndReason();
    if (why.empty()) return;
    if (!parts_.clock->paused()) parts_.clock->Pause();  // pauses the run, because it is over
    if (is_over_) return;
    is_over_ = true;
    parts_.say(why);
  }

  const KnownRunnerParts parts_;
  System& system_;
  Pacer pacer_;
  bool is_over_ = false;
};

}  // namespace

int RunKnown(const KnownRunnerParts& parts) { return KnownRunner(parts).Run(); }

}  // namespace openr_host
