#include "distribution/remote_handlers.h"

#include <algorithm>
#include <string>

#include "distribution/remote_object.h"
#include "runtime/core/api.h"
#include "runtime/core/system.h"

namespace openr_host {

bool RemoteHandlers::Run(RemoteObject* object, const Message& message) {
  const uint64_t session = connection_->session();
  // Starts the timer before the message for the handler is sent, because the handler may already
  // run before Send() returns.
  const Latency::Timer timer(&latency_, &latency_of_[object->id]);
  Deliver(object, message);
  for (;;) {
    const std::optional<HandlerStop> stop =
        is_free_ ? free_run_->WaitForStop(object) : WaitForStop(object);
    if (!stop) return false;
    if (stop->kind == openr_wire_STOP_DONE) return true;
    if (stop->kind == openr_wire_STOP_READS) {
      ResumeWithLine(object, *stop, session);
    } else {
      ResumeWithReply(object, *stop, session);
    }
    // Returns false if the worker was lost while the master waited for it, even if the worker has
    // been restarted since.
    if (connection_->IsOver(session)) return false;
  }
}

// Sends `message` to the worker, which then runs the handler of this message.
void RemoteHandlers::Deliver(RemoteObject* object, const Message& message) {
  WireArena arena;
  openr_wire_ToWorker to_worker = NewToWorker(openr_wire_TO_WORKER_DELIVER);
  openr_wire_Deliver& deliver = to_worker.body._u.deliver;
  deliver.now_us = resources_->system()->now_us();
  deliver.heap_elsewhere = resources_->HeapOfOtherProcesses(resources_->system(), object->robot);
  // Returns whether the worker has the bytes of a region, so that they need not be sent.  The
  // worker has them if one of its objects has made the region, even if another object owns the
  // region now.  A restarted worker does not have the regions of the lost process; for these,
  // MakerOf() returns kNoObject, because the objects that made them were unloaded.
  const auto is_there = [this](uint32_t region) {
    return resources_->objects().contains(resources_->system()->regions().MakerOf(region));
  };
  resources_->marshaller()->Encode(message, is_there, &arena, &deliver.message);
  connection_->Send(to_worker, is_free_ && WillSendMore());
  resources_->marshaller()->CompleteSend(message);
}

// Returns whether the next message to be delivered goes to an object in a worker.  If so, the
// sample that is about to be sent may wait and share a packet with that message.  If not, no other
// sample follows soon, so the sample must be sent now.
bool RemoteHandlers::WillSendMore() const {
  const Message* const next = resources_->system()->queue().First();
  if (next == nullptr || next->is_reply) return false;
  const auto* const target =
      dynamic_cast<const RemoteObject*>(resources_->system()->object(next->target));
  return target != nullptr && target->delivery().blocked() == nullptr &&
         !target->delivery().is_busy();
}

std::optional<HandlerStop> RemoteHandlers::WaitForStop(RemoteObject* object) {
  for (;;) {
    const RemoteConnection::ReceivedSample to_master = connection_->Next();
    if (effects_->HandleRequest(*to_master)) continue;
    if (to_master->body._d != openr_wire_TO_MASTER_STOPPED)
      connection_->Refuse("something in the middle of a handler");
    if (to_master->body._u.stopped.object != object->id)
      connection_->Refuse("the end of another object's handler");
    return effects_->ApplyStop(*to_master);
  }
}

// Makes `object`, the master's stand-in for an object of the worker, wait for the reply that `stop`
// names, so that other objects run meanwhile.  Then sends the reply to the worker, where the
// handler goes on.
void RemoteHandlers::ResumeWithReply(RemoteObject* object, const HandlerStop& stop,
                                     uint64_t session) {
  openr_wire_ToWorker to_worker = NewToWorker(openr_wire_TO_WORKER_RESUME);
  openr_wire_Resume& resume = to_worker.body._u.resume;
  const OwnedMessage reply = resources_->system()->requests().Await(stop.box, stop.timeout_us,
                                                                    stop.why, &resume.timed_out);
  // Does not go on if the worker was lost while the handler waited for its reply, for example
  // because the handler of another object of this worker crashed.  No handler is left then that
  // could continue.
  if (connection_->IsOver(session)) return;
  WireArena arena;
  resume.now_us = resources_->system()->now_us();
  resume.heap_elsewhere = resources_->HeapOfOtherProcesses(resources_->system(), object->robot);
  resources_->marshaller()->Encode(*reply, nullptr, &arena, &resume.reply);
  resume.reply.target = object->id;
  resume.reply.is_reply = true;
  resume.reply.reply_box = stop.box;
  connection_->Send(to_worker);
}

void RemoteHandlers::ResumeWithLine(RemoteObject* object, const HandlerStop& stop,
                                    uint64_t session) {
  char line[Message::kPayloadMax];
  std::string problem;
  const auto is_gone = [&] {
    if (!connection_->IsOver(session)) problem = connection_->FindProblem();
    return connection_->IsOver(session) || !problem.empty();
  };
  const size_t size = resources_->system()->console_input().Read(
      line, std::min<size_t>(std::max<uint32_t>(stop.size, 1), sizeof line), is_gone);
  if (connection_->IsOver(session)) return;
  if (!problem.empty()) throw ProcessLost(problem);
  WireArena arena;
  openr_wire_ToWorker to_worker = NewToWorker(openr_wire_TO_WORKER_RESUME);
  openr_wire_Resume& resume = to_worker.body._u.resume;
  resume.now_us = resources_->system()->now_us();
  resume.heap_elsewhere = resources_->HeapOfOtherProcesses(resources_->system(), object->robot);
  resume.reply.target = object->id;
  resume.reply.sender = kNoObject;
  resume.reply.is_reply = true;
  resume.reply.reply_box = stop.box;
  resume.reply.payload._d = openr_wire_PAYLOAD_BYTES;
  resume.reply.payload._u.bytes = arena.Bytes(line, size);
  connection_->Send(to_worker);
}

Latency RemoteHandlers::LatencyOf(ObjectId object) const {
  const auto found = latency_of_.find(object);
  return found == latency_of_.end() ? Latency() : found->second;
}

}  // namespace openr_host
