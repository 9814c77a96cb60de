#include <fmt/format.h>
#include <signal.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "distribution/worker.h"
#include "openr/commands/commands.h"
#include "openr/commands/common_flags.h"
#include "openr/commands/distribution_flags.h"
#include "openr/crash_log.h"
#include "openr/exit_code.h"
#include "openr/last_words.h"
#include "openr/watchdog.h"

namespace openr_host {
namespace {

struct JoinFlags {
  WorkerOptions worker;
  int64_t wait_us = 60'000'000;
  int64_t handler_limit_us = 10'000'000;
  pid_t parent = 0;  // the run that started it; 0: none did
};

// One that a run has started goes when the run goes, however that ends; Ctrl-C is for the run.
void BecomeChild(pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (kill(parent, 0) != 0) _exit(kExitWrong);  // it has gone already
  ::signal(SIGINT, SIG_IGN);
}

int Join(JoinFlags flags) {
  if (flags.parent != 0) {
    BecomeChild(flags.parent);
    flags.worker.bus.lease_s = kWatchedLease_s;
  }
  std::optional<CrashLog> crash_log;
  std::optional<Watchdog> watchdog;
  flags.worker.master_wait_ms = flags.wait_us / 1000;
  const std::string name = flags.worker.process;
  flags.worker.say = [name](const std::string& line) {
    fmt::print(stderr, "openr: process '{}': {}\n", name, line);
  };
  flags.worker.begins = [&](const std::string& stick) {
    crash_log.emplace(std::vector<std::string>{stick});
    watchdog.emplace(flags.handler_limit_us);
  };
  Worker worker(flags.worker);
  const LastWords last_words([&worker](Ending* ending) {
    if (ending->object == nullptr) return;
    const CurrentScope scope(ending->object->system, ending->object);
    worker.TellCrash(ending->finding.text());
  });
  const std::string problem = worker.Run();
  if (problem.empty()) return kExitGood;
  flags.worker.say(problem);
  return kExitWrong;
}

}  // namespace

void AddJoinCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command = app->add_subcommand(
      "join", "Runs the objects that a run has placed in a process of another name or host");
  auto flags = std::make_shared<JoinFlags>();
  flags->worker.bus.run = "openr";
  command->add_option("--process", flags->worker.process, "Its name in the placement")->required();
  command->add_option("--run-name", flags->worker.bus.run, "Name of the run")
      ->capture_default_str();
  command->add_option("--stick", flags->worker.stick,
                      "A copy of the run's stick (default: the folder that the run names)");
  AddDurationFlag(command, "--wait", &flags->wait_us, "How long to wait for the run");
  AddDurationFlag(command, "--handler-limit", &flags->handler_limit_us,
                  "End the process when a handler uses more processor time; 0s: never");
  command->add_option("--child-of", flags->parent)->group("");  // for openr run
  AddBusFlags(command, &flags->worker.bus);
  command->callback([flags, exit_code] { *exit_code = Join(*flags); });
}

}  // namespace openr_host
