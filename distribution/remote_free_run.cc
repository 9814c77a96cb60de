#include "distribution/remote_free_run.h"

#include <fmt/format.h>

#include <utility>

#include "distribution/remote_object.h"
#include "runtime/base/assert.h"
#include "runtime/base/wall_clock.h"
#include "runtime/core/api.h"
#include "runtime/core/system.h"

namespace openr_host {

RemoteFreeRun::RemoteFreeRun(RemoteConnection* connection, RemoteResources* resources,
                             RemoteEffects* effects)
    : connection_(connection),
      resources_(resources),
      effects_(effects),
      wait_reason_(fmt::format("its handler in process '{}'", connection->name())) {}

std::optional<HandlerStop> RemoteFreeRun::WaitForStop(RemoteObject* object) {
  const uint64_t session = connection_->session();
  const uint64_t box = kFirstWakeBox + ++wake_box_count_;
  object->boxes().OpenApart(box);
  // Measures the worker's silence from now on, because the worker gets work now and an idle worker
  // sends nothing.
  if (running_.empty()) last_heard_ms_ = WallClockMs();
  const bool is_new = running_.emplace(object->id, box).second;
  ASSERT(is_new, "{} runs a handler already", object->name);
  // Lets other objects wait for a reply of `object` without a time limit, until this handler ends.
  // Their time-outs are in virtual time, and virtual time says nothing about the wall time that the
  // worker needs (Requests::Call()).  During DoStop and DoDestroy the time-outs count, because the
  // end of a run has a time limit that no worker may extend.
  const uint32_t selector = object->running()->selector;
  object->wait().set_untimed(selector != oentrySTOP && selector != oentryDESTROY);
  bool timed_out = false;
  resources_->system()->requests().Await(box, -1, wait_reason_, &timed_out);
  if (connection_->IsOver(session)) return std::nullopt;
  HandlerStop stop = std::move(stops_[object->id]);
  stops_.erase(object->id);
  return stop;
}

size_t RemoteFreeRun::CountUndelivered() const {
  size_t count = 0;
  for (const auto& [id, box] : running_) {
    const Message& message = *resources_->objects().at(id)->running();
    const bool is_bytes =
        message.kind != PayloadKind::kNotify && message.kind != PayloadKind::kReady;
    if (id != loss_.crashed_object && is_bytes && message.selector > oentryDESTROY) ++count;
  }
  return count;
}

// Calls `action`.  If `action` throws ProcessLost, keeps the reason in loss_ and does not pass the
// exception on.  WorkerGroup reads loss() later and handles the loss.
template <typename Action>
void RemoteFreeRun::RecordLoss(const Action& action) {
  try {
    action();
  } catch (const ProcessCrashed& crash) {
    loss_ = {crash.what(), true, crash.object};
  } catch (const ProcessLost& lost) {
    loss_.why = lost.what();
  }
}

bool RemoteFreeRun::HandleReceived() {
  bool came = false;
  RecordLoss([this, &came] {
    while (const RemoteConnection::ReceivedSample to_master = connection_->channel()->Receive(0)) {
      came = true;
      HandleSample(*to_master);
      // Ends the loop after the samples that have already been read from DDS.  The next call of
      // HandleReceived() handles samples that arrive during this call, so that a busy worker cannot
      // keep the master in this loop.
      if (!connection_->channel()->has_received()) break;
    }
  });
  if (!came) return false;
  last_heard_ms_ = WallClockMs();
  if (std::exchange(is_silent_, false))
    connection_->Say(fmt::format("process '{}' answers again", connection_->name()));
  return true;
}

// Tells the user if the worker has work but has sent nothing for kSilenceMs.
void RemoteFreeRun::ReportSilence() {
  if (running_.empty() || is_silent_ || WallClockMs() - last_heard_ms_ < kSilenceMs) return;
  is_silent_ = true;
  connection_->Say(
      fmt::format("process '{}' (pid {}) has not answered for {} s: stopped, or busy; the others "
                  "go on",
                  connection_->name(), connection_->identity().pid, kSilenceMs / 1000));
}

void RemoteFreeRun::CheckHealth() {
  ReportSilence();
  RecordLoss([this] {
    const std::string problem = connection_->FindProblem();
    if (problem.empty()) return;
    if (const RemoteConnection::ReceivedSample late = connection_->ReceiveLate())
      return HandleSample(*late);  // a goodbye has a more exact reason than `problem`
    throw ProcessLost(problem);
  });
}

void RemoteFreeRun::HandleSample(const openr_wire_ToMaster& to_master) {
  connection_->CheckGoodbye(to_master);
  if (effects_->HandleRequest(to_master)) return;
  if (to_master.body._d == openr_wire_TO_MASTER_FORGOTTEN)
    return effects_->ApplyForgotten(to_master);
  if (to_master.body._d != openr_wire_TO_MASTER_STOPPED)
    connection_->Refuse("something that is no end of a handler");
  const ObjectId object = to_master.body._u.stopped.object;
  const auto found = running_.find(object);
  if (found == running_.end()) connection_->Refuse("the end of a handler that was not begun");
  stops_[object] = effects_->ApplyStop(to_master);
  resources_->Wake(object, found->second);
  resources_->ObjectOf(object)->wait().set_untimed(false);
  running_.erase(object);
}

void RemoteFreeRun::ForgetHandlers() {
  for (const auto& [id, box] : running_) resources_->ObjectOf(id)->wait().set_untimed(false);
  running_.clear();
  stops_.clear();
  is_silent_ = false;
}

}  // namespace openr_host
