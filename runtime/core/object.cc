#include "runtime/core/object.h"

#include <OPENR/ObjcommMessages.h>
#include <OPENR/RCRegion.h>
#include <Types.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

#include "runtime/base/assert.h"
#include "runtime/core/api.h"
#include "runtime/core/connection_messages.h"
#include "runtime/core/observer_state.h"
#include "runtime/core/subject_state.h"
#include "runtime/core/system.h"

namespace openr_host {

Object::Object(System* the_system, ObjectId the_id, int the_robot, bool the_is_image)
    : system(the_system),
      id(the_id),
      robot(the_robot),
      delivery_(&is_plain_, the_is_image),
      is_image_(the_is_image) {}

Object::~Object() {
  files_.CloseAll();
  memory_.DeletePrivateRegions();
}

void OpenFiles::CloseAll() {
  for (const auto& [file, what] : streams) std::fclose(file);
  for (const auto& [descriptor, what] : descriptors) close(descriptor);
  if (terminal != nullptr) std::fclose(terminal);
  streams.clear();
  descriptors.clear();
  terminal = nullptr;
}

std::string Object::NameService(uint32_t selector, const char* kind) {
  // Finds the service by `entry`, the selector of its Control or Connect entry.  This entry is
  // running now: the object has called it itself (self_reply_), or it handles a message (running_).
  const uint32_t entry = self_reply_ != nullptr ? self_reply_->selector
                         : running_ != nullptr  ? running_->selector
                                                : UNDEF;
  const std::string* const found = entry_names_.FindService(entry);
  const std::string service = found == nullptr ? name : *found;
  system->calls().NameEntry(selector, fmt::format("{} ({})", service, kind));
  return service;
}

std::vector<StandingReady> Object::StandingReadies() const {
  std::vector<StandingReady> readies;
  for (const auto& subject : subjects_) {
    for (const ObserverLink& link : subject->links) {
      if (link.ready > 0)
        readies.push_back({subject->id.GetSelector(), link.target, link.observer.GetSelector()});
    }
  }
  return readies;
}

uint64_t Object::CountPending() const {
  uint64_t count = 0;
  for (const auto& subject : subjects_) {
    for (const ObserverLink& link : subject->links) count += link.units.size();
  }
  return count;
}

SubjectState* Object::AddSubject(std::unique_ptr<SubjectState> subject) {
  return subjects_.emplace_back(std::move(subject)).get();
}

ObserverState* Object::AddObserver(std::unique_ptr<ObserverState> observer) {
  return observers_.emplace_back(std::move(observer)).get();
}

void Object::HandleUndelivered(const Message& message) {
  if (message.kind != PayloadKind::kReady) statistics_.NoteDropped();
  if (message.kind == PayloadKind::kNotify) RefuseNotification(this, message);
}

void Object::ReturnRegion(RCRegion* region) {
  if (!is_leaving_ && !subjects_.empty()) region->RemoveReference();
}

TakenBack Object::TakeBack(const Message& message) {
  const auto& notify = *reinterpret_cast<const ONotifyMessage*>(message.payload);
  const ObserverID observer = OServiceEntry(OidOf(message.target), message.selector);
  TakenBack result = TakenBack::kNoSubject;
  for (const auto& subject : subjects_) {
    if (subject->id != notify.subjectID) continue;
    result = TakenBack::kNoObserver;
    ObserverLink* const link = subject->Find(observer);
    if (link == nullptr) continue;
    const CurrentScope scope(system, this);
    subject->TakeBack(link, notify);
    return TakenBack::kPending;
  }
  return result;
}

int Object::NextRandom() {
  random_state_ = random_state_ * 1103515245u + 12345u;
  return static_cast<int>((random_state_ >> 1) & 0x7fffffff);
}

void Object::BeginReplacement() {
  ASSERT(!is_leaving_, "{} is replaced already", name);
  is_leaving_ = true;
}

void Object::Succeed(const Object& old) {
  ASSERT(old.id == id && predecessors_ == 0, "object {} cannot replace object {}", id, old.id);
  predecessors_ = old.predecessors_ + 1;
  message_count_ = old.message_count_;
  statistics_.Succeed(old.statistics_);
  waiting_max_ = old.waiting_max_;
  // Copies the number of messages that wait for the old object, because the new object may receive
  // some of them: a gate (schedule.h) may keep messages.
  waiting_ = old.waiting_;
  // A reply to a request of the old object may still come.  It names only the object's id and a
  // reply box.  So no box of the new object gets the number of a box of the old object.
  boxes_.set_last(std::max(boxes_.last(), old.boxes_.last()));
}

void Object::KeepEarlyWork(EarlyWork work) {
  ASSERT(!has_early_work_, "{} keeps early work", name);
  has_early_work_ = true;
  early_work_ = std::move(work);
}

EarlyWork Object::TakeEarlyWork() {
  has_early_work_ = false;
  return std::exchange(early_work_, {});
}

bool Object::KeepEarlyService(const std::string& service, uint32_t selector) {
  ASSERT(has_early_work_, "{} keeps no early work", name);
  auto& services = early_work_.services;
  const bool is_known =
      std::any_of(services.begin(), services.end(),
                  [&service](const auto& entry) { return entry.first == service; });
  if (!is_known) services.emplace_back(service, selector);
  return !is_known;
}

void Object::ReturnHeld() {
  // Puts the held messages back, the newest first.  Readmit() puts each message at the front of the
  // queue, so at the end the oldest message is at the front.
  while (!delivery_.held().empty()) system->Readmit(delivery_.TakeNewestHeld());
}

}  // namespace openr_host
