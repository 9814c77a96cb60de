#include "openr/serve/served_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "openr/decode/decode_message.h"
#include "openr/rewind/saved_files.h"
#include "openr/run/report.h"
#include "openr/run/run_step.h"
#include "runtime/core/stack_report.h"
#include "runtime/core/system.h"
#include "runtime/stick/memory_stick.h"

namespace openr_host {
namespace {

// Returns the findings about a robot that does not boot, one line for each finding.
std::string BootProblem(Simulation* simulation) {
  std::string text = "the robot does not boot";
  for (const Finding& finding : simulation->system().findings().all()) {
    if (finding.severity == Severity::kError) text += "\n" + finding.text;
  }
  return text;
}

}  // namespace

ServedRun::ServedRun(const ServedRunOptions& options)
    : options_(options),
      stick_(options.simulation.stick, options.simulation.robots == 1),
      crash_log_(stick_.crash_log()),
      recorder_(options.record_file, options.payloads),
      simulation_options_(SimulationWith(options)),
      simulation_(MakeSimulation()),
      history_(&system()),
      live_{simulation_.get(), &clock_, &console_, &history_, nullptr, &rewind_},
      recording_(options.record_file) {
  const bool is_refused = options.simulation.strict && system().findings().HasError();
  if (!simulation_->loaded() || is_refused)
    throw std::runtime_error(BootProblem(simulation_.get()));
  prepared_.system = &system();
  prepared_.simulation = simulation_.get();
  prepared_.robots = simulation_->robots();
  standing_.assign(prepared_.robots.size(), StandingMonitor(simulation_->model()));
  view_ = {&prepared_, &standing_, 0};
  if (!recording_.empty()) recorder_.Begin(simulation_.get(), simulation_options_, stick_.name());
  system().trace().AddSink([this](const TraceRecord& record, const Message& message) {
    if (filters_.empty()) return;
    DeliveredMessage seen = Describe(system(), record, message);
    const bool fits = std::any_of(filters_.begin(), filters_.end(),
                                  [&](const MessageFilter& filter) { return filter.Fits(seen); });
    // Stops here if the message fits no filter, so that its content is not copied.  Most messages
    // fit no filter, and the content can be large, such as a camera's image.
    if (!fits) return;
    seen.content = ContentOf(message);
    Keep(std::move(seen));
  });
}

// Returns the options with which the simulation is made: the options that the program which drives
// the run has given, with the stick, the network and the console of this run added.
SimulationOptions ServedRun::SimulationWith(const ServedRunOptions& given) {
  SimulationOptions options = given.simulation;
  options.stick = stick_.folder();
  options.console = [this, echo = given.echo](std::string_view text) {
    if (echo) std::fwrite(text.data(), 1, text.size(), stderr);
    // Uses time 0 for text that images print while they are loaded, because there is no clock yet.
    console_.Add(simulation_ == nullptr ? 0 : system().now_us(), text);
  };
  if (!options.host_network) {
    options.network_filter = [this](int robot, std::unique_ptr<Network>) {
      return clients_.MakeNetwork(robot);
    };
  }
  if (!given.record_file.empty()) recorder_.RecordNetworks(&options);
  return options;
}

// Loads the images, whose constructors may end this process.
std::unique_ptr<Simulation> ServedRun::MakeSimulation() const {
  if (options_.before_loading) options_.before_loading(CrashLogs());
  return std::make_unique<Simulation>(simulation_options_);
}

std::string ServedRun::ForkProblem() const {
  if (options_.simulation.host_network)
    return "it has sockets of this computer (network='host'), which a copy cannot share";
  return is_finished_ ? "it is finished" : "";
}

void ServedRun::Boot() {
  has_booted_ = true;
  system().Boot();
}

// Finds out whether each robot stands.  Does so once in each frame.
void ServedRun::Sample() {
  const int64_t now_us = system().now_us();
  if (now_us / kFrameUs == sampled_us_ / kFrameUs && sampled_us_ >= 0) return;
  sampled_us_ = now_us;
  for (size_t i = 0; i < standing_.size(); ++i)
    standing_[i].Sample(prepared_.robots[i]->body().state(), now_us);
}

void ServedRun::RunUntil(int64_t time_us) {
  RunUntilHolds([] { return false; }, time_us);
}

bool ServedRun::RunUntilHolds(const std::function<bool()>& holds, int64_t time_us) {
  while (system().now_us() < time_us && !system().powered_off()) {
    const int64_t frame_end_us = (system().now_us() / kFrameUs + 1) * kFrameUs;
    system().RunUntil(std::min(frame_end_us, time_us));
    Sample();
    if (holds()) return true;
  }
  return false;
}

void ServedRun::MakeSteps(RunClock::Step step, int count) {
  for (int i = 0; i < count && !system().powered_off(); ++i) {
    const int64_t frame_end_us = (system().now_us() / kFrameUs + 1) * kFrameUs;
    MakeStep(simulation_.get(), step, frame_end_us,
             [this](int64_t time_us) { system().RunOne(time_us); });
    Sample();
  }
}

std::optional<DeliveredMessage> ServedRun::RunUntilMessage(const MessageFilter& filter,
                                                           int64_t time_us) {
  std::optional<DeliveredMessage> found;
  const int sink = system().trace().AddSink([&](const TraceRecord& record, const Message& message) {
    if (found) return;
    DeliveredMessage seen = Describe(system(), record, message);
    if (!filter.Fits(seen)) return;
    seen.content = ContentOf(message);
    found = std::move(seen);
  });
  for (bool goes_on = true; goes_on && !found && !system().powered_off();) {
    const int64_t before_us = system().now_us();
    const uint64_t messages = system().message_count();
    const int64_t frame_end_us = (before_us / kFrameUs + 1) * kFrameUs;
    system().RunOne(std::min(frame_end_us, std::max(time_us, before_us)));
    Sample();
    // The loop goes on if the time has advanced or a message was delivered.  At the time limit,
    // virtual time does not advance any more, but messages that are due exactly at the limit are
    // still delivered.
    goes_on = system().now_us() != before_us || system().message_count() != messages;
  }
  system().trace().RemoveSink(sink);
  return found;
}

// Keeps a message that the program which drives the run watches (Watch()).  Drops the oldest
// messages if there are too many.
void ServedRun::Keep(DeliveredMessage message) {
  watched_bytes_ += message.content.size();
  watched_.push_back(std::move(message));
  while (watched_.size() > kKeptMax || watched_bytes_ > kKeptBytesMax) {
    watched_bytes_ -= watched_.front().content.size();
    watched_.pop_front();
    ++lost_count_;
  }
}

void ServedRun::Watch(const MessageFilter& filter) { filters_.push_back(filter); }

std::string ServedRun::Finish() {
  if (std::exchange(is_finished_, true)) return "";
  system().robot_table().NoteRunEnd(
      {EndKind::kTime, "the program that drives the run has finished it"});
  ReportStacks(&system());
  simulation_->ReportUnusedCosts();
  simulation_->CloseFiles();
  return recording_.empty() ? "" : recorder_.Finish(&system());
}

nlohmann::ordered_json ServedRun::Report() {
  RunFacts facts;
  facts.seed = simulation_options_.seed;
  facts.standing = standing_;
  return MakeReport(simulation_.get(), facts);
}

void ServedRun::BecomeCopy(const std::string& record_file) {
  ProcessFiles files;
  auto folder = std::make_unique<TempFolder>();
  auto* const stick = dynamic_cast<FolderStick*>(system().robot(0).stick.get());
  const std::string root = stick->root();
  const std::string copy = stick->writable() ? folder->path() + "/stick" : root;
  const std::string temporary = folder->path() + "/files";
  std::filesystem::create_directory(temporary);
  if (stick->writable()) {
    std::filesystem::create_directory(copy);
    CopyStick(root, copy);
    stick->set_root(copy);
    // The crash log of the default stick is not on the stick, so the copy goes on with the same
    // file.
    crash_log_ = stick_.is_default() ? crash_log_ : CrashLogOn(copy);
  }
  files.OpenAgain(root, copy, temporary);
  if (!recording_.empty()) recording_ = files.MoveCopy(recording_, record_file);
  files_ = std::move(folder);
}

}  // namespace openr_host
