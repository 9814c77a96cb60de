#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/exit_code.h"
#include "cli/json_text.h"
#include "cli/print_plain.h"
#include "cli/standard_streams.h"
#include "distribution/status_topic.h"
#include "openr/commands/commands.h"
#include "openr/commands/common_flags.h"
#include "openr/commands/distribution_flags.h"
#include "openr/commands/top_view.h"
#include "openr/run/interrupt.h"
#include "runtime/base/wall_clock.h"

namespace openr_host {
namespace {

constexpr int64_t kSliceUs = 50'000;  // longest wait for a status, so that Ctrl-C is noticed soon
// Time in microseconds for which --once listens.  It is longer than a second, because each run
// sends its status once a second.
constexpr int64_t kOthersUs = 1'500'000;

struct TopFlags {
  BusOptions bus;
  bool once = false;
  bool json = false;
  int64_t interval_us = 1'000'000;
  int64_t wait_us = 5'000'000;
};

class Top {
 public:
  explicit Top(const TopFlags& flags)
      : flags_(flags), bus_(flags.bus), reader_(&bus_), on_screen_(isatty(STDOUT_FILENO) == 1) {}

  // Prints the table of runs again and again until Ctrl-C.  Returns the exit code.
  int Watch() {
    for (int64_t next_us = flags_.interval_us; interrupts_.count() == 0;
         next_us += flags_.interval_us) {
      while (NowUs() < next_us && interrupts_.count() == 0) Listen();
      runs_.RemoveEnded(Now_s());
      if (interrupts_.count() == 0) Show();
    }
    if (on_screen_ && !flags_.json) PrintPlain("\n");
    return kExitGood;
  }

  // Prints one table of the runs that send their status, and returns the exit code.  Waits for the
  // first run, but not longer than --wait.  Without --run-name, listens for kOthersUs at least,
  // because each run sends its status only once a second.  Throws std::runtime_error if no run is
  // heard.
  int Once() {
    while (runs_.empty() && NowUs() < flags_.wait_us && interrupts_.count() == 0) Listen();
    if (runs_.empty()) return PrintProblem();
    const bool is_one = flags_.bus.run != "*";
    const int64_t until_us = std::max(NowUs(), is_one ? 0 : kOthersUs);
    while (NowUs() < until_us && interrupts_.count() == 0) Listen();
    Show();
    return kExitGood;
  }

 private:
  int64_t NowUs() const { return (WallClockNs() - begin_ns_) / 1000; }
  double Now_s() const { return static_cast<double>(NowUs()) / 1e6; }

  void Listen() {
    bus_.Wait(kSliceUs);
    runs_.Update(reader_.Take(), Now_s());
  }

  // Prints the status of all runs once, as a table or as JSON.  Throws std::runtime_error when
  // standard output cannot be written.
  void Show() {
    if (flags_.json) {
      PrintAnswer(JsonText(TopJson(runs_.All(), Now_s())) + "\n");
    } else {
      PrintAnswerWithCodes(Table());
    }
    FlushAnswer();
  }

  std::string Table() const {
    winsize size{};
    if (on_screen_) ioctl(STDOUT_FILENO, TIOCGWINSZ, &size);
    const size_t rows = size.ws_row > 0 ? size.ws_row : 24;
    const size_t columns = size.ws_col > 0 ? size.ws_col : 80;
    const std::string text = TopText(runs_.All(), Now_s(), on_screen_ ? columns : 0);
    if (on_screen_ && !flags_.once) {
      return fmt::format("\x1b[H{}", OnScreen(text, rows, columns));
    }
    return text + (flags_.once ? "" : "\n");
  }

  int PrintProblem() const {
    const bool is_one = flags_.bus.run != "*";
    throw std::runtime_error(fmt::format(
        "no run{} was heard within {} s in DDS domain {} at {}: a run speaks if objects are placed "
        "in other processes or with --monitor; with --dds-address it is heard at that address",
        is_one ? " '" + flags_.bus.run + "'" : "", static_cast<double>(flags_.wait_us) / 1e6,
        flags_.bus.domain, flags_.bus.address));
  }

  const TopFlags flags_;
  const InterruptCounter interrupts_;
  Bus bus_;
  StatusReader reader_;
  const bool on_screen_;
  const int64_t begin_ns_ = WallClockNs();
  RunStatusList runs_;
};

int RunTop(const TopFlags& flags) {
  Top top(flags);
  return flags.once ? top.Once() : top.Watch();
}

}  // namespace

void AddTopCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command =
      app->add_subcommand("top", "Shows the runs that can be heard: objects, processes, rates");
  auto flags = std::make_shared<TopFlags>();
  flags->bus.run = "*";
  command->add_option("--run-name", flags->bus.run, "Only the run of this name (default: all)");
  command->add_flag("--once", flags->once, "Show them once; exit 1 when there is none");
  AddDurationFlag(command, "--wait", &flags->wait_us,
                  "With --once: how long to listen for the first");
  AddDurationFlag(command, "--interval", &flags->interval_us, "Time from one table to the next");
  command->add_flag("--json", flags->json, "JSON, one line each time");
  AddBusFlags(command, &flags->bus);
  command->callback([flags, exit_code] {
    if (flags->interval_us < 100'000)
      throw CLI::ValidationError("--interval", "less than 100ms; runs speak once a second");
    *exit_code = RunTop(*flags);
  });
}

}  // namespace openr_host
