#include "openr/controller/controller_run.h"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <cstdlib>

#include "ControllerApi.h"
#include "cli/exit_code.h"
#include "openr/controller/remote_port.h"
#include "openr/controller/step_clock.h"
#include "runtime/base/terminal_text.h"
#include "runtime/base/wall_clock.h"

namespace openr_host {
namespace {

namespace remote = openr::remote;

constexpr int64_t kNsPerMs = 1'000'000;

volatile sig_atomic_t g_stops = 0;  // number of the signal that ends the controller; 0: none

// Asks the controller to end at the first signal.  Ends the process at once at a second signal,
// because a controller may never return.  Ignores a second signal that comes within one second,
// because the program `timeout` sends two.
void OnStop(int signal_number) {
  static volatile int64_t first_ms = 0;
  if (g_stops == 0) {
    first_ms = WallClockMs();
    g_stops = signal_number;
  } else if (WallClockMs() - first_ms > 1000) {
    _exit(128 + signal_number);
  }
}

void CatchStop() {
  struct sigaction action {};
  action.sa_handler = &OnStop;
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

// Runs a controller on this computer, from the start of its main() to the end of its loop.
class Session {
 public:
  explicit Session(const ControllerRun& run)
      : run_(run),
        port_(remote::ParseAddress(run.address),
              {.timeout = std::chrono::milliseconds(run.timeout_ms), .token = run.token},
              run.folder, [this] { StepInMain(); }) {}

  int Run();

 private:
  bool WaitForStanding();
  bool WaitForNextStep();
  void StepInMain();
  int End();
  std::string RobotTime() const;

  const ControllerRun run_;
  RemotePort port_;
  StepClock clock_;
  std::string why_ = "its loop has ended";
  int status_ = kExitGood;
  // Frame numbers of the robot at the start of the first and of the last iteration of the
  // controller's loop.
  uint32_t first_frame_ = 0, last_frame_ = 0;
};

// Waits until the robot stands, because also on the robot the main() of a controller begins only
// when the robot stands.  Returns false if Ctrl-C or SIGTERM ends the wait.
bool Session::WaitForStanding() {
  const auto is_ended = [this] { return g_stops != 0 || port_.Stands(); };
  port_.ReceiveUntil(WallClockNs() + 100 * kNsPerMs, is_ended);
  if (!is_ended()) fmt::print(stderr, "openr: waits until the robot stands\n");
  port_.ReceiveUntil(INT64_MAX, is_ended);
  return g_stops == 0;
}

// Waits until the present iteration of the controller's loop ends.  Returns false when openr is to
// end.
bool Session::WaitForNextStep() {
  try {
    port_.Check();
    int step_ms = 0;
    if (g_stops == 0 && !port_.TakeNewStep(&step_ms)) return false;
    if (clock_.iterations() == 0) first_frame_ = port_.frame();
    const int64_t next_ns = clock_.Next(WallClockNs(), step_ms * kNsPerMs);
    port_.ReceiveUntil(next_ns, [] { return g_stops != 0; });
    if (g_stops != 0) {
      why_ = g_stops == SIGINT ? "Ctrl-C" : "SIGTERM";
      return false;
    }
    const std::string late = clock_.Begin(WallClockNs());
    last_frame_ = port_.frame();
    if (!late.empty()) fmt::print(stderr, "openr: {}\n", late);
    return true;
  } catch (const std::exception& error) {
    fmt::print(stderr, "openr: {}\n", TerminalText(error.what()));
    why_ = "no connection to the robot";
    status_ = kExitWrong;
    return false;
  }
}

// Runs an iteration of the controller's loop while its main() waits in robot_step().  When openr is
// to end, ends the process here, because nothing can make main() return while it waits.
void Session::StepInMain() {
  port_.core()->LedReady();
  if (!WaitForNextStep()) std::exit(End());
}

int Session::Run() {
  CatchStop();
  if (!WaitForStanding()) return kExitGood;
  SetControllerCore(port_.core());
  port_.core()->Execute(run_.controller_main);
  while (WaitForNextStep()) port_.core()->LedReady();
  return End();
}

// Ends the controller, and waits until the robot has answered all commands.  Returns the exit
// status.
int Session::End() {
  port_.core()->Die();
  SetControllerCore(nullptr);
  try {
    if (status_ == kExitGood) port_.Finish();
  } catch (const std::exception& error) {
    fmt::print(stderr, "openr: {}\n", TerminalText(error.what()));
    status_ = kExitWrong;
  }
  fmt::print(stderr, "openr: the controller has ended: {}; {}{}\n", why_, clock_.Summary(),
             RobotTime());
  return status_;
}

// Returns a text with the mean duration of the controller's iterations on the robot's clock.  This
// clock may run slower or faster than the clock of this computer.
std::string Session::RobotTime() const {
  const auto count = static_cast<double>(clock_.iterations());
  if (count == 0 || last_frame_ <= first_frame_) return "";
  return fmt::format(" ({:.1f} ms on the robot's clock)", (last_frame_ - first_frame_) * 8 / count);
}

int RunOrThrow(const ControllerRun& run) { return Session(run).Run(); }

}  // namespace
}  // namespace openr_host

extern "C" __attribute__((visibility("default"))) int openr_run_controller(
    const openr_host::ControllerRun& run) {
  try {
    return openr_host::RunOrThrow(run);
  } catch (const std::exception& error) {
    fmt::print(stderr, "openr: {}\n", openr_host::TerminalText(error.what()));
    return openr_host::kExitWrong;
  }
}
