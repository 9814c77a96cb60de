#include "distribution/process_slot.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>

#include "distribution/latency.h"
#include "runtime/base/assert.h"
#include "runtime/base/wall_clock.h"

namespace openr_host {
namespace {

// Time within which a process must join after it has got a session.  After this time, another
// process that asks to join gets a new session.  So a process that never joins does not keep the
// slot.
constexpr int64_t kSessionClaimMs = 5'000;
// Limit of the length of a requester's id.  A real id, such as "host-1234-5", is far shorter.
// Requests with longer ids are ignored, because they come from the network and may be forged.
constexpr size_t kRequesterIdMax = 256;
constexpr int64_t kLivenessIntervalMs = 100;  // shortest time between two liveness checks
// Largest number of abandoned workers that are remembered; the oldest is forgotten first.  Each of
// them keeps its channel open, so without a limit many losses would leave many open channels.
constexpr size_t kAbandonedMax = 4;

}  // namespace

std::string HostName() {
  char name[256] = {};
  return gethostname(name, sizeof name - 1) == 0 ? name : "";
}

std::string NewSessionName() {
  static int count = 0;
  std::string host = HostName();
  // Removes all characters but letters, digits, '-', '.' and '_' from the host name, because '*'
  // and '?' are wildcards in the name of a DDS partition.
  std::erase_if(host, [](unsigned char c) {
    return std::isalnum(c) == 0 && c != '-' && c != '.' && c != '_';
  });
  return fmt::format("{}-{}-{}", host, getpid(), ++count);
}

std::string MakerOf(const std::string& session) {
  // A session name consists of the host name and the process id of the process that has made it,
  // and the number of session names that this process has made, with '-' between them.  The search
  // for each '-' begins at the end, because a host name may contain '-', too.
  const size_t count = session.rfind('-');
  const size_t pid = count == 0 ? count : session.rfind('-', count - 1);
  if (count == std::string::npos || pid == std::string::npos) return session;
  return fmt::format("pid {} on {}", session.substr(pid + 1, count - pid - 1),
                     session.substr(0, pid));
}

ProcessSlot::ProcessSlot(Bus* bus, std::string process, bool is_external)
    : bus_(bus), process_(std::move(process)) {
  if (is_external)
    join_channel_ =
        std::make_unique<MasterJoinChannel>(bus_, process_, ChannelEnd::kMaster, kJoinTopics);
}

void ProcessSlot::OpenSession(const std::string& session) {
  Abandon();
  // Keeps the identity of the lost process, because the report names the lost process until the
  // next process has sent its Hello.
  previous_ = last_identity();
  identity_ = {};
  ASSERT(!has_joined_ && channel_ == nullptr, "process '{}'", process_);
  channel_ = std::make_unique<MasterChannel>(bus_, process_ + "/" + session, ChannelEnd::kMaster);
}

void ProcessSlot::Abandon() {
  ASSERT(!has_joined_ || channel_ != nullptr, "process '{}' has joined without a channel",
         process_);
  // Keeps the channel to an external worker that is unreachable now, because NotifyAbandoned()
  // later tells the worker through this channel that it was given up.  Workers that the master has
  // started need no notice: they end with the master, or the master kills them.
  if (has_joined_ && join_channel_ != nullptr && !channel_->IsConnected() &&
      !liveness_.HasEnded()) {
    if (abandoned_.size() == kAbandonedMax) abandoned_.erase(abandoned_.begin());
    abandoned_.push_back({std::move(channel_)});
    ASSERT(abandoned_.size() <= kAbandonedMax, "{}", abandoned_.size());
  }
  channel_.reset();
  has_joined_ = false;
}

// Tells abandoned workers (which the master has given up) that the run goes on without them.  A
// worker that was unreachable only for a short time does not know that it was given up.  Without
// this notice, it would wait for work for ever.
void ProcessSlot::NotifyAbandoned() {
  std::erase_if(abandoned_, [](const AbandonedWorker& abandoned) {
    return abandoned.is_notified && !abandoned.channel->IsConnected();
  });
  for (AbandonedWorker& abandoned : abandoned_) {
    if (abandoned.is_notified || !abandoned.channel->IsConnected()) continue;
    openr_wire_ToWorker to_worker{};
    to_worker.body._d = openr_wire_TO_WORKER_END;
    WireArena arena;
    to_worker.body._u.ended = {true, arena.Text("")};
    abandoned.is_notified = true;
    try {
      abandoned.channel->Send(to_worker);
    } catch (const std::runtime_error&) {
      // Ignores an error of the notice to the abandoned worker, for example if this worker can no
      // longer be reached.  The error must not end the other worker, which has the slot now.
    }
  }
}

// Asks the kernel only every kLivenessIntervalMs whether the process still exists, because a fast
// run calls HasEnded() often.
bool ProcessSlot::HasEnded() const {
  if (!has_joined_ || WallClockMs() < next_check_ms_) return false;
  next_check_ms_ = WallClockMs() + kLivenessIntervalMs;
  return liveness_.HasEnded();
}

// Answers one join request.  A requester repeats its request until it has an answer, so a request
// may also be ignored for now.  In this way a second requester waits until the first requester has
// joined or its session has expired.
void ProcessSlot::AnswerJoinRequest(const openr_wire_JoinRequest& request) {
  WireArena arena;
  openr_wire_JoinAnswer answer{};
  const std::string id = StringOf(request.id);
  if (id.size() > kRequesterIdMax) return;
  answer.id = arena.Text(id);
  answer.session = arena.Text("");
  answer.refusal = arena.Text("");
  if (request.version != openr_wire_VERSION) {
    answer.refusal =
        arena.Text(fmt::format("the run speaks version {}, this is version {}; use the "
                               "same openr",
                               openr_wire_VERSION, request.version));
  } else if (is_closed_) {
    answer.refusal = arena.Text(fmt::format("the run goes on without process '{}'", process_));
  } else if (has_joined_ && requester_id_ != id) {
    // Gives no answer now if the joined process has ended.  The requester then repeats its request
    // until the master has noticed the end.  A refusal could make the requester give up, although
    // the slot is about to become free.
    if (liveness_.HasEnded()) return;
    answer.session = arena.Text(kTakenSession);
    answer.refusal = arena.Text(fmt::format("the run has its process '{}' already: pid {} on {}",
                                            process_, identity_.pid, identity_.host));
  } else if (channel_ != nullptr && requester_id_ != id &&
             WallClockMs() - session_opened_ms_ < kSessionClaimMs) {
    // Gives this requester no answer now, because another requester got the session a moment ago.
    // If the other requester does not join soon, this requester gets a session when it repeats its
    // request.
    return;
  } else {
    // If a requester repeats its request, gives it the same session again, so that it does not
    // matter which of the answers the requester receives.
    if (channel_ == nullptr || requester_id_ != id) {
      session_ = NewSessionName();
      OpenSession(session_);
      session_opened_ms_ = WallClockMs();
      requester_id_ = id;
    }
    answer.session = arena.Text(session_);
  }
  join_channel_->Send(answer);
}

void ProcessSlot::AnswerPendingRequests() {
  if (join_channel_ == nullptr) return;
  NotifyAbandoned();
  while (const auto request = join_channel_->Receive(0)) AnswerJoinRequest(*request);
}

bool ProcessSlot::ReceiveHello(int timeout_ms) {
  const auto to_master = channel_->Receive(timeout_ms);
  if (!to_master) return false;
  if (to_master->body._d != openr_wire_TO_MASTER_HELLO)
    throw ProcessLost(fmt::format("process '{}' sent something before its name", process_));
  const openr_wire_Hello& hello = to_master->body._u.hello;
  identity_ = {StringOf(hello.host), hello.pid};
  // Prepares to check by the process id whether an external worker still exists.  A worker that the
  // master has started needs no such check, because the kernel reports the end of a child.
  if (join_channel_ != nullptr) liveness_ = LivenessCheck(StringOf(hello.machine), hello.pid);
  next_check_ms_ = 0;
  if (hello.version != openr_wire_VERSION)
    throw ProcessLost(
        fmt::format("process '{}' (pid {}) speaks version {}, this is version {}; is "
                    "it the same openr?",
                    process_, identity_.pid, hello.version, openr_wire_VERSION));
  return true;
}

// Waits after the worker's Hello until the channel is connected in both directions.  DDS may find
// the worker's writer before its reader, and a sample that is sent before DDS finds the reader is
// lost.
bool ProcessSlot::AwaitJoin(int timeout_ms) {
  if (has_joined_) return true;
  if (join_channel_ != nullptr) {
    if (const auto request = join_channel_->Receive(channel_ == nullptr ? timeout_ms : 0))
      AnswerJoinRequest(*request);
    AnswerPendingRequests();
  }
  if (channel_ == nullptr) return false;
  if (identity_.pid == 0 && !ReceiveHello(timeout_ms)) return false;
  for (int waited_ms = 0; !channel_->IsConnected(); ++waited_ms) {
    if (waited_ms >= timeout_ms) return false;
    usleep(1000);
  }
  return has_joined_ = true;
}

}  // namespace openr_host
