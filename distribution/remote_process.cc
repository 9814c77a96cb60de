#include "distribution/remote_process.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "distribution/remote_object.h"
#include "runtime/base/assert.h"
#include "runtime/base/wall_clock.h"
#include "runtime/core/api.h"
#include "runtime/core/connection_state.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

// Time for a worker to receive the sample that ends it.  A busy machine may not run it for seconds.
constexpr int kEndFlushMs = 5'000;
// First number of the reply boxes in which the master's objects get a reply when a handler in a
// worker has stopped in a free run.  The boxes that objects open count from 1 and never get so
// large, so the two kinds of boxes stay different.
constexpr uint64_t kFirstWakeBox = uint64_t{1} << 40;

}  // namespace

RemoteProcess::RemoteProcess(Bus* bus, std::string name, bool is_external,
                             std::function<std::string()> health,
                             std::function<void(const std::string&)> say)
    : connection_(bus, std::move(name), is_external, std::move(health), std::move(say)),
      wait_reason_(fmt::format("its handler in process '{}'", connection_.name())) {}

// Returns whether the next message to be delivered goes to an object in a worker.  If so, the
// sample that is about to be sent may wait and share a packet with that message.  If not, no other
// sample follows soon, so the sample must be sent now.
bool RemoteProcess::WillSendMore() const {
  const Message* const next = resources_.system()->queue().First();
  if (next == nullptr || next->is_reply) return false;
  const auto* const target =
      dynamic_cast<const RemoteObject*>(resources_.system()->object(next->target));
  return target != nullptr && target->delivery.blocked() == nullptr && !target->delivery.is_busy();
}

void RemoteProcess::Welcome(System* system, const openr_wire_Welcome& welcome) {
  resources_.Begin(system);
  openr_wire_ToWorker to_worker = NewToWorker(openr_wire_TO_WORKER_WELCOME);
  to_worker.body._u.welcome = welcome;
  connection_.Send(to_worker);
}

void RemoteProcess::BeginLoad(const openr_wire_Load& load) {
  openr_wire_ToWorker to_worker = NewToWorker(openr_wire_TO_WORKER_LOAD);
  to_worker.body._u.load = load;
  awaited_objects_.clear();
  for (uint32_t i = 0; i < load.objects._length; ++i) {
    if (load.objects._buffer[i].is_own) awaited_objects_.insert(load.objects._buffer[i].id);
  }
  connection_.Send(to_worker);
}

void RemoteProcess::Load(const openr_wire_Load& load) {
  BeginLoad(load);
  while (!HandleLoaded(*connection_.Next(), resources_.objects())) {
  }
}

bool RemoteProcess::HasLoaded(const std::map<ObjectId, RemoteObject*>& objects) {
  while (const RemoteConnection::ReceivedSample to_master = connection_.channel()->Receive(0)) {
    if (HandleLoaded(*to_master, objects)) return true;
  }
  const std::string problem = connection_.FindProblem();
  if (!problem.empty()) throw ProcessLost(problem);
  return false;
}

bool RemoteProcess::HandleLoaded(const openr_wire_ToMaster& to_master,
                                 const std::map<ObjectId, RemoteObject*>& objects) {
  connection_.CheckGoodbye(to_master);
  if (effects_.HandleRequest(to_master)) return false;
  if (to_master.body._d != openr_wire_TO_MASTER_LOADED)
    connection_.Refuse("no list of its objects");
  effects_.Apply(to_master, nullptr);
  const auto& loaded = to_master.body._u.loaded.objects;
  for (uint32_t i = 0; i < loaded._length; ++i) {
    const openr_wire_LoadedObject& entry = loaded._buffer[i];
    const auto found = objects.find(entry.id);
    if (found == objects.end() || awaited_objects_.erase(entry.id) == 0)
      connection_.Refuse("an object that is not its own, or sent it twice");
    if (entry.problem != nullptr && *entry.problem != '\0') throw ProcessLost(entry.problem);
    found->second->SetDescription(entry);
    resources_.RecordHeap(found->second->robot, entry.heap_here);
  }
  if (!awaited_objects_.empty()) connection_.Refuse("nothing of an object that it was to load");
  return true;
}

