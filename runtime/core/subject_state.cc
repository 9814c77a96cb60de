// Sends the data of a subject to its observers.  Data stay pending until an observer is ready.
// References to regions are released at the moments that were measured with Sony's library
// (measured.md, section 1).
#include "runtime/core/subject_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "runtime/base/assert.h"
#include "runtime/base/hasher.h"
#include "runtime/core/api.h"
#include "runtime/core/system.h"

namespace openr_host {

RCRegion* RegionList::TakeFirst() {
  ASSERT(size_ > 0);
  RCRegion* const first = regions_[0];
  std::copy(regions_ + 1, regions_ + size_, regions_);
  --size_;
  return first;
}

void SubjectState::DropOldestData(ObserverLink* link) {
  link->fresh.TakeFirst()->RemoveReference();
  object->statistics().NoteDropped();
  system->AddFinding(Severity::kWarning,
                     fmt::format("{}: more than {} data set before a notify; the oldest is dropped",
                                 service, MAX_NUM_DATA));
}

void SubjectState::DropOldestUnit(ObserverLink* link) {
  ASSERT(!link->units.empty(), "{}: there is no unit to drop", service);
  const int count = link->units.front().data;
  for (int i = 0; i < count; ++i) link->pending[static_cast<size_t>(i)]->RemoveReference();
  link->pending.erase(link->pending.begin(), link->pending.begin() + count);
  link->units.erase(link->units.begin());
}

namespace {

// Reports data that newer data replaced before the observer was ready.  The robot prints nothing
// about such a loss, so a user would not notice it.  Reports nothing if the subject belongs to a
// system object, because replacing is intended there: a slow program sees the newest sensor values.
// Reports nothing if the observer belongs to a system object, because programs that work often send
// command vectors and sounds without asking whether the robot is ready (docs/body.md).
// Object::dropped_count counts every loss, also a loss that is not reported.
void ReportReplaced(const SubjectState& subject, const ObserverLink& link) {
  if (subject.object->is_system()) return;
  const Object* const observer = subject.system->object(ObjectIdOf(link.observer.GetOID()));
  if (observer != nullptr && observer->is_system()) return;
  subject.system->AddFindingAbout(
      subject.object, Severity::kWarning,
      fmt::format("{}: data {} was not ready for were replaced by newer ones and are lost; notify "
                  "when IsReady(), put all data into one notification, or let the observer call "
                  "SetBufCtrlParam()",
                  subject.service, link.name));
}

}  // namespace

namespace {

// Adds a finding when a subject notifies an observer that has deasserted ready, because this
// observer gets no data.  Adds no finding if the process of the observer has ended, because another
// finding reports this end.
void ReportDeasserted(const SubjectState& subject, ObserverLink* link) {
  if (link->told_deasserted || link->is_lost || subject.object->is_system()) return;
  link->told_deasserted = true;
  subject.system->AddFindingAbout(
      subject.object, Severity::kWarning,
      fmt::format("{}: notifies {}, which has deasserted ready: the data wait, and newer ones "
                  "replace them, until it asserts again",
                  subject.service, link->name));
}

}  // namespace

// This function is inline, because it runs for every notification.
[[gnu::always_inline]] inline bool SubjectState::Send(ObserverLink* link, RCRegion* const* data,
                                                      size_t data_count, size_t unit_count) {
  OwnedMessage message = system->NewMessage(link->target, link->observer.GetSelector());
  auto& notify = *new (message->payload) ONotifyMessage;
  notify.subjectID = id;
  notify.numOfData = static_cast<short>(data_count);
  notify.numOfNotify = static_cast<short>(unit_count);
  for (size_t i = 0; i < data_count; ++i) notify.data[i] = RegionAccess::Describe(data[i]);
  message->size = sizeof notify;
  message->kind = PayloadKind::kNotify;
  // Stores the hash of the data in the notification.  When the observer receives the data,
  // OObserver::NotifyHandler() computes the hash again, and so finds a subject that has changed
  // data after sending them.
  if (system->options().guard_regions) {
    uint32_t bytes = 0;
    message->payload_hash = PayloadHash(*message, &bytes);
  }
  system->host_addresses().Check(*message);
  if (system->PostAtOnce(std::move(message)) != sSUCCESS) [[unlikely]]
    return false;
  link->waiting_since_us = -1;
  // Clears the ready flag, because each ready is valid for one notification only (measured.md 1.7).
  link->ready = 0;
  link->sent_us = system->now_us();
  ++link->sent;
  return true;
}

OStatus SubjectState::Notify(ObserverLink* link) {
  // Sends nothing if the program has set no data for this observer.  The observer then stays ready,
  // as it does with Sony's library (measured.md 1.12).
  if (link->fresh.empty()) return oSUCCESS;
  // Drops `skip` notifications before each notification that is kept, because the observer has
  // ordered this with SetSkip().
  if (link->skipped < link->skip) {
    ++link->skipped;
    for (RCRegion* region : link->fresh) region->RemoveReference();
    link->fresh.Clear();
    return oSUCCESS;
  }
  link->skipped = 0;
  if (link->ready < 0) ReportDeasserted(*this, link);
  // True if these data can be sent at once: the observer is ready, no older notification is
  // pending, and the observer does not wait for several notifications in one message (`min` is at
  // most 1).  Otherwise the data become pending.
  const bool is_awaited = link->ready > 0 && link->units.empty() && link->min <= 1;
  if (is_awaited && Send(link, link->fresh.begin(), link->fresh.size(), 1)) [[likely]] {
    link->fresh.Clear();
    return oSUCCESS;
  }
  link->units.push_back({static_cast<int>(link->fresh.size())});
  link->pending.insert(link->pending.end(), link->fresh.begin(), link->fresh.end());
  link->fresh.Clear();
  if (!is_awaited) Flush(link);
  // Drops old notifications only after Flush(), which sends pending notifications if the observer
  // is ready.  So data that the observer can take now are sent and not lost.
  while (link->units.size() > link->max) {
    DropOldestUnit(link);
    object->statistics().NoteDropped();
    if (++link->replaced == 1) ReportReplaced(*this, *link);
  }
  if (!link->units.empty() && link->waiting_since_us < 0) link->waiting_since_us = system->now_us();
  return oSUCCESS;
}

void SubjectState::SendPending(ObserverLink* link) {
  // Counts the notifications (units) that go into this message, from the oldest on.  All regions of
  // a notification must stay together.  So the first notification that does not fit completely, and
  // all later notifications, wait for the next message.
  size_t unit_count = 0;
  int data_count = 0;
  while (unit_count < link->units.size() &&
         data_count + link->units[unit_count].data <= MAX_NUM_DATA) {
    data_count += link->units[unit_count++].data;
  }
  // Keeps the data pending if Send() fails.  The next notification or ready then tries to send them
  // again.
  const auto sent_count = static_cast<size_t>(data_count);
  if (!Send(link, link->pending.data(), sent_count, unit_count)) return;
  link->pending.erase(link->pending.begin(), link->pending.begin() + data_count);
  link->units.erase(link->units.begin(), link->units.begin() + static_cast<long>(unit_count));
  // If some notifications are still pending after this call of Send(), their wait for the
  // observer's next ready begins now.
  if (!link->units.empty()) link->waiting_since_us = system->now_us();
}

void SubjectState::TakeBack(ObserverLink* link, const ONotifyMessage& notify) {
  for (int i = 0; i < notify.numOfData; ++i)
    link->pending.insert(link->pending.begin() + i, notify.data[i].srcRCR);
  // The refused message does not say how many regions belong to each of its notifications.  So
  // gives each notification the same number of regions, and the first notification also the
  // remainder.
  const int count = notify.numOfNotify;
  link->units.insert(link->units.begin(), static_cast<size_t>(count),
                     ObserverLink::Unit{notify.numOfData / count});
  link->units.front().data += notify.numOfData % count;
  --link->sent;
  if (link->waiting_since_us < 0) link->waiting_since_us = system->now_us();
  // Send() has cleared the ready flag for a message that was refused later.  So makes the observer
  // ready again, unless it has asserted or deasserted ready since then (`ready` is not 0).
  if (link->ready == 0) link->ready = 1;
  // Drops the oldest notifications if more than `max` are pending.  The handler of the subject may
  // have sent more notifications after the message that was refused.
  while (link->units.size() > link->max) {
    DropOldestUnit(link);
    object->statistics().NoteDropped();
    if (++link->replaced == 1) ReportReplaced(*this, *link);
  }
}

void SubjectState::Clear(ObserverLink* link) {
  for (RCRegion* region : link->fresh) region->RemoveReference();
  for (RCRegion* region : link->pending) region->RemoveReference();
  link->fresh.Clear();
  link->pending.clear();
  link->units.clear();
  link->waiting_since_us = -1;
}

void SubjectState::HashState(Hasher* hasher) const {
  hasher->AddText(service);
  for (const ObserverLink& link : links) {
    hasher->Add(link.ready);
    hasher->Add(static_cast<uint64_t>(link.skipped));
    hasher->Add(static_cast<uint64_t>(link.fresh.size()));
    hasher->Add(static_cast<uint64_t>(link.pending.size()));
    hasher->Add(static_cast<uint64_t>(link.units.size()));
  }
}

}  // namespace openr_host
