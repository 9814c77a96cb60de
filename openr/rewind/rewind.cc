#include "openr/rewind/rewind.h"

#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <exception>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "cli/json_text.h"
#include "cli/process_copy.h"
#include "openr/rewind/branch_network.h"
#include "openr/rewind/message_pipe.h"
#include "openr/simulation/simulation.h"
#include "runtime/base/assert.h"
#include "runtime/base/read_file.h"
#include "runtime/base/wall_clock.h"
#include "runtime/core/system.h"
#include "runtime/stick/memory_stick.h"

namespace openr_host {
namespace {

using PlainJson = nlohmann::json;

// The least distance between two checkpoints in virtual time.
constexpr int64_t kDistanceUs = 1'500'000;
// The least distance between two checkpoints by the clock of this computer.
constexpr int64_t kDistanceNs = 300'000'000;

// The largest amount of memory, in bytes, that all checkpoints may take together.  If they take
// more, old checkpoints are dropped.
constexpr size_t kMemoryMax = size_t{1} << 30;

// The largest number of bytes of files that a checkpoint may copy from the Memory Stick.
constexpr size_t kStickBytesMax = size_t{64} << 20;

// The longest time that a view, the process that shows a past moment, may need to reach this
// moment.
constexpr int kViewTimeoutMs = 60'000;

// Returns the memory of process `process` in bytes.  Memory that several processes share is divided
// equally between them.
size_t MemoryOf(pid_t process) {
  std::istringstream words(ReadFile(fmt::format("/proc/{}/smaps_rollup", process)).value_or(""));
  for (std::string word; words >> word;) {
    size_t kilobytes = 0;
    if (word == "Pss:" && words >> kilobytes) return kilobytes << 10;
  }
  return 0;
}

double RewindSeconds(int64_t time_us) { return static_cast<double>(time_us) / 1e6; }

}  // namespace

Rewind::Rewind() = default;

Rewind::~Rewind() {
  for (Checkpoint& checkpoint : checkpoints_) Drop(&checkpoint);
}

System& Rewind::system() const { return parts_.simulation->system(); }

std::unique_ptr<Network> Rewind::WrapNetwork(int robot, std::unique_ptr<Network> inner) {
  ASSERT(networks_.size() == static_cast<size_t>(robot));
  auto network = std::make_unique<BranchNetwork>(std::move(inner), robot, &log_);
  networks_.push_back(network.get());
  return network;
}

void Rewind::Begin(RewindParts parts) {
  parts_ = std::move(parts);
  // Keeps no inputs of a run that cannot be rewound, because nothing would drop them, and they
  // would take more and more memory.
  if (!parts_.no_rewind_reason.empty()) return log_.Disable();
  auto* const stick = dynamic_cast<FolderStick*>(system().robot(0).stick.get());
  if (stick != nullptr) {
    stick->OnFirstChange([this, stick](const MemoryStick::Location& location) {
      original_files_.Save(std::filesystem::path(location.path).lexically_relative(stick->root()),
                           location.path);
    });
  }
  system().inputs().OnAdd([this](int robot, std::string_view line) {
    if (is_view_ || parts_.known != nullptr) return;
    LoggedInput input;
    input.robot = robot;
    input.line = line;
    input.time_us = system().now_us();
    input.messages = system().message_count();
    log_.Add(std::move(input));
  });
}

bool Rewind::AfterFrame(bool is_watched) {
  if (!parts_.no_rewind_reason.empty() || shows_past()) return false;
  if (!is_watched || !trouble_.empty()) {
    for (Checkpoint& checkpoint : checkpoints_) Drop(&checkpoint);
    checkpoints_.clear();
    log_.DropBefore(log_.end());
    return false;
  }
  const int64_t now_ns = WallClockNs();
  const bool is_far =
      checkpoints_.empty() || system().now_us() - checkpoints_.back().time_us >= kDistanceUs;
  if (!is_far || now_ns < next_ns_) return false;
  // Makes the next checkpoint at least kDistanceNs later by the clock of this computer.  Without
  // this limit, a run at full speed would spend most of its time on forks, because it passes
  // kDistanceUs of virtual time very quickly.
  next_ns_ = now_ns + kDistanceNs;
  if (MakeCheckpoint()) return true;
  if (!checkpoints_.empty()) DropOld();
  return false;
}

// Makes a checkpoint of the run, a copy of this process.  Returns false in the original run.
// Returns again, with true, in a branch: a copy of the run that goes on as a run of its own.
bool Rewind::MakeCheckpoint() {
  auto* const stick = dynamic_cast<FolderStick*>(system().robot(0).stick.get());
  ASSERT(stick != nullptr);
  const SavedStick saved = SaveWrittenFiles(stick);
  if (std::max(saved.bytes(), original_files_.bytes()) > kStickBytesMax) {
    trouble_ = "objects have written more than 64 MiB to the stick";
    return false;
  }
  ProcessFiles files;
  const SocketPair sockets;
  // Does not flush the files of objects, because that would change what objects read.  So the copy
  // has the unwritten bytes, too.  These bytes do not come twice into a file, because a view, the
  // copy that shows a past moment, opens the files of objects again with descriptors of its own
  // (ProcessFiles).
  const pid_t process = CopyProcess(Flushed::kOwn, Orphan::kIsKilled);
  if (process == 0) {
    close(sockets.first);
    Wait(sockets.second, saved, &files);
    return true;
  }
  close(sockets.second);
  if (process < 0) {
    trouble_ = fmt::format("the process cannot be copied: {}", std::strerror(errno));
    close(sockets.first);
    return false;
  }
  checkpoints_.push_back(
      {process, sockets.first, system().now_us(), system().message_count(), log_.end()});
  return false;
}

void Rewind::Drop(Checkpoint* checkpoint) {
  close(checkpoint->socket);
  kill(checkpoint->process, SIGKILL);
  WaitForEnd(checkpoint->process);
}

// Drops the checkpoints that are older than the span to which the run can go back.  Drops every
// second checkpoint if they take too much memory.
void Rewind::DropOld() {
  UpdateMemory();
  const int64_t begin_us = system().now_us() - parts_.span_us;
  // Keeps the last checkpoint that is not later than `begin_us`, the earliest moment to which the
  // run can go back, because a view of this moment is made from that checkpoint.
  while (checkpoints_.size() > 1 && checkpoints_[1].time_us <= begin_us) {
    Drop(&checkpoints_.front());
    checkpoints_.pop_front();
  }
  const bool is_too_much = memory_bytes_ > kMemoryMax || log_.is_full();
  if (is_too_much && checkpoints_.size() > 2) {
    for (size_t i = 0; i + 1 < checkpoints_.size(); ++i) {
      Drop(&checkpoints_[i]);
      checkpoints_.erase(checkpoints_.begin() + static_cast<ptrdiff_t>(i));
    }
    // Makes UpdateMemory() measure at its next call, because the last result counts the checkpoints
    // that were dropped here.
    memory_ns_ = 0;
  }
  log_.DropBefore(checkpoints_.front().log_end);
}

// Measures the memory of all checkpoints, at most once a second.
void Rewind::UpdateMemory() {
  const int64_t now_ns = WallClockNs();
  if (now_ns - memory_ns_ < 1'000'000'000 && memory_ns_ != 0) return;
  memory_ns_ = now_ns;
  memory_bytes_ = 0;
  for (const Checkpoint& checkpoint : checkpoints_) memory_bytes_ += MemoryOf(checkpoint.process);
}

const std::string& Rewind::RewindProblem() const {
  if (!parts_.no_rewind_reason.empty()) return parts_.no_rewind_reason;
  return trouble_.empty() ? refusal_ : trouble_;
}

nlohmann::ordered_json Rewind::Status() {
  const std::string& why = RewindProblem();
  nlohmann::ordered_json status = {{"possible", why.empty()},
                                   {"why", why},
                                   {"from_s", nullptr},
                                   {"to_s", RewindSeconds(system().now_us())},
                                   {"checkpoints", checkpoints_.size()},
                                   {"memory_mb", memory_bytes_ >> 20},
                                   {"shows_s", nullptr},
                                   {"message", nullptr}};
  if (!checkpoints_.empty()) status["from_s"] = RewindSeconds(checkpoints_.front().time_us);
  if (shows_past()) {
    status["shows_s"] = RewindSeconds(shown_us_);
    status["message"] = shown_messages_;
  }
  return status;
}

Rewind::Checkpoint* Rewind::LastBefore(int64_t time_us, uint64_t messages) {
  Checkpoint* last = nullptr;
  for (Checkpoint& checkpoint : checkpoints_) {
    if (checkpoint.time_us <= time_us && checkpoint.messages <= messages) last = &checkpoint;
  }
  return last;
}

std::string Rewind::ShowTime(int64_t time_us) {
  if (time_us > system().now_us())
    return fmt::format("t={:.3f} s is in the future", RewindSeconds(time_us));
  return Show(LastBefore(time_us, UINT64_MAX), {{"time_us", time_us}});
}

std::string Rewind::ShowMessage(uint64_t count) {
  if (count > system().message_count())
    return fmt::format("there have been only {} messages", system().message_count());
  return Show(LastBefore(INT64_MAX, count), {{"messages", count}});
}

// Shows the moment `target` of the run.  `checkpoint` is the last checkpoint before this moment.
// Returns "" or an error.
std::string Rewind::Show(Checkpoint* checkpoint, const PlainJson& target) {
  if (!RewindProblem().empty()) return "this run cannot be rewound: " + RewindProblem();
  if (checkpoint == nullptr)
    return checkpoints_.empty() ? "there is no checkpoint yet; checkpoints are taken while a "
                                  "client watches the run"
                                : fmt::format("the first checkpoint is of t={:.3f} s",
                                              RewindSeconds(checkpoints_.front().time_us));
  // Keeps the present view, the process that shows a past moment, only if the new moment is later,
  // because a view can only go forward.
  const bool is_later =
      checkpoint == shown_ && (target.contains("time_us") ? target["time_us"] >= shown_us_
                                                          : target["messages"] >= shown_messages_);
  PlainJson request = {{"show", target}};
  if (!is_later) {
    LeaveView();
    request["inputs"] = ToJson(log_.From(checkpoint->log_end));
    request["files"] = original_files_.ToJson();
  }
  std::optional<PlainJson> answer;
  if (SendMessage(checkpoint->socket, request))
    answer = ReceiveMessage(checkpoint->socket, kViewTimeoutMs);
  if (!answer || answer->contains("error")) {
    const std::string why = answer ? answer->at("error") : "its process has ended or hangs";
    LeaveView();
    return fmt::format("the moment cannot be shown: {}", why);
  }
  shown_ = checkpoint;
  shown_us_ = answer->at("time_us");
  shown_messages_ = answer->at("messages");
  return "";
}

// Ends the view of a past moment, a process that a checkpoint has made.  The process of the
// checkpoint then waits for its next request.
void Rewind::LeaveView() {
  if (shown_ == nullptr) return;
  SendMessage(shown_->socket, {{"leave", true}});
  ReceiveMessage(shown_->socket, kViewTimeoutMs);
  shown_ = nullptr;
}

void Rewind::ShowPresent() { LeaveView(); }

nlohmann::ordered_json Rewind::Forward(const PlainJson& request) {
  ASSERT(shows_past());
  std::optional<PlainJson> answer;
  if (SendMessage(shown_->socket, {{"answer", request}}))
    answer = ReceiveMessage(shown_->socket, kViewTimeoutMs);
  if (!answer) return {{"error", "the process that shows the past has ended or hangs"}};
  if (answer->contains("error")) return {{"error", answer->at("error")}};
  return ParseJson<nlohmann::ordered_json>(answer->at("line").get<std::string>());
}

nlohmann::ordered_json Rewind::Branch(double rate) {
  if (!shows_past()) return {{"error", "no earlier moment is shown from which to go on"}};
  // Closes the ports of this run, because the branch, the copy of the run that goes on in its
  // place, opens the same ports.
  for (BranchNetwork* const network : networks_) network->Forget();
  std::optional<PlainJson> answer;
  if (SendMessage(shown_->socket, {{"branch", rate}}))
    answer = ReceiveMessage(shown_->socket, kViewTimeoutMs);
  if (!answer || answer->contains("error")) {
    const std::string why = answer ? answer->at("error") : "its process has ended or hangs";
    LeaveView();
    for (BranchNetwork* const network : networks_) network->GoOn();
    return {{"error", "the run cannot go on from there: " + why}};
  }
  branch_ = answer->at("process");
  branch_parent_ = shown_->process;
  // Closes only the socket of the checkpoint that is shown.  Does not call Drop() for this
  // checkpoint, because Drop() would end its process.  This process is the parent of the branch: it
  // waits for the branch and ends with the exit code of the branch, which WaitForBranch() then
  // returns.
  close(shown_->socket);
  for (Checkpoint& checkpoint : checkpoints_) {
    if (&checkpoint != shown_) Drop(&checkpoint);
  }
  checkpoints_.clear();
  shown_ = nullptr;
  return {{"run", answer->at("run")}, {"files", answer->at("files")}};
}

int Rewind::WaitForBranch(const std::function<int()>& interrupts) {
  constexpr useconds_t kIntervalUs = 20'000;
  ASSERT(has_branched());
  // Ignores signals of the terminal, because the terminal also sends them to the branch, the
  // process that goes on in place of this run.
  for (const int signal : {SIGINT, SIGHUP}) ::signal(signal, SIG_IGN);
  int status = 0, passed = 0;
  while (waitpid(branch_parent_, &status, WNOHANG) == 0) {
    const int count = interrupts();
    if (count > passed) kill(branch_, SIGTERM);
    passed = count;
    usleep(kIntervalUs);
  }
  return ExitCodeOf(status);
}

}  // namespace openr_host