bool RemoteProcess::RunHandler(RemoteObject* object, const Message& message) {
  const uint64_t session = connection_.session();
  // Starts the timer before the message for the handler is sent, because the handler may already
  // run before Send() returns.
  const Latency::Timer timer(&latency_, &latency_of_[object->id]);
  {
    WireArena arena;
    openr_wire_ToWorker to_worker = NewToWorker(openr_wire_TO_WORKER_DELIVER);
    openr_wire_Deliver& deliver = to_worker.body._u.deliver;
    deliver.now_us = resources_.system()->now_us();
    deliver.heap_elsewhere = resources_.HeapElsewhere(resources_.system(), object->robot);
    // Returns whether the worker has the bytes of a region, so that they need not be sent.  The
    // worker has them if one of its objects has made the region, even if another object owns the
    // region now.  A restarted worker does not have the regions of the lost process; for these,
    // MakerOf() returns kNoObject, because the objects that made them were unloaded.
    const auto is_there = [this](uint32_t region) {
      return resources_.objects().contains(resources_.system()->regions().MakerOf(region));
    };
    resources_.marshaller()->Encode(message, is_there, &arena, &deliver.message);
    connection_.Send(to_worker, is_free_ && WillSendMore());
    resources_.marshaller()->CompleteSend(message);
  }
  for (;;) {
    const std::optional<HandlerStop> stop =
        is_free_ ? WaitForStopInFreeRun(object) : WaitForStop(object);
    if (!stop) return false;
    if (stop->kind == openr_wire_STOP_DONE) return true;
    if (stop->kind == openr_wire_STOP_READS) {
      ResumeWithLine(object, *stop, session);
    } else {
      ResumeWithReply(object, *stop, session);
    }
    // Returns false if the worker was lost while the master waited for it, even if the worker has
    // been restarted since.
    if (connection_.IsOver(session)) return false;
  }
}

std::optional<HandlerStop> RemoteProcess::WaitForStop(RemoteObject* object) {
  for (;;) {
    const RemoteConnection::ReceivedSample to_master = connection_.Next();
    if (effects_.HandleRequest(*to_master)) continue;
    if (to_master->body._d != openr_wire_TO_MASTER_STOPPED)
      connection_.Refuse("something in the middle of a handler");
    if (to_master->body._u.stopped.object != object->id)
      connection_.Refuse("the end of another object's handler");
    return effects_.ApplyStop(*to_master);
  }
}

// Waits in a free run (the master does not wait for handlers) until the handler of `object` in the
// worker has stopped.  Only `object` waits: other objects run meanwhile.  HandleFreeSample() ends
// the wait when the worker reports that the handler has stopped.  Returns nullopt if the worker was
// lost.
std::optional<HandlerStop> RemoteProcess::WaitForStopInFreeRun(RemoteObject* object) {
  const uint64_t session = connection_.session();
  const uint64_t box = kFirstWakeBox + ++wake_box_count_;
  object->boxes.open.insert(box);
  // Measures the worker's silence from now on, because the worker gets work now and an idle worker
  // sends nothing.
  if (running_.empty()) last_heard_ms_ = WallClockMs();
  const bool is_new = running_.emplace(object->id, box).second;
  ASSERT(is_new, "{} runs a handler already", object->name);
  bool timed_out = false;
  resources_.system()->requests().Await(box, -1, wait_reason_, &timed_out);
  if (connection_.IsOver(session)) return std::nullopt;
  HandlerStop stop = std::move(stops_[object->id]);
  stops_.erase(object->id);
  return stop;
}

// Calls `action`.  If `action` throws ProcessLost, keeps the reason in loss_ and does not pass the
// exception on.  WorkerGroup reads loss() later and handles the loss.
template <typename Action>
void RemoteProcess::RecordLoss(const Action& action) {
  try {
    action();
  } catch (const ProcessCrashed& crash) {
    loss_ = crash.what();
    crashed_ = true;
    crashed_object_ = crash.object;
  } catch (const ProcessLost& lost) {
    loss_ = lost.what();
  }
}

bool RemoteProcess::HandleReceived() {
  bool came = false;
  RecordLoss([this, &came] {
    while (const RemoteConnection::ReceivedSample to_master = connection_.channel()->Receive(0)) {
      came = true;
      HandleFreeSample(*to_master);
      // Ends the loop after the samples that have already been read from DDS.  The next call of
      // HandleReceived() handles samples that arrive during this call, so that a busy worker cannot
      // keep the master in this loop.
      if (!connection_.channel()->has_received()) break;
    }
  });
  if (!came) return false;
  last_heard_ms_ = WallClockMs();
  if (std::exchange(is_silent_, false))
    connection_.Say(fmt::format("process '{}' answers again", connection_.name()));
  return true;
}

// Tells the user if the worker has work but has sent nothing for kSilenceMs.
void RemoteProcess::ReportSilence() {
  if (running_.empty() || is_silent_ || WallClockMs() - last_heard_ms_ < kSilenceMs) return;
  is_silent_ = true;
  connection_.Say(
      fmt::format("process '{}' (pid {}) has not answered for {} s: stopped, or busy; the others "
                  "go on",
                  connection_.name(), connection_.identity().pid, kSilenceMs / 1000));
}

void RemoteProcess::CheckHealth() {
  ReportSilence();
  RecordLoss([this] {
    const std::string problem = connection_.FindProblem();
    if (problem.empty()) return;
    if (const RemoteConnection::ReceivedSample last = connection_.ReceiveLast())
      return HandleFreeSample(*last);  // the worker's goodbye tells more than `problem`
    throw ProcessLost(problem);
  });
}

void RemoteProcess::HandleFreeSample(const openr_wire_ToMaster& to_master) {
  connection_.CheckGoodbye(to_master);
  if (effects_.HandleRequest(to_master)) return;
  if (to_master.body._d == openr_wire_TO_MASTER_FORGOTTEN)
    return effects_.ApplyForgotten(to_master);
  if (to_master.body._d != openr_wire_TO_MASTER_STOPPED)
    connection_.Refuse("something that is no end of a handler");
  const ObjectId object = to_master.body._u.stopped.object;
  const auto found = running_.find(object);
  if (found == running_.end()) connection_.Refuse("the end of a handler that was not begun");
  stops_[object] = effects_.ApplyStop(to_master);
  resources_.Wake(object, found->second);
  running_.erase(object);
}

