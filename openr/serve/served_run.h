// ServedRun: a run that another program controls.  The run goes on only when this program requests
// it, and only as far as the request says.
//
// Everything that the program does to the run enters as an input or through the network of the
// robot.  Both are recorded, so `openr replay` repeats the run.
#pragma once

#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "openr/explore/prepared_run.h"
#include "openr/explore/property.h"
#include "openr/inspect/recorder.h"
#include "openr/live/console_log.h"
#include "openr/live/live_context.h"
#include "openr/live/message_history.h"
#include "openr/live/run_clock.h"
#include "openr/rewind/rewind.h"
#include "openr/serve/message_filter.h"
#include "openr/serve/robot_client.h"
#include "openr/simulation/run_stick.h"
#include "openr/simulation/simulation.h"
#include "openr/simulation/standing.h"
#include "runtime/base/temp_folder.h"

namespace openr_host {

struct ServedRunOptions {
  SimulationOptions simulation;  // options; ServedRun itself sets console, network and stick folder
  std::string record_file;       // file for a recording; "": no recording
  bool payloads = true;          // whether the recording has the bytes of messages
  bool echo = false;             // whether to print on standard error what objects print
  // A function that is called once, before the images are loaded, with the files for crash records
  // (ServedRun::CrashLogs()); may be empty.
  std::function<void(const std::vector<std::string>& crash_logs)> before_loading = nullptr;
};

class ServedRun {
 public:
  // Makes the simulation, ready for Boot().  Throws std::runtime_error if the simulation cannot be
  // made or if the robot would not boot.
  explicit ServedRun(const ServedRunOptions& options);

  Simulation& simulation() { return *simulation_; }
  System& system() { return simulation_->system(); }
  const RunView& view() const { return view_; }
  const LiveContext& live() const { return live_; }
  const ConsoleLog& console() const { return console_; }
  bool is_recorded() const { return !recording_.empty(); }
  // Returns the path of the file for crash records of each robot.
  std::vector<std::string> CrashLogs() const {
    return std::vector<std::string>(static_cast<size_t>(options_.simulation.robots), crash_log_);
  }
  RobotClients& clients() { return clients_; }
  // Returns the reason why the run cannot be copied by a fork; "" if it can be copied.
  std::string ForkProblem() const;
  bool has_booted() const { return has_booted_; }

  void Boot();

  // Lets the run go on to the virtual time `time_us`, but not beyond the end of the run.
  void RunUntil(int64_t time_us);
  // Lets the run go on for `count` steps (frames or messages), but not beyond the end of the run.
  void MakeSteps(RunClock::Step step, int count);
  // Lets the run go on until `holds` returns true after a frame.  Returns false if this has not
  // happened until `time_us`.
  bool RunUntilHolds(const std::function<bool()>& holds, int64_t time_us);
  // Lets the run go on until a message that fits `filter` has been handled, and returns this
  // message.  Returns nullopt if no such message came until `time_us`.
  std::optional<DeliveredMessage> RunUntilMessage(const MessageFilter& filter, int64_t time_us);

  // The largest number of messages that Watch() keeps.
  static constexpr size_t kKeptMax = 10'000;
  // The largest number of bytes that the contents of all kept messages have together.
  static constexpr size_t kKeptBytesMax = size_t{64} << 20;
  // Keeps the messages that fit `filter` from now on.  If there are too many messages, keeps only
  // the newest.
  void Watch(const MessageFilter& filter);
  std::deque<DeliveredMessage> TakeWatched() {
    watched_bytes_ = 0;
    return std::exchange(watched_, {});
  }
  uint64_t lost_count() const { return lost_count_; }

  // Ends the run, and completes the recording and the files of devices.  Returns "", or the error
  // that happened.
  std::string Finish();
  bool is_finished() const { return is_finished_; }
  // Returns the report of the run, in the form in which openr run writes it.
  nlohmann::ordered_json Report();

  // Gives this process, which is a fork, copies of its own of the stick and of files that the run
  // writes.  The recording goes on in `record_file`; if that is "", this process records nothing.
  // Throws std::exception if the copies cannot be made.
  void BecomeCopy(const std::string& record_file);

 private:
  SimulationOptions SimulationWith(const ServedRunOptions& options);
  std::unique_ptr<Simulation> MakeSimulation() const;
  void Sample();
  void Keep(DeliveredMessage message);

  const ServedRunOptions options_;
  const RunStick stick_;
  std::string crash_log_;
  ConsoleLog console_;
  Recorder recorder_;
  // A Rewind that makes no checkpoints, because Begin() is never called.  It is here because live_
  // needs a Rewind.  A client of `openr serve` goes back in another way, by copies of this process.
  Rewind rewind_;
  RunClock clock_{0};
  RobotClients clients_;
  const SimulationOptions simulation_options_;
  std::unique_ptr<Simulation> simulation_;
  MessageHistory history_;
  LiveContext live_;
  PreparedRun prepared_;
  std::vector<StandingMonitor> standing_;
  RunView view_;
  int64_t sampled_us_ = -1;
  std::vector<MessageFilter> filters_;
  std::deque<DeliveredMessage> watched_;
  size_t watched_bytes_ = 0;  // number of bytes in the contents of `watched_`
  // Number of watched messages that were dropped to make room for newer messages.
  uint64_t lost_count_ = 0;
  std::unique_ptr<TempFolder> files_;  // a fork's copies of the stick and of written files
  std::string recording_;              // path of the file to which the recording is written now
  bool has_booted_ = false;
  bool is_finished_ = false;
};

}  // namespace openr_host
