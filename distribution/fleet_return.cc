// How a process that was lost comes back into a run: as a new one, with its objects as at the
// beginning.  One step of it at each look; in lockstep the run waits for all of them, so that it
// takes no virtual time and happens at the same instant in every run.
#include <fmt/format.h>
#include <unistd.h>

#include <stdexcept>

#include "distribution/fleet.h"
#include "distribution/latency.h"

namespace openr_host {
namespace {

constexpr int64_t kCrashRecordMs = 5'000;   // for a process that crashed to write its record
constexpr int64_t kRetryPauseMs = 1'000;    // after an attempt that failed
constexpr int64_t kReturnNoticeMs = 2'000;  // before people are told
constexpr int kReturnPollUs = 1'000;

}  // namespace

// One that somebody else starts may come at any time, which lockstep cannot have unasked.
bool Fleet::MayComeBack(const Member& member) const {
  return member.restarts_left > 0 || (member.is_external && options_.is_free);
}

void Fleet::Enter(Member* member, Stage stage) {
  member->stage = stage;
  member->since_ms = Latency::NowMs();
  member->is_told = false;
}

// Messages of its objects that are on their way are delivered first.
void Fleet::PutAway(Member* member) {
  member->is_put_away = false;
  member->unheard_before = 0;
  for (const auto& [id, object] : member->objects) member->unheard_before += object->unheard_count;
  Enter(member, Stage::kLeaving);
  system_->PostTask([this, member] {
    for (const auto& [id, object] : member->objects) system_->EndAllOf(id);
    member->is_put_away = true;
  });
}

// In lockstep a run that is ending takes nobody back: it would have to wait.  `is_its_turn`: it may
// begin with its images, if it is there.
void Fleet::Tend(Member* member, bool is_its_turn) {
  RemoteProcess& process = *member->process;
  if (IsEnding() && !options_.is_free && member->stage != Stage::kThere) return;
  try {
    switch (member->stage) {
      case Stage::kThere:
      case Stage::kGone:
        process.slot().RefuseOtherRequests();
        return;
      case Stage::kLeaving:
        StartAgain(member);
        return;
      case Stage::kComing:
        if (!process.slot().AwaitJoin(0)) break;
        if (is_its_turn) TakeIn(member);
        return;
      case Stage::kLoading:
        if (process.HasLoaded(member->successors)) Loaded(member);
        break;
      case Stage::kTaking:
        return;
    }
    CheckArrival(member);
  } catch (const std::runtime_error& error) {  // lost again, or it cannot be started
    if (!IsInterrupted()) GiveUp(member, error.what());
  }
}

// Throws ProcessLost when one that is coming back has ended, or has had its time.
void Fleet::CheckArrival(Member* member) {
  if (member->child != nullptr && !member->child->HowItEnded().empty())
    throw ProcessLost(member->child->HowItEnded());
  if (member->stage == Stage::kComing && member->is_external && options_.is_free) return;
  const int64_t waited_ms = Latency::NowMs() - member->since_ms;
  if (waited_ms > options_.wait_ms)
    throw ProcessLost(fmt::format("process '{}' did not come back within {} s", member->name,
                                  options_.wait_ms / 1000));
  if (member->is_told || waited_ms < kReturnNoticeMs) return;
  member->is_told = true;
  options_.say(
      fmt::format("process '{}' has not come back for {} s: not started, stopped, or busy; it has "
                  "{} s (--join-wait)",
                  member->name, kReturnNoticeMs / 1000, options_.wait_ms / 1000));
}

// It did not make it this time.
void Fleet::GiveUp(Member* member, const std::string& why) {
  options_.say(why);
  member->lost = why;
  member->fresh.clear();
  member->process->slot().Abandon();
  member->has_failed = true;
  Enter(member, Stage::kLeaving);
}

void Fleet::StartAgain(Member* member) {
  if (!member->is_put_away || !system_->booted()) return;
  if (member->has_failed && Latency::NowMs() - member->since_ms < kRetryPauseMs) return;
  if (member->child != nullptr && member->child->HowItEnded().empty()) {
    if (member->crashed && Latency::NowMs() - member->since_ms < kCrashRecordMs) return;
    member->child.reset();  // cut off, or stopped
  }
  if (!MayComeBack(*member)) {
    if (options_.restarts > 0)
      options_.say(fmt::format("process '{}' is not started again: it was {} times", member->name,
                               options_.restarts));
    member->process->slot().Close();
    Enter(member, Stage::kGone);
    return;
  }
  if (member->restarts_left > 0) --member->restarts_left;
  if (!member->is_external) Start(member);
  member->has_failed = false;
  Enter(member, Stage::kComing);
}

// As at the beginning of a run, but all at once.
void Fleet::TakeIn(Member* member) {
  member->robots = member->known = 0;
  member->fresh.clear();
  member->successors.clear();
  for (const auto& [id, object] : member->objects) {
    member->fresh.push_back(object->NewOne());
    member->successors[id] = member->fresh.back().get();
  }
  Welcome(member);
  WireArena arena;
  member->process->BeginLoad(NewsFor(member, &arena));
  Enter(member, Stage::kLoading);
}

void Fleet::Loaded(Member* member) {
  std::vector<std::unique_ptr<Object>> fresh;
  for (auto& object : member->fresh) fresh.push_back(std::move(object));
  member->fresh.clear();
  Enter(member, Stage::kTaking);
  system_->Return(std::move(fresh));
}

// Whoever is connected with it elsewhere forgets the old one.  The new one is there when all of its
// process are.
void Fleet::Replaced(ObjectId id) {
  for (auto& [name, member] : members_) {
    if (member.objects.contains(id) || !member.is_welcome || member.process->is_lost()) continue;
    try {
      member.process->Forget(id);
    } catch (const ProcessLost& lost) {
      Lost(member.objects.begin()->second, RemoteObject::Loss::kGone, lost.what());
    }
  }
  for (auto& [name, member] : members_) {
    for (const auto& [other, object] : member.objects) {
      if (other >= id || member.stage != Stage::kTaking) object->ForgetObserver(id);
    }
    if (member.stage != Stage::kTaking || !member.successors.contains(id)) continue;
    member.successors[id]->unheard_count = member.objects[id]->unheard_count;
    if (member.successors.rbegin()->first != id) continue;
    uint64_t unheard = 0;
    for (const auto& [new_id, object] : member.successors) unheard += object->unheard_count;
    member.objects = member.successors;
    member.process->Rejoin(member.objects);
    member.lost.clear();
    ++member.returns;
    Enter(&member, Stage::kThere);
    options_.say(
        fmt::format("process '{}' is back (pid {} on {}); {} messages came meanwhile and "
                    "were not heard",
                    name, member.process->identity().pid, member.process->identity().host,
                    unheard - member.unheard_before));
    if (!return_listener_) continue;
    for (const auto& [new_id, object] : member.objects) return_listener_(object);
  }
}

bool Fleet::IsUnderWay(const Member& member) const {
  return member.stage == Stage::kComing || member.stage == Stage::kLoading ||
         (member.stage == Stage::kLeaving && member.is_put_away);
}

// One step of each that is under way; true when one is still.  They come in any order, and take
// their places in that of their names, so that every run is the same.
bool Fleet::TendAll() {
  bool is_first = true;
  for (auto& [name, member] : members_) {
    if (IsUnderWay(member)) Tend(&member, is_first);
    is_first = is_first && !IsUnderWay(member);
  }
  return !is_first;
}

// In lockstep.  Not for news: those of the others are not read here.
void Fleet::WaitForReturns() {
  while (system_->booted() && !IsEnding() && TendAll()) usleep(kReturnPollUs);
  for (const auto& [name, member] : members_) {
    if (member.stage != Stage::kGone || member.crashed || system_->powered_off()) continue;
    system_->AddFindingAbout(member.objects.begin()->second, Severity::kError,
                             fmt::format("{}; the run stops here", member.lost));
    StopTheRun({EndKind::kLostProcess, member.lost});
  }
}

}  // namespace openr_host
