// The restart of a lost worker: a new process takes the slot of the worker, and the worker's
// objects begin anew.
//
// Each call of AdvanceRestart() does one step.  In lockstep (the master waits for each handler),
// all restarts are completed at the beginning of the next frame, a multiple of 8 ms of virtual
// time.  The run stands still meanwhile, so a restart takes no virtual time and happens at the same
// instant in every run.
#include <fmt/format.h>
#include <unistd.h>

#include <stdexcept>

#include "distribution/latency.h"
#include "distribution/worker_group.h"
#include "runtime/base/assert.h"
#include "runtime/base/wall_clock.h"
#include "runtime/core/system.h"

namespace openr_host {
namespace {

constexpr int64_t kCrashRecordMs = 5'000;  // time for a crashed process to write its crash record
constexpr int64_t kRetryPauseMs = 1'000;   // pause after a failed restart
constexpr int64_t kSlowStageMs = 2'000;    // time in one stage after which the user is told
// The pause between two steps of restarts in lockstep (the master waits for each handler).  It is
// short, because the run stands still until the restarts are complete.
constexpr int kRestartPollUs = 1'000;

}  // namespace

// Returns whether the worker may be restarted.  A worker may be restarted as often as --restart
// says.  In a free run an external worker (started by a user) may also join again at any time,
// because the run goes on without the worker.
bool WorkerGroup::MayRestart(const Member& member) const {
  return member.restarts_left > 0 || (member.is_external && options_.is_free);
}

void WorkerGroup::EnterStage(Member* member, Stage stage) {
  // Checks that `stage` may follow the present stage of the worker's restart.  kCleaningUp may
  // follow any stage, because the worker can be lost in each stage.  Every other stage may follow
  // only one particular stage.
  const Stage before = member->stage;
  ASSERT(stage == Stage::kCleaningUp || (stage == Stage::kRunning && before == Stage::kReplacing) ||
             (stage == Stage::kNotRestarted && before == Stage::kCleaningUp) ||
             (stage == Stage::kJoining && before == Stage::kCleaningUp) ||
             (stage == Stage::kLoading && before == Stage::kJoining) ||
             (stage == Stage::kReplacing && before == Stage::kLoading),
         "process '{}': stage {} after {}", member->name, static_cast<int>(stage),
         static_cast<int>(before));
  member->stage = stage;
  member->since_ms = WallClockMs();
  member->is_reported = false;
}

// Posts a task that removes what the objects of a lost worker still have in the master: time
// events, network connections, registered names and regions (System::EndAllOf()).  The System runs
// the task when no message is due.  So messages to these objects that are due now come first, and
// are counted as undelivered.
void WorkerGroup::CleanUp(Member* member) {
  member->is_cleaned_up = false;
  member->undelivered_before = 0;
  for (const auto& [id, object] : member->objects)
    member->undelivered_before += object->undelivered_count;
  EnterStage(member, Stage::kCleaningUp);
  system_->PostTask([this, member] {
    for (const auto& [id, object] : member->objects) system_->object_table().EndAllOf(id);
    member->is_cleaned_up = true;
  });
}

// Advances the restart of one worker by a step.  `may_load` says whether the worker may load its
// images now.  AdvanceRestarts() lets only one worker load at a time, so that objects are loaded in
// the same order in every run.  In lockstep a run that is ending restarts nothing, because it would
// have to wait for the worker.
void WorkerGroup::AdvanceRestart(Member* member, bool may_load) {
  RemoteProcess& process = *member->process;
  if (IsEnding() && !options_.is_free && member->stage != Stage::kRunning) return;
  try {
    switch (member->stage) {
      case Stage::kRunning:
      case Stage::kNotRestarted:
        process.connection().slot().AnswerPendingRequests();
        return;
      case Stage::kCleaningUp:
        Restart(member);
        return;
      case Stage::kJoining:
        if (!process.connection().slot().AwaitJoin(0)) break;
        if (may_load) BeginLoading(member);
        return;
      case Stage::kLoading:
        if (HasLoadedAll(member)) ReplaceObjects(member);
        break;
      case Stage::kReplacing:
        return;
    }
    CheckRestart(member);
  } catch (const std::runtime_error& error) {  // the new process was lost or could not be started
    if (!IsInterrupted()) FailAttempt(member, error.what());
  }
}

// Throws ProcessLost if the restarted process has ended or has not finished its present stage in
// time (--join-wait).  Tells the user if the stage takes long.
void WorkerGroup::CheckRestart(Member* member) {
  if (member->child != nullptr && !member->child->EndText().empty())
    throw ProcessLost(member->child->EndText());
  // Does not limit the time of an external worker in a free run, because the run goes on while the
  // worker joins.
  if (member->stage == Stage::kJoining && member->is_external && options_.is_free) return;
  const int64_t waited_ms = WallClockMs() - member->since_ms;
  if (waited_ms > options_.wait_ms)
    throw ProcessLost(fmt::format("process '{}' did not come back within {} s", member->name,
                                  options_.wait_ms / 1000));
  if (member->is_reported || waited_ms < kSlowStageMs) return;
  member->is_reported = true;
  options_.say(
      fmt::format("process '{}' has not come back for {} s: not started, stopped, or busy; it has "
                  "{} s (--join-wait)",
                  member->name, kSlowStageMs / 1000, options_.wait_ms / 1000));
}

// Deletes the new stand-ins for the objects of a restarted worker, if the object table has not
// taken them yet.  The old stand-ins act for the objects again.
void WorkerGroup::DropNewObjects(Member* member) {
  if (member->new_objects.empty()) return;
  member->process->resources().Replace(member->objects);
  member->new_objects.clear();
  member->successors.clear();
}

// Gives up this attempt to restart the worker, because of `why`.  Goes back to stage kCleaningUp,
// so that Restart() tries again or gives the worker up.
void WorkerGroup::FailAttempt(Member* member, const std::string& why) {
  options_.say(why);
  member->lost = why;
  if (!member->new_objects.empty()) {
    // Ends what the constructors in the new process have made, because the next attempt runs
    // constructors again.
    member->process->ReleaseAll();
    for (const auto& [id, object] : member->objects) system_->object_table().EndAllOf(id);
  }
  DropNewObjects(member);
  member->process->connection().slot().Abandon();
  member->attempt_failed = true;
  EnterStage(member, Stage::kCleaningUp);
}

// Ends the old process of the lost worker if it still runs, and starts a new process.  A new
// external worker is not started here, but by its user.  If the worker may not be restarted, only
// closes its slot, so that no process can join.
void WorkerGroup::Restart(Member* member) {
  if (!member->is_cleaned_up || !system_->booted()) return;
  if (member->attempt_failed && WallClockMs() - member->since_ms < kRetryPauseMs) return;
  if (member->child != nullptr && member->child->EndText().empty()) {
    // Gives a crashed process time to write its crash record on the Memory Stick, before the
    // process is killed.
    if (member->crashed && WallClockMs() - member->since_ms < kCrashRecordMs) return;
    member->child.reset();  // kills the old process, which was unreachable or stopped
  }
  if (!MayRestart(*member)) {
    if (options_.restarts > 0)
      options_.say(fmt::format("process '{}' is not started again: it was {} times", member->name,
                               options_.restarts));
    member->process->connection().slot().Close();
    EnterStage(member, Stage::kNotRestarted);
    return;
  }
  if (member->restarts_left > 0) --member->restarts_left;
  ASSERT(member->restarts_left >= 0, "process '{}'", member->name);
  if (!member->is_external) Start(member);
  member->attempt_failed = false;
  EnterStage(member, Stage::kJoining);
}

// Sends a restarted worker, which has joined, the settings of the run and the entries of the
// master's tables of robots and objects up to the first object of the worker.  The new stand-ins
// act for the objects from now on, but keep what the constructors do until they are in the place of
// the old stand-ins (EarlyWork).
void WorkerGroup::BeginLoading(Member* member) {
  // Sets the counts of sent robots and objects to 0, because the new process has received none.
  member->robots_sent = member->objects_sent = 0;
  member->new_objects.clear();
  member->successors.clear();
  for (const auto& [id, object] : member->objects) {
    member->new_objects.push_back(object->NewInstance());
    RemoteObject* const fresh = member->new_objects.back().get();
    fresh->KeepEarlyWork({});
    fresh->delivery().set_busy(true);  // keeps the messages of the constructors in the outbox
    member->successors[id] = fresh;
  }
  member->process->resources().Replace(member->successors);
  Welcome(member);
  WireArena arena;
  member->process->loader().BeginLoad(NextLoadFor(member, &arena));
  EnterStage(member, Stage::kLoading);
}

// Returns whether a restarted worker has loaded all its objects.  If it has loaded the last one
// that it was sent, sends the entries up to its next object.
bool WorkerGroup::HasLoadedAll(Member* member) {
  RemoteLoader& loader = member->process->loader();
  if (!loader.HasLoaded(member->successors)) return false;
  if (HasSentAll(*member)) return true;
  WireArena arena;
  loader.BeginLoad(NextLoadFor(member, &arena));
  return false;
}

// Tells the object table to replace the master's old stand-ins for the worker's objects by the new
// stand-ins.  The table calls OnReplaced() for each object that it has replaced.
void WorkerGroup::ReplaceObjects(Member* member) {
  std::vector<std::unique_ptr<Object>> new_objects;
  for (auto& object : member->new_objects) {
    // Keeps the time events of the constructors apart, because a message that is due before the
    // replacement would go to the old stand-in.
    EarlyWork work = object->TakeEarlyWork();
    work.events = system_->time_events().TakeOf(object->id);
    object->KeepEarlyWork(std::move(work));
    new_objects.push_back(std::move(object));
  }
  member->new_objects.clear();
  EnterStage(member, Stage::kReplacing);
  system_->object_table().PostReplacement(std::move(new_objects));
}

// Handles the replacement of object `id`.  First the other workers drop the connections of their
// objects to the object that was replaced.  If `id` was the last object of a restarted worker, the
// worker counts as running again.
void WorkerGroup::OnReplaced(ObjectId id) {
  for (auto& [name, member] : members_) {
    // Skips workers that have no connections to the object that was replaced: the worker of object
    // `id`, which is a new process and knows only the new object; workers that have not joined the
    // run; and lost workers.
    if (member.objects.contains(id) || !member.is_welcomed || member.process->is_lost()) continue;
    try {
      member.process->Forget(id);
    } catch (const ProcessLost& lost) {
      HandleLoss(member.objects.begin()->second, RemoteObject::Loss::kGone, lost.what());
    }
  }
  for (auto& [name, member] : members_) {
    if (member.stage != Stage::kReplacing || !member.successors.contains(id)) {
      // Removes the readies of the replaced object from the stand-ins of this member, because the
      // new object asserts ready anew.  Does so also if these stand-ins will be replaced later,
      // because their successors get their readies.
      for (const auto& [other, object] : member.objects) object->ForgetObserver(id);
      continue;
    }
    // This member is the restarted worker of object `id`.  Its stand-ins may have readies of the
    // old object `id`.  We do not call ForgetObserver() to remove these readies, because they have
    // no effect: ObjectManager::ReplaceAndBoot() does not send a ready again if both its sender and
    // its receiver are replaced.  ForgetObserver() must not be called for old stand-ins with ids
    // below `id` anyway: they are destroyed already, because objects are replaced in the order of
    // their ids.
    //
    // Copies the count of undelivered messages once more from the old stand-in of object `id` to
    // the new stand-in, because messages may have come for the old stand-in since NewInstance()
    // copied the count.
    member.successors[id]->undelivered_count = member.objects[id]->undelivered_count;
    // Finishes the restart only when `id` was the last object of the worker.  Objects are replaced
    // in the order of their ids, so the last object has the largest id.
    if (member.successors.rbegin()->first != id) continue;
    uint64_t undelivered = 0;
    for (const auto& [new_id, object] : member.successors) undelivered += object->undelivered_count;
    member.objects = member.successors;
    member.process->Rejoin(member.objects);
    member.lost.clear();
    ++member.restarts_done;
    EnterStage(&member, Stage::kRunning);
    const ProcessSlot::Identity& identity = member.process->connection().identity();
    options_.say(
        fmt::format("process '{}' is back (pid {} on {}); {} messages came meanwhile and "
                    "were not heard",
                    name, identity.pid, identity.host, undelivered - member.undelivered_before));
    if (!object_restart_listener_) continue;
    for (const auto& [new_id, object] : member.objects) object_restart_listener_(object);
  }
}

// Returns whether the worker is being restarted and its restart needs another step.  In stage
// kReplacing no step is needed, because the System completes the replacement.
bool WorkerGroup::IsRestarting(const Member& member) const {
  return member.stage == Stage::kJoining || member.stage == Stage::kLoading ||
         (member.stage == Stage::kCleaningUp && member.is_cleaned_up);
}

// Advances all restarts by one step; returns true while a restart is under way.  Processes join in
// any order, but load and replace their objects in the order of the processes' names, so that every
// run is the same.
bool WorkerGroup::AdvanceRestarts() {
  bool is_first = true;
  for (auto& [name, member] : members_) {
    if (IsRestarting(member)) AdvanceRestart(&member, is_first);
    is_first = is_first && !IsRestarting(member);
  }
  return !is_first;
}

// Waits in lockstep (the master waits for each handler) until all restarts are complete or given
// up.  Sleeps between two steps and does not wait for DDS samples.  Samples of running workers stay
// unread in this loop, so a wait for samples would end at once each time.
void WorkerGroup::WaitForRestarts() {
  while (system_->booted() && !IsEnding() && AdvanceRestarts()) usleep(kRestartPollUs);
  for (const auto& [name, member] : members_) {
    if (member.stage != Stage::kNotRestarted || member.crashed || system_->powered_off()) continue;
    system_->AddFindingAbout(member.objects.begin()->second, Severity::kError,
                             fmt::format("{}; the run stops here", member.lost));
    StopRun({EndKind::kLostProcess, member.lost});
  }
}

}  // namespace openr_host
