#include "distribution/remote_connection.h"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "runtime/base/assert.h"

namespace openr_host {
namespace {

// While the master waits for a sample of the worker, it checks at this interval that the worker
// still exists.
constexpr int kWorkerPollMs = 10;
// Time after which the user is told to start an external worker.  A worker that has already been
// started joins in less time, and the user is told nothing.
constexpr int64_t kJoinNoticeMs = 300;
// Time to wait for the last samples of a worker that has ended, because they may still be on their
// way.  One of these samples may be a goodbye, which has the reason of the end.
constexpr int kGoodbyeWaitMs = 50;
constexpr int64_t kShortTimeoutMs = 500;  // time limit for an answer while the run ends

}  // namespace

openr_wire_ToWorker NewToWorker(openr_wire_ToWorkerKind kind) {
  openr_wire_ToWorker to_worker{};
  to_worker.body._d = kind;
  return to_worker;
}

RemoteConnection::RemoteConnection(Bus* bus, std::string name, bool is_external,
                                   std::function<std::string()> health,
                                   std::function<void(const std::string&)> say)
    : name_(std::move(name)),
      health_(std::move(health)),
      say_(std::move(say)),
      slot_(bus, name_, is_external) {}

void RemoteConnection::Rejoin() {
  // Changes the number of the session.  Functions that still wait for the old process see by
  // IsOver() that it has ended.
  ++session_;
  is_lost_ = false;
}

void RemoteConnection::WaitForJoin(int64_t limit_ms, const std::string& advice,
                                   const std::function<bool()>& is_ending) {
  const std::string then = advice.empty() ? "" : "; " + advice;
  for (int64_t waited_ms = 0; !slot_.AwaitJoin(kWorkerPollMs); waited_ms += kWorkerPollMs) {
    if (is_ending())
      throw ProcessLost(
          fmt::format("process '{}' had not come when the run was interrupted", name_));
    const std::string problem = health_();
    if (!problem.empty()) throw ProcessLost(problem);
    if (waited_ms >= limit_ms)
      throw ProcessLost(
          fmt::format("process '{}' did not come within {} s{}", name_, limit_ms / 1000, then));
    if (waited_ms == (advice.empty() ? kSilenceMs : kJoinNoticeMs))
      say_(fmt::format("waiting for process '{}' ({} s){}", name_, limit_ms / 1000, then));
  }
}

void RemoteConnection::Send(const openr_wire_ToWorker& to_worker, bool batched) {
  if (channel() == nullptr) throw ProcessLost(fmt::format("process '{}' is not there", name_));
  try {
    if (batched) return channel()->SendBatched(to_worker);
    channel()->Send(to_worker);
  } catch (const std::runtime_error& error) {
    // The write timed out, or DDS has no memory.  In both cases the worker counts as lost.
    throw ProcessLost(fmt::format("process '{}' (pid {}) takes nothing any more: {}", name_,
                                  identity().pid, error.what()));
  }
}

void RemoteConnection::FlushBatch() {
  if (channel() != nullptr) channel()->FlushBatch();
}

RemoteConnection::ReceivedSample RemoteConnection::Next() {
  bool is_reported = false;
  for (int64_t silent_ms = 0;; silent_ms += kWorkerPollMs) {
    ReceivedSample to_master = channel()->Receive(kWorkerPollMs);
    if (to_master) {
      CheckGoodbye(*to_master);
      if (is_reported) say_(fmt::format("process '{}' answers again", name_));
      return to_master;
    }
    const std::string problem = FindProblem();
    if (!problem.empty()) {
      ReceivedSample late = ReceiveLate();
      if (late) {
        CheckGoodbye(*late);
        return late;
      }
      throw ProcessLost(problem);
    }
    if (has_short_timeout_ && silent_ms >= kShortTimeoutMs)
      throw ProcessLost(
          fmt::format("process '{}' (pid {}) did not answer when the run was brought "
                      "down",
                      name_, identity().pid));
    if (is_reported || silent_ms < kSilenceMs) continue;
    is_reported = true;
    say_(
        fmt::format("process '{}' (pid {}) has not answered for {} s: stopped, or busy; the run "
                    "waits for it",
                    name_, identity().pid, kSilenceMs / 1000));
  }
}

RemoteConnection::ReceivedSample RemoteConnection::ReceiveLate() {
  return channel()->Receive(kGoodbyeWaitMs);
}

void RemoteConnection::CheckGoodbye(const openr_wire_ToMaster& to_master) const {
  if (to_master.body._d != openr_wire_TO_MASTER_GOODBYE) return;
  const openr_wire_Goodbye& goodbye = to_master.body._u.goodbye;
  const std::string text = fmt::format("process '{}' (pid {} on {}) {}", name_, identity().pid,
                                       identity().host, StringOf(goodbye.text));
  if (goodbye.has_refused) throw ProcessRefused(text);
  throw ProcessLost(text);
}

void RemoteConnection::Refuse(const std::string& what) const {
  throw ProcessLost(fmt::format("process '{}' (pid {}) sent {}; is it the same openr?", name_,
                                identity().pid, what));
}

std::string RemoteConnection::FindProblem() const {
  std::string problem = health_();
  if (problem.empty() && slot_.HasEnded())
    problem = fmt::format("process '{}' (pid {} on {}) is not there any more: killed, or ended",
                          name_, identity().pid, identity().host);
  if (problem.empty() && !channel()->IsConnected())
    problem = fmt::format("process '{}' (pid {} on {}) cannot be reached any more", name_,
                          identity().pid, identity().host);
  return problem;
}

std::string RemoteConnection::FindLoss() {
  std::string problem = FindProblem();
  try {
    if (const ReceivedSample last = channel()->Receive(problem.empty() ? 0 : kGoodbyeWaitMs))
      CheckGoodbye(*last);
  } catch (const ProcessLost& lost) {
    return lost.what();
  }
  return problem;
}

bool RemoteConnection::SendEnd(const std::string& why) {
  // Sends nothing if no worker can receive the sample: no worker has joined yet, or a restarted
  // worker has not joined again.
  if (!slot_.has_joined()) return false;
  openr_wire_ToWorker to_worker = NewToWorker(openr_wire_TO_WORKER_END);
  WireArena arena;
  to_worker.body._u.ended = {false, arena.Text(why)};
  try {
    Send(to_worker);
  } catch (const ProcessLost&) {
    is_lost_ = true;
    return false;
  }
  has_sent_end_ = true;
  return true;
}

bool RemoteConnection::AwaitReceipt(int64_t limit_ms) {
  ASSERT(has_sent_end_, "process '{}' was sent no end", name_);
  return channel()->WaitForAcks(static_cast<int>(limit_ms));
}

}  // namespace openr_host