// Makes `object`, the master's stand-in for an object of the worker, wait for the reply that `stop`
// names, so that other objects run meanwhile.  Then sends the reply to the worker, where the
// handler goes on.
void RemoteProcess::ResumeWithReply(RemoteObject* object, const HandlerStop& stop,
                                    uint64_t session) {
  openr_wire_ToWorker to_worker = NewToWorker(openr_wire_TO_WORKER_RESUME);
  openr_wire_Resume& resume = to_worker.body._u.resume;
  const OwnedMessage reply =
      resources_.system()->requests().Await(stop.box, stop.timeout_us, stop.why, &resume.timed_out);
  // Does not go on if the worker was lost while the handler waited for its reply, for example
  // because the handler of another object of this worker crashed.  No handler is left then that
  // could continue.
  if (connection_.IsOver(session)) return;
  WireArena arena;
  resume.now_us = resources_.system()->now_us();
  resume.heap_elsewhere = resources_.HeapElsewhere(resources_.system(), object->robot);
  resources_.marshaller()->Encode(*reply, nullptr, &arena, &resume.reply);
  resume.reply.target = object->id;
  resume.reply.is_reply = true;
  resume.reply.reply_box = stop.box;
  connection_.Send(to_worker);
}

void RemoteProcess::ResumeWithLine(RemoteObject* object, const HandlerStop& stop,
                                   uint64_t session) {
  char line[Message::kPayloadMax];
  std::string problem;
  const auto is_gone = [&] {
    if (!connection_.IsOver(session)) problem = connection_.FindProblem();
    return connection_.IsOver(session) || !problem.empty();
  };
  const size_t size = resources_.system()->console_input().Read(
      line, std::min<size_t>(std::max<uint32_t>(stop.size, 1), sizeof line), is_gone);
  if (connection_.IsOver(session)) return;
  if (!problem.empty()) throw ProcessLost(problem);
  WireArena arena;
  openr_wire_ToWorker to_worker = NewToWorker(openr_wire_TO_WORKER_RESUME);
  openr_wire_Resume& resume = to_worker.body._u.resume;
  resume.now_us = resources_.system()->now_us();
  resume.heap_elsewhere = resources_.HeapElsewhere(resources_.system(), object->robot);
  resume.reply.target = object->id;
  resume.reply.sender = kNoObject;
  resume.reply.is_reply = true;
  resume.reply.reply_box = stop.box;
  resume.reply.payload._d = openr_wire_PAYLOAD_BYTES;
  resume.reply.payload._u.bytes = arena.Bytes(line, size);
  connection_.Send(to_worker);
}

std::string RemoteProcess::FetchState(ObjectId object) {
  if (is_free_) return "";  // in a free run the object runs on, so there is no state to return
  openr_wire_ToWorker to_worker = NewToWorker(openr_wire_TO_WORKER_ASK_STATE);
  to_worker.body._u.state_of = object;
  connection_.Send(to_worker);
  const RemoteConnection::ReceivedSample to_master = connection_.Next();
  if (to_master->body._d != openr_wire_TO_MASTER_STATE) connection_.Refuse("no state");
  const openr_wire_State& state = to_master->body._u.state;
  for (uint32_t i = 0; i < state.regions._length; ++i) {
    const openr_wire_RegionBytes& in = state.regions._buffer[i];
    // Does not copy the worker's bytes of a region that the master has received in a notification
    // and not given back.  An observer may have changed the region, so the master's copy may be
    // newer than the worker's.
    if (resources_.marshaller()->HasImported(in.region)) continue;
    char* const base = resources_.system()->regions().BaseOf(in.region);
    if (base == nullptr || in.bytes._length != resources_.system()->regions().SizeOf(in.region))
      connection_.Refuse(fmt::format("bytes of region {:#x}, which is not so", in.region));
    if (!resources_.calls()->HasRegion(in.region))
      connection_.Refuse(fmt::format("bytes of region {:#x}, which is not its own", in.region));
    std::copy_n(in.bytes._buffer, in.bytes._length, reinterpret_cast<uint8_t*>(base));
  }
  return StringOf(state.subjects);
}

void RemoteProcess::End(const std::string& why) {
  resources_.End();
  // Returns if there is no worker, or if a restarted worker has not joined yet.
  if (!connection_.slot().has_joined()) return;
  openr_wire_ToWorker to_worker = NewToWorker(openr_wire_TO_WORKER_END);
  WireArena arena;
  to_worker.body._u.ended = {false, arena.Text(why)};
  try {
    connection_.Send(to_worker);
    connection_.channel()->WaitForAcks(kEndFlushMs);
  } catch (const ProcessLost&) {
    connection_.set_lost();
  }
}

}  // namespace openr_host
