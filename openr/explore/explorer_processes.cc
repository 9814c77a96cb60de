#include "openr/explore/explorer_processes.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "cli/json_text.h"
#include "cli/process_copy.h"
#include "openr/ending/end_guards.h"
#include "runtime/base/assert.h"
#include "runtime/core/address_plan.h"

namespace openr_host {
namespace {

using Json = nlohmann::ordered_json;

constexpr char kReady[] = "ready";
// Time slice of the second run of each seed, which must have the same result as the first run
// although it is advanced in other slices.  The slice is no multiple of a frame, so that slices end
// inside frames.
constexpr int64_t kOddSliceUs = 50'021;

void SilenceOutput() {
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere < 0) return;
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  close(nowhere);
}

// Sends `line` to the process at the other end of `channel`.  Returns false if the other end is
// closed.
bool Send(int channel, const std::string& line) {
  for (size_t done = 0; done < line.size();) {
    const ssize_t size = send(channel, line.data() + done, line.size() - done, MSG_NOSIGNAL);
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return false;
    done += static_cast<size_t>(size);
  }
  return true;
}

// Takes all free blocks of the heap that begin before `end`, and never gives them back.  So later
// blocks lie behind `end`, at other addresses than in other processes.  Takes large blocks first,
// because otherwise malloc() would cut small blocks out of them.
void UseUpFreeBlocks(const void* end) {
  constexpr size_t kLargest = 1 << 20, kSmall = 1024, kStep = 16;
  constexpr int kBlocksMax = 100'000;
  for (size_t size = kLargest; size > 0; size = size > kSmall ? size / 2 : size - kStep) {
    for (int i = 0; i < kBlocksMax; ++i) {
      const void* volatile block = malloc(size);
      if (block == nullptr || std::greater_equal<const void*>()(block, end)) break;
    }
  }
}

// Makes this process allocate memory at other addresses than processes that do not call this
// function.  The explorer makes the same run in processes of both kinds.  If the run depends on
// addresses, the hashes of the two runs differ, and the user learns about it.
void MoveMemory() {
  UseOtherAddresses();
  constexpr size_t kHoleBytes = (96 << 20) + 7 * 4096;
  mmap(nullptr, kHoleBytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  // Makes a hole at the end of the heap that malloc() does not know.  The next memory for malloc()
  // lies behind the hole, so later blocks have other addresses than in other processes.
  const void* const heap_end = sbrk(13 * 4096 + 16);
  if (heap_end == reinterpret_cast<void*>(-1))
    return;  // sbrk() has failed, so the heap stays where it is
  static void* volatile hole = malloc(4099);
  (void)hole;
  UseUpFreeBlocks(heap_end);
}

bool AreEqual(const Json& one, const Json& other) {
  return one.value("state", "") == other.value("state", "") &&
         one.value("trace", "") == other.value("trace", "");
}

// Runs plans (descriptions of runs in JSON) in copies of this process.  A plan that has "twice":
// true is also run in the process `elsewhere`, which has other memory addresses, to find out
// whether the run depends on addresses.
class PlanServer {
 public:
  PlanServer(PreparedRun prepared, const RunOptions& options, const ForkLimits& limits,
             ExplorerProcesses* elsewhere)
      : server_(std::move(prepared), options, limits), elsewhere_(elsewhere) {}

  Json Run(const Json& plan) {
    Json answer = server_.Run(plan);
    if (!plan.value("twice", false) || answer.contains("problem")) return answer;
    Json again = {{"seed", plan.at("seed")}, {"slice_us", kOddSliceUs}, {"blind", true}};
    if (answer.contains("time_us")) again["until_us"] = answer["time_us"];
    const Json other = elsewhere_->RunOne(again);
    const bool differs = !AreEqual(answer, other);
    // Makes a third run, with the addresses of the first run.  The third run shows whether the
    // first two runs differ only because of the addresses.
    const Json here = differs ? server_.Run(again) : answer;
    const bool differs_here = !AreEqual(answer, here);
    // A run that was killed has no hashes.  How long a run takes depends on the machine, so such a
    // run does not count as a difference.
    const bool is_compared =
        !answer.contains(kNotEnded) && !other.contains(kNotEnded) && !here.contains(kNotEnded);
    answer["not_compared"] = !is_compared;
    answer["differs"] = is_compared && differs_here;
    answer["depends_on_addresses"] = is_compared && differs && !differs_here;
    return answer;
  }

 private:
  ForkServer server_;
  ExplorerProcesses* const elsewhere_;
};

// Reads the plan of a run (its seed and schedule) from each line that comes through `channel`,
// makes this run, and sends the answer as a line, until the other end of `channel` is closed.
void Serve(PlanServer* server, int channel) {
  std::string heard;
  char buffer[65536];
  for (;;) {
    const ssize_t size = read(channel, buffer, sizeof buffer);
    if (size < 0 && errno == EINTR) continue;
    if (size <= 0) return;
    heard.append(buffer, static_cast<size_t>(size));
    const size_t end = heard.find('\n');
    if (end == std::string::npos) continue;
    const Json plan = ParseJson<Json>(heard.substr(0, end));
    heard.erase(0, end + 1);
    if (!Send(channel, JsonText(server->Run(plan)) + "\n")) return;
  }
}

}  // namespace

struct ExplorerProcesses::Job {
  const PrepareRun& prepare_run;
  const RunOptions& options;
  const ForkLimits& limits;
  bool twice;
  Memory memory;
  int outer_channel;

