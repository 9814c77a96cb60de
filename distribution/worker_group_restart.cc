// How a process that was lost comes back into a run: as a new one, with its objects as at the
// beginning.  One step of it at each look; in lockstep the run waits for all of them, so that it
// takes no virtual time and happens at the same instant in every run.
#include <fmt/format.h>
#include <unistd.h>

#include <stdexcept>

#include "distribution/latency.h"
#include "distribution/worker_group.h"

namespace openr_host {
namespace {

constexpr int64_t kCrashRecordMs = 5'000;   // for a process that crashed to write its record
constexpr int64_t kRetryPauseMs = 1'000;    // after an attempt that failed
constexpr int64_t kReturnNoticeMs = 2'000;  // before people are told
constexpr int kReturnPollUs = 1'000;

}  // namespace

// One that somebody else starts may come at any time, which lockstep cannot have unasked.
bool WorkerGroup::MayRestart(const Member& member) const {
  return member.restarts_left > 0 || (member.is_external && options_.is_free);
}

void WorkerGroup::EnterStage(Member* member, Stage stage) {
  member->stage = stage;
  member->since_ms = Latency::NowMs();
  member->is_reported = false;
}

// Messages of its objects that are on their way are delivered first.
void WorkerGroup::CleanUp(Member* member) {
  member->is_cleaned_up = false;
  member->unheard_before = 0;
  for (const auto& [id, object] : member->objects) member->unheard_before += object->unheard_count;
  EnterStage(member, Stage::kCleaningUp);
  system_->PostTask([this, member] {
    for (const auto& [id, object] : member->objects) system_->EndAllOf(id);
    member->is_cleaned_up = true;
  });
}

// In lockstep a run that is ending takes nobody back: it would have to wait.  `may_load`: it may
// begin with its images, if it is there.
void WorkerGroup::AdvanceRestart(Member* member, bool may_load) {
  RemoteProcess& process = *member->process;
  if (IsEnding() && !options_.is_free && member->stage != Stage::kRunning) return;
  try {
    switch (member->stage) {
      case Stage::kRunning:
      case Stage::kNotRestarted:
        process.slot().RefuseOtherRequests();
        return;
      case Stage::kCleaningUp:
        Restart(member);
        return;
      case Stage::kJoining:
        if (!process.slot().AwaitJoin(0)) break;
        if (may_load) BeginLoading(member);
        return;
      case Stage::kLoading:
        if (process.HasLoaded(member->successors)) ReplaceObjects(member);
        break;
      case Stage::kReplacing:
        return;
    }
    CheckRestart(member);
  } catch (const std::runtime_error& error) {  // lost again, or it cannot be started
    if (!IsInterrupted()) FailAttempt(member, error.what());
  }
}

// Throws ProcessLost when one that is coming back has ended, or has had its time.
void WorkerGroup::CheckRestart(Member* member) {
  if (member->child != nullptr && !member->child->HowItEnded().empty())
    throw ProcessLost(member->child->HowItEnded());
  if (member->stage == Stage::kJoining && member->is_external && options_.is_free) return;
  const int64_t waited_ms = Latency::NowMs() - member->since_ms;
  if (waited_ms > options_.wait_ms)
    throw ProcessLost(fmt::format("process '{}' did not come back within {} s", member->name,
                                  options_.wait_ms / 1000));
  if (member->is_reported || waited_ms < kReturnNoticeMs) return;
  member->is_reported = true;
  options_.say(
      fmt::format("process '{}' has not come back for {} s: not started, stopped, or busy; it has "
                  "{} s (--join-wait)",
                  member->name, kReturnNoticeMs / 1000, options_.wait_ms / 1000));
}

// It did not make it this time.
void WorkerGroup::FailAttempt(Member* member, const std::string& why) {
  options_.say(why);
  member->lost = why;
  member->new_objects.clear();
  member->process->slot().Abandon();
  member->attempt_failed = true;
  EnterStage(member, Stage::kCleaningUp);
}

void WorkerGroup::Restart(Member* member) {
  if (!member->is_cleaned_up || !system_->booted()) return;
  if (member->attempt_failed && Latency::NowMs() - member->since_ms < kRetryPauseMs) return;
  if (member->child != nullptr && member->child->HowItEnded().empty()) {
    if (member->crashed && Latency::NowMs() - member->since_ms < kCrashRecordMs) return;
    member->child.reset();  // cut off, or stopped
  }
  if (!MayRestart(*member)) {
    if (options_.restarts > 0)
      options_.say(fmt::format("process '{}' is not started again: it was {} times", member->name,
                               options_.restarts));
    member->process->slot().Close();
    EnterStage(member, Stage::kNotRestarted);
    return;
  }
  if (member->restarts_left > 0) --member->restarts_left;
  if (!member->is_external) Start(member);
  member->attempt_failed = false;
  EnterStage(member, Stage::kJoining);
}

// As at the beginning of a run, but all at once.
void WorkerGroup::BeginLoading(Member* member) {
  member->robots = member->known = 0;
  member->new_objects.clear();
  member->successors.clear();
  for (const auto& [id, object] : member->objects) {
    member->new_objects.push_back(object->NewInstance());
    member->successors[id] = member->new_objects.back().get();
  }
  Welcome(member);
  WireArena arena;
  member->process->BeginLoad(NextLoadFor(member, &arena));
  EnterStage(member, Stage::kLoading);
}

void WorkerGroup::ReplaceObjects(Member* member) {
  std::vector<std::unique_ptr<Object>> new_objects;
  for (auto& object : member->new_objects) new_objects.push_back(std::move(object));
  member->new_objects.clear();
  EnterStage(member, Stage::kReplacing);
  system_->Return(std::move(new_objects));
}

// Whoever is connected with it elsewhere forgets the old one.  The new one is there when all of its
// process are.
void WorkerGroup::OnReplaced(ObjectId id) {
  for (auto& [name, member] : members_) {
    if (member.objects.contains(id) || !member.is_welcomed || member.process->is_lost()) continue;
    try {
      member.process->Forget(id);
    } catch (const ProcessLost& lost) {
      HandleLoss(member.objects.begin()->second, RemoteObject::Loss::kGone, lost.what());
    }
  }
  for (auto& [name, member] : members_) {
    for (const auto& [other, object] : member.objects) {
      if (other >= id || member.stage != Stage::kReplacing) object->ForgetObserver(id);
    }
    if (member.stage != Stage::kReplacing || !member.successors.contains(id)) continue;
    member.successors[id]->unheard_count = member.objects[id]->unheard_count;
    if (member.successors.rbegin()->first != id) continue;
    uint64_t unheard = 0;
    for (const auto& [new_id, object] : member.successors) unheard += object->unheard_count;
    member.objects = member.successors;
    member.process->Rejoin(member.objects);
    member.lost.clear();
    ++member.returns;
    EnterStage(&member, Stage::kRunning);
    options_.say(
        fmt::format("process '{}' is back (pid {} on {}); {} messages came meanwhile and "
                    "were not heard",
                    name, member.process->identity().pid, member.process->identity().host,
                    unheard - member.unheard_before));
    if (!return_listener_) continue;
    for (const auto& [new_id, object] : member.objects) return_listener_(object);
  }
}

bool WorkerGroup::IsRestarting(const Member& member) const {
  return member.stage == Stage::kJoining || member.stage == Stage::kLoading ||
         (member.stage == Stage::kCleaningUp && member.is_cleaned_up);
}

// One step of each that is under way; true when one is still.  They come in any order, and take
// their places in that of their names, so that every run is the same.
bool WorkerGroup::AdvanceRestarts() {
  bool is_first = true;
  for (auto& [name, member] : members_) {
    if (IsRestarting(member)) AdvanceRestart(&member, is_first);
    is_first = is_first && !IsRestarting(member);
  }
  return !is_first;
}

// In lockstep.  Not for news: those of the others are not read here.
void WorkerGroup::WaitForRestarts() {
  while (system_->booted() && !IsEnding() && AdvanceRestarts()) usleep(kReturnPollUs);
  for (const auto& [name, member] : members_) {
    if (member.stage != Stage::kNotRestarted || member.crashed || system_->powered_off()) continue;
    system_->AddFindingAbout(member.objects.begin()->second, Severity::kError,
                             fmt::format("{}; the run stops here", member.lost));
    StopRun({EndKind::kLostProcess, member.lost});
  }
}

}  // namespace openr_host
