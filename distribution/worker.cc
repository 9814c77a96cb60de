#include "distribution/worker.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "distribution/latency.h"
#include "distribution/liveness_check.h"
#include "distribution/process_slot.h"
#include "distribution/worker_calls.h"
#include "runtime/base/wall_clock.h"
#include "runtime/core/deferred_end.h"
#include "runtime/core/subject_state.h"
#include "runtime/core/system.h"
#include "runtime/ipstack/ant_message.h"
#include "runtime/ipstack/ip_stack.h"

namespace openr_host {
namespace {

constexpr int kMasterPollMs = 100;      // interval of the checks whether the master still exists
constexpr int kGoodbyeFlushMs = 1'000;  // time for the master to receive a goodbye
// Longest time that a crashed process waits until the master has received its report.  The time is
// long, because the process ends afterwards and cannot repeat the report.
constexpr int kCrashFlushMs = 3'000;
// In a free run (the master does not wait for handlers), the worker keeps the effects of earlier
// handlers while a fast handler runs, and then sends all of them in one packet.  A handler is fast
// if it takes less than this time, so that no effect is kept for long.
constexpr int64_t kFastHandlerNs = 50'000;
constexpr int kJoinRetryMs = 1'000;  // time after which a join request is repeated

constexpr char kAbandonedText[] = "the run could not reach it and goes on without";

// Returns the next answer to the requester `id`; the result is empty if none comes within
// kJoinRetryMs.  Drops answers to other requesters, which come on the same channel.
WorkerJoinChannel::ReceivedSample ReceiveAnswerTo(const std::string& id,
                                                  WorkerJoinChannel* channel) {
  const int64_t end_ms = WallClockMs() + kJoinRetryMs;
  for (;;) {
    const int64_t left_ms = std::max<int64_t>(end_ms - WallClockMs(), 0);
    WorkerJoinChannel::ReceivedSample answer = channel->Receive(static_cast<int>(left_ms));
    if (!answer || StringOf(answer->id) == id) return answer;
  }
}

}  // namespace

Worker::Worker(WorkerOptions options) : options_(std::move(options)), bus_(options_.bus) {}

Worker::~Worker() {
  // Sets is_shutting_down_ before the objects are destroyed.  Destructors of the objects' code
  // still post messages and call the SDK.  These calls must not reach the master, so with
  // is_shutting_down_ set Post(), Tell() and Ask() send nothing.
  is_shutting_down_ = true;
  marshaller_.reset();
  system_.reset();  // the destructors of the objects' code run here and may still call this Worker
}

openr_wire_ToMaster Worker::NewToMaster(openr_wire_ToMasterKind kind) {
  openr_wire_ToMaster to_master{};
  to_master.body._d = kind;
  return to_master;
}

void Worker::MoveEffectsTo(openr_wire_ToMaster* to_master) {
  to_master->effects = arena_.Sequence<decltype(to_master->effects)>(effects_);
  effects_.clear();
  parts_in_sample_.clear();
}

Worker::ReceivedSample Worker::Next(bool answer) {
  // Returns no sample if the user has asked this worker to end; the worker then ends.  Goes on
  // while a handler waits for an answer, so that the master gets all effects of this handler.
  if (!answer && IsEndRequested()) return {channel_.get(), nullptr};
  if (!answer && !deferred_.empty()) {
    ReceivedSample sample = std::move(deferred_.front());
    deferred_.pop_front();
    return sample;
  }
  for (;;) {
    ReceivedSample sample = channel_->Receive(kMasterPollMs);
    if (!sample) {
      if (!channel_->IsConnected() || (!answer && IsEndRequested())) return sample;
      continue;
    }
    if (!answer || sample->body._d == openr_wire_TO_WORKER_ANSWER) return sample;
    // Ends this process at once when the master tells it to end, because a handler waits in this
    // function for an answer that will not come.
    if (sample->body._d == openr_wire_TO_WORKER_END) {
      const openr_wire_End& end = sample->body._u.ended;
      ReportRunEnded(end);
      t_current = {};  // makes _exit() end the process and not only the handler
      _exit(end.run_goes_on ? 1 : 0);
    }
    // Keeps the sample until the present handler has ended: in a free run the master does not wait
    // for handlers, so it sends further messages while this handler waits for an answer.
    deferred_.push_back(std::move(sample));
  }
}

// Waits for the other end of `channel`; returns false if that end did not connect in time.
bool Worker::WaitFor(const ChannelBase& channel) const {
  for (int64_t waited_ms = 0; !channel.IsConnected(); waited_ms += 5) {
    if (waited_ms > options_.master_wait_ms || IsEndRequested()) return false;
    usleep(5000);
  }
  return true;
}

std::string Worker::NoRunFound() const {
  return fmt::format("no run '{}' that has a place for process '{}' was found within {} s",
                     options_.bus.run, options_.process, options_.master_wait_ms / 1000);
}

// Asks the master for a session (one life of this worker), whose name is also the name of the
// channel to the master.  A worker that the master has started has the session from the command
// line.  Returns "" or why there is no session.
std::string Worker::RequestSession() {
  session_ = options_.session;
  if (!session_.empty()) return "";
  WorkerJoinChannel join_channel(&bus_, options_.process, ChannelEnd::kWorker, kJoinTopics);
  const std::string id = NewSessionName();
  WireArena arena;
  const openr_wire_JoinRequest request = {openr_wire_VERSION, arena.Text(id),
                                          arena.Text(HostName()), getpid()};
  std::string taken;  // the last refusal, which says that another process has the slot
  for (int64_t waited_ms = 0; waited_ms < options_.master_wait_ms && !IsEndRequested();
       waited_ms += kJoinRetryMs) {
    if (!WaitFor(join_channel)) return NoRunFound();
    // Repeats the request, because the last request may have gone to a run that was ending and did
    // not answer.
    join_channel.Send(request);
    const auto answer = ReceiveAnswerTo(id, &join_channel);
    if (!answer) continue;
    session_ = StringOf(answer->session);
    if (session_ == kTakenSession) {
      if (!options_.waits_for_predecessor) return StringOf(answer->refusal);
      if (taken.empty())
        options_.say(StringOf(answer->refusal) + "; this one waits until it is gone");
      taken = StringOf(answer->refusal);
      usleep(kJoinRetryMs * 1000);
      continue;
    }
    is_refused_ = session_.empty();
    return StringOf(answer->refusal);
  }
  return taken.empty() ? NoRunFound() : taken;
}

std::string Worker::Join() {
  const std::string refusal = RequestSession();
  if (!refusal.empty()) return refusal;
  channel_ = std::make_unique<WorkerChannel>(&bus_, options_.process + "/" + session_,
                                             ChannelEnd::kWorker);
  if (!WaitFor(*channel_)) return NoRunFound();
  openr_wire_ToMaster to_master = NewToMaster(openr_wire_TO_MASTER_HELLO);
  to_master.body._u.hello = {openr_wire_VERSION, arena_.Text(options_.process),
                             arena_.Text(HostName()), getpid(), arena_.Text(MachineId())};
  Send(to_master);
  const ReceivedSample welcome = Next(false);
  if (!welcome) return "the master is gone";
  if (welcome->body._d != openr_wire_TO_WORKER_WELCOME)
    return "the master does not welcome this process";
  return SetUp(welcome->body._u.welcome);
}

std::string Worker::SetUp(const openr_wire_Welcome& welcome) {
  is_refused_ = welcome.version != openr_wire_VERSION;
  if (is_refused_)
    return fmt::format("the master speaks version {}, this is version {}; use the same openr",
                       welcome.version, openr_wire_VERSION);
  SystemOptions options;
  options.seed = welcome.seed;
  options.strict = welcome.strict;
  options.guard_regions = welcome.guard;
  options.measure_stacks = welcome.measure;
  options.log_level = welcome.log_level;
  options.free_deliveries = INT64_MAX;  // sets no limit, because the master counts deliveries
  options.make_calls = [this](System* system) {
    return std::make_unique<WorkerCalls>(system, this);
  };
  options.console = [this](std::string_view text) {
    // Puts off the signal by which the watchdog ends this process when a handler runs too long.
    // The signal must not end the process during a call of Cyclone DDS, because such a call may
    // hold locks that ReportCrash() needs.
    const DeferredEnd deferred_end;
    WireArena arena;
    openr_wire_ToMaster to_master = NewToMaster(openr_wire_TO_MASTER_CONSOLE);
    to_master.body._u.console_text = arena.Text(text);
    Send(to_master);
  };
  is_free_ = welcome.free_running;
  system_ = std::make_unique<System>(std::move(options));
  system_->trace().set_hashing(false);  // computes no hash, because the master has the trace
  marshaller_ = std::make_unique<Marshaller>(system_.get(), true);
  stick_ = options_.stick.empty() ? StringOf(welcome.stick) : options_.stick;
  return "";
}

std::string Worker::Run() {
  std::string problem, goodbye;
  try {
    problem = Join();
    if (problem.empty()) problem = Serve();
  } catch (const std::exception& error) {
    problem = error.what();
    goodbye = "could not go on: " + problem;
  }
  if (IsEndRequested() && !problem.empty()) goodbye = "was ended there";
  // If this worker cannot take part in the run, for instance because its stick is wrong, the
  // goodbye (this worker's last sample) gives the reason for that, even if the user has also asked
  // the worker to end.  After such a goodbye the master waits for another process and does not end
  // the run.
  if (is_refused_) goodbye = "could not take part: " + problem;
  if (!goodbye.empty()) SayGoodbye(goodbye);
  return problem;
}

void Worker::SayGoodbye(const std::string& text) {
  if (channel_ == nullptr || !channel_->IsConnected()) return;
  openr_wire_ToMaster to_master = NewToMaster(openr_wire_TO_MASTER_GOODBYE);
  to_master.body._u.goodbye = {is_refused_, arena_.Text(text)};
  try {
    channel_->Send(to_master);
    channel_->WaitForAcks(kGoodbyeFlushMs);
  } catch (const std::exception&) {
    // Ignores that the message "goodbye" could not be sent, because the master also notices without
    // it that this worker has ended.
  }
}

// Tells the user that an external worker has joined.  Says nothing for a worker that the master has
// started, which has its session from the command line.
void Worker::ReportJoined() {
  if (!options_.session.empty()) return;
  options_.say(fmt::format("has joined run '{}' ({}) with {}", options_.bus.run, MakerOf(session_),
                           fmt::join(own_object_names_, ", ")));
}

void Worker::ReportRunEnded(const openr_wire_End& end) {
  if (end.run_goes_on) {
    options_.say(kAbandonedText);
  } else if (options_.session.empty() && StringOf(end.why) != "") {
    options_.say("the run is over, " + StringOf(end.why));
  }
}

std::string Worker::Serve() {
  for (;;) {
    const ReceivedSample to_worker = Next(false);
    if (!to_worker) return "the master is gone";
    switch (to_worker->body._d) {
      case openr_wire_TO_WORKER_LOAD: {
        const std::string problem = LoadObjects(to_worker->body._u.load);
        if (!problem.empty()) return problem;
        break;
      }
      case openr_wire_TO_WORKER_DELIVER:
        if (!std::exchange(has_reported_joined_, true)) ReportJoined();
        Deliver(to_worker->body._u.deliver, false);
        break;
      case openr_wire_TO_WORKER_RESUME:
        Deliver({to_worker->body._u.resume.now_us, to_worker->body._u.resume.heap_elsewhere,
                 to_worker->body._u.resume.reply},
                to_worker->body._u.resume.timed_out);
        break;
      case openr_wire_TO_WORKER_ASK_STATE:
        SendState(to_worker->body._u.state_of);
        break;
      case openr_wire_TO_WORKER_FORGET:
        Forget(to_worker->body._u.replaced_object);
        break;
      case openr_wire_TO_WORKER_TAKE_BACK:
        TakeBack(to_worker->body._u.take_back);
        break;
      case openr_wire_TO_WORKER_END:
        if (to_worker->body._u.ended.run_goes_on) return kAbandonedText;
        ReportRunEnded(to_worker->body._u.ended);
        return "";
      case openr_wire_TO_WORKER_WELCOME:
      case openr_wire_TO_WORKER_ANSWER:
        return "the master says what was not asked";
    }
  }
}

void Worker::Deliver(const openr_wire_Deliver& deliver, bool timed_out) {
  const int64_t now_us = deliver.now_us;
  const openr_wire_Message& in = deliver.message;
  Object* const object = system_->object(in.target);
  if (object == nullptr) throw std::runtime_error("a message to an object that is not there");
  // Sets the clock of this System to the time of the master's clock, because the handler that runs
  // now reads this System's clock.
  if (now_us > system_->now_us()) system_->RunUntil(now_us);
  OwnedMessage message = system_->queue().Allocate();
  const std::string problem = marshaller_->Decode(in, message.get());
  if (!problem.empty()) throw std::runtime_error("a malformed message: " + problem);
  CheckRobot(object->robot);
  SetHeapOfOtherProcesses(object->robot, deliver.heap_elsewhere);
  TrackSharedBuffers(*object, *message);
  // Marks the message as the end of a wait that has timed out.  Requests::Await() recognises such a
  // message: it is of kind kHashed, and its sender is the object that waits.
  if (timed_out) {
    message->kind = PayloadKind::kHashed;
    message->sender = message->target;
  }
  // Makes the message due at the present time, because the master sends each message to the worker
  // only when the message is due.
  message->due_us = system_->now_us();
  if (!message->is_reply) object->NoteQueued();
  // Removes the wait of the handler that continues with this message.  If the handler waits again,
  // RecordWait() records the new wait.
  waits_.erase(object->id);
  system_->queue().Push(std::move(message), object->limits().priority);
  if (is_free_) {
    RunTimed(object->id);
  } else {
    system_->RunMessages(1);
  }
  marshaller_->ReleaseSample();
  SendStopped(object);
}

// Runs a handler in a free run, and measures whether the handler is fast.  The channel may still
// keep the effects of earlier handlers, to send them in one packet with later effects.  If the
// previous handler of this object was fast, the kept effects wait for the effects of this handler.
// If not, the kept effects are sent before this handler runs, because this handler may be slow,
// too.
void Worker::RunTimed(ObjectId id) {
  if (!fast_objects_.contains(id)) channel_->FlushBatch();
  const int64_t begin_ns = WallClockNs();
  system_->RunMessages(1);
  if (WallClockNs() - begin_ns < kFastHandlerNs) {
    fast_objects_.insert(id);
  } else {
    fast_objects_.erase(id);
  }
}

// Keeps track of the shared buffers of the network stack.  The master's stack creates and destroys
// the buffers.  The stack in this process learns of this from the answers that the master's stack
// sends to objects.
void Worker::TrackSharedBuffers(const Object& object, const Message& message) {
  const Object* const sender = system_->object(message.sender);
  if (sender == nullptr || sender->name != IpStack::kName || message.size < sizeof(antEnvMsg))
    return;
  const auto& ant = *reinterpret_cast<const antEnvMsg*>(message.payload);
  if (ProtocolOf(ant.dstModule) != 0 || ant.dstSelector != Entry_antEnv_External) return;
  const CurrentScope scope(system_.get(), system_->object(object.id));
  SharedBuffers& buffers = IpStack::OfCurrent()->buffers();
  if (ant.dstOperation == antEnv_Operation_CreateSharedBuffer) {
    const auto& create = static_cast<const antEnvCreateSharedBufferMsg&>(ant);
    if (create.error != ANT_SUCCESS) return;
    system_->regions().AdoptOwn(create.buffer.GetRegion(), create.buffer.GetSize(), object.id);
    buffers.Adopt(create.buffer, object.id);
  } else if (ant.dstOperation == antEnv_Operation_DestroySharedBuffer) {
    const auto& destroy = static_cast<const antEnvDestroySharedBufferMsg&>(ant);
    if (destroy.error != ANT_SUCCESS) return;
    system_->regions().RemoveAdopted(destroy.buffer.GetRegion());
    buffers.Forget(destroy.buffer);
  }
}

void Worker::SendStopped(Object* object) {
  openr_wire_ToMaster to_master = NewToMaster(openr_wire_TO_MASTER_STOPPED);
  openr_wire_Stopped& stopped = to_master.body._u.stopped;
  stopped.object = object->id;
  stopped.kind = openr_wire_STOP_DONE;
  stopped.timeout_us = -1;
  // If the handler has not returned, but waits for a reply or for a line of console input, waits_
  // has an entry for the object.  The sample then tells the master what the handler waits for.
  if (const auto found = waits_.find(object->id); found != waits_.end()) {
    stopped.kind = found->second.kind;
    stopped.box = found->second.box;
    stopped.timeout_us = found->second.timeout_us;
    stopped.size = static_cast<uint32_t>(found->second.size);
    stopped.why = WireArena::View(found->second.why.data(), found->second.why.size());
  }
  stopped.state =
      WireArena::View(object->statistics().state().data(), object->statistics().state().size());
  stopped.dropped = object->statistics().dropped_count();
  stopped.stack_max = object->statistics().stack_max();
  if (object->memory().arena() != nullptr)
    stopped.heap_max = object->memory().arena()->bytes_in_use_max();
  stopped.heap_here = HeapOfThisProcess(object->robot);
  stopped.pending = object->CountPending();
  MoveEffectsTo(&to_master);
  // In a free run, keeps the sample for a moment, so that it shares a packet with the sample of the
  // next handler.
  Send(to_master, is_free_);
  // Releases the memory of the sent regions, which is possible because Send() has copied their
  // bytes.
  for (const uint32_t region : pinned_) system_->regions().DropCopy(region);
  pinned_.clear();
  arena_.Clear();
}

void Worker::ReportCrash(std::string_view text) {
  WireArena arena;
  openr_wire_ToMaster to_master = NewToMaster(openr_wire_TO_MASTER_CRASHED);
  to_master.body._u.crashed = {t_current.object == nullptr ? kNoObject : t_current.object->id,
                               arena.Text(text)};
  Send(to_master);
  // Waits until the master has the report, because a lost packet cannot be sent again after the end
  // of this process.
  channel_->WaitForAcks(kCrashFlushMs);
}

void Worker::SendState(ObjectId id) {
  WireArena arena;
  std::string subjects;
  Hasher hasher(&subjects);
  std::vector<openr_wire_RegionBytes> regions;
  if (const Object* const object = system_->object(id)) {
    for (const auto& subject : object->subjects()) subject->HashState(&hasher);
    system_->regions().ForEachOf(id, [&](uint32_t region, char* base, size_t size) {
      regions.push_back({region, WireArena::View(base, size)});
    });
  }
  openr_wire_ToMaster to_master = NewToMaster(openr_wire_TO_MASTER_STATE);
  to_master.body._u.state.subjects = WireArena::View(subjects.data(), subjects.size());
  auto& bytes = to_master.body._u.state.regions;
  bytes = arena.Sequence<std::remove_reference_t<decltype(bytes)>>(regions);
  Send(to_master);
}

// Disconnects the objects of this worker from object `id` of another process, because a new object
// has replaced that object.  The object manager in the master connects them with the new object
// later.
void Worker::Forget(ObjectId id) {
  if (system_->object(id) != nullptr) system_->object_table().DisconnectOthersFrom(id);
  // Forgets which entries object `id` had before it was replaced, because the new object with this
  // id may have other entries.
  std::erase_if(known_entries_, [id](const auto& entry) { return entry.first == id; });
  openr_wire_ToMaster to_master = NewToMaster(openr_wire_TO_MASTER_FORGOTTEN);
  to_master.body._u.forgotten = {id, arena_.Numbers(marshaller_->TakeDroppedTokens())};
  MoveEffectsTo(&to_master);
  Send(to_master);
  arena_.Clear();
}

}  // namespace openr_host