  // Does the work of one child process.  Returns at the end instead of calling _exit(), so that the
  // destructor of the prepared run removes the folder with the copies of the images.
  void Work(int channel) const;
  PreparedRun Prepare(int channel) const;
};

// Assembles the run.  If a constructor of an image ends this process, sends the reason to the
// process at the other end of `channel`.
PreparedRun ExplorerProcesses::Job::Prepare(int channel) const {
  const auto send = [channel](Ending* ending) {
    const std::string problem = std::string(ending->record.text()) + DescribeEnd(EndOf(*ending));
    Send(channel, JsonText(Json{{"problem", problem}}) + "\n");
  };
  const EndGuards guards({.answer_first = send, .handler_limit_us = limits.handler_us});
  return prepare_run();
}

void ExplorerProcesses::Job::Work(int channel) const try {
  SilenceOutput();
  std::unique_ptr<ExplorerProcesses> elsewhere;
  if (twice) {
    elsewhere = std::make_unique<ExplorerProcesses>(prepare_run, options, limits, 1, false,
                                                    Memory::kElsewhere, channel);
  }
  if (memory == Memory::kElsewhere) MoveMemory();
  PreparedRun prepared = Prepare(channel);
  if (!prepared.problem.empty()) throw std::runtime_error(prepared.problem);
  PlanServer server(std::move(prepared), options, limits, elsewhere.get());
  Send(channel, JsonText(Json(kReady)) + "\n");
  Serve(&server, channel);
} catch (const std::exception& error) {
  Send(channel, JsonText(Json{{"problem", error.what()}}) + "\n");
}

ExplorerProcesses::ExplorerProcesses(const PrepareRun& prepare_run, const RunOptions& options,
                                     const ForkLimits& limits, int count, bool twice, Memory memory,
                                     int outer_channel) {
  ASSERT(count >= 1, "count={}", count);
  for (int i = 0; i < count; ++i)
    Start({prepare_run, options, limits, twice, memory, outer_channel});
  for (Child& child : children_) {
    const Json hello = ParseJson<Json>(WaitForLine(&child));
    if (hello != kReady)
      throw std::runtime_error(hello.value("problem", "a process of the explorer is lost"));
  }
}

ExplorerProcesses::~ExplorerProcesses() {
  for (const Child& child : children_) close(child.channel);
  for (const Child& child : children_) WaitForEnd(child.pid);
}

void ExplorerProcesses::Start(const Job& job) {
  int channel[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, channel) != 0) {
    throw std::runtime_error("no channel to a process of the explorer");
  }
  const pid_t pid = CopyProcess(Flushed::kAll, Orphan::kGoesOn);
  if (pid < 0) throw std::runtime_error(fmt::format("cannot fork: {}", std::strerror(errno)));
  if (pid == 0) {
    close(channel[0]);
    // Closes the inherited sockets that lead to the other child processes.  While this process kept
    // such a socket open, the other child would not notice the end of the explorer.
    for (const Child& other : children_) close(other.channel);
    if (job.outer_channel >= 0) close(job.outer_channel);
    job.Work(channel[1]);
    EndCopy();
  }
  close(channel[1]);
  Child child;
  child.pid = pid;
  child.channel = channel[0];
  children_.push_back(std::move(child));
}

std::optional<std::string> ExplorerProcesses::ReadLine(Child* child) {
  char buffer[65536];
  const ssize_t size = recv(child->channel, buffer, sizeof buffer, MSG_DONTWAIT);
  if (size < 0 && (errno == EINTR || errno == EAGAIN)) return {};
  if (size <= 0) throw std::runtime_error("a process of the explorer has ended before its work");
  child->heard.append(buffer, static_cast<size_t>(size));
  const size_t end = child->heard.find('\n');
  if (end == std::string::npos) return {};
  std::string line = child->heard.substr(0, end);
  child->heard.erase(0, end + 1);
  return line;
}

std::string ExplorerProcesses::WaitForLine(Child* child) {
  for (;;) {
    pollfd wanted = {child->channel, POLLIN, 0};
    poll(&wanted, 1, -1);
    if (auto line = ReadLine(child)) return *line;
  }
}

void ExplorerProcesses::Run(const std::function<std::optional<Json>()>& next,
                            const std::function<void(size_t, Json)>& take) {
  size_t number = 0;
  const auto give_plan = [&](Child* child) {
    const std::optional<Json> plan = next();
    child->is_busy = plan.has_value();
    if (!plan) return;
    child->number = number++;
    if (!Send(child->channel, JsonText(*plan) + "\n")) {
      throw std::runtime_error("a process of the explorer has ended before its work");
    }
  };
  for (Child& child : children_) give_plan(&child);
  while (std::any_of(children_.begin(), children_.end(), [](const auto& w) { return w.is_busy; })) {
    std::vector<pollfd> wanted;
    for (const Child& child : children_) {
      wanted.push_back({child.is_busy ? child.channel : -1, POLLIN, 0});
    }
    if (poll(wanted.data(), wanted.size(), -1) < 0) continue;
    for (size_t i = 0; i < children_.size(); ++i) {
      if (wanted[i].revents == 0) continue;
      const auto line = ReadLine(&children_[i]);
      if (!line) continue;
      Json answer = ParseJson<Json>(*line);
      if (answer.contains("problem")) throw std::runtime_error(answer["problem"]);
      take(children_[i].number, std::move(answer));
      give_plan(&children_[i]);
    }
  }
}

Json ExplorerProcesses::RunOne(const Json& plan) {
  Json result;
  bool asked = false;
  Run(
      [&]() -> std::optional<Json> {
        if (std::exchange(asked, true)) return {};
        return plan;
      },
      [&](size_t, Json answer) { result = std::move(answer); });
  return result;
}

}  // namespace openr_host
