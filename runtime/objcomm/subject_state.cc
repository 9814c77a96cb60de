// Ready, notify, pending and the order in which references go: measured.md, section 1.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "runtime/core/api.h"
#include "runtime/core/hasher.h"
#include "runtime/core/system.h"
#include "runtime/objcomm/state.h"

namespace openr_host {

ObserverLink* SubjectState::Find(const ObserverID& observer) {
  for (const auto& link : links) {
    if (link->observer == observer) return link.get();
  }
  return nullptr;
}

OStatus SubjectState::SetData(ObserverLink* link, RCRegion* region) {
  region->AddReference();
  link->fresh.push_back(region);
  if (link->fresh.size() <= MAX_NUM_DATA) return oSUCCESS;
  link->fresh.front()->RemoveReference();
  link->fresh.erase(link->fresh.begin());
  ++object->dropped_count;
  system->AddFinding(Severity::kWarning,
                     fmt::format("{}: more than {} data set before a notify; the oldest is dropped",
                                 service, MAX_NUM_DATA));
  return oFATAL;
}

void SubjectState::DropOldestUnit(ObserverLink* link) {
  const int count = link->units.front().data;
  for (int i = 0; i < count; ++i) link->pending[static_cast<size_t>(i)]->RemoveReference();
  link->pending.erase(link->pending.begin(), link->pending.begin() + count);
  link->units.erase(link->units.begin());
}

OStatus SubjectState::Notify(ObserverLink* link) {
  if (link->fresh.empty()) return oSUCCESS;
  if (link->skipped < link->skip) {
    ++link->skipped;
    for (RCRegion* region : link->fresh) region->RemoveReference();
    link->fresh.clear();
    return oSUCCESS;
  }
  link->skipped = 0;
  link->units.push_back({static_cast<int>(link->fresh.size())});
  link->pending.insert(link->pending.end(), link->fresh.begin(), link->fresh.end());
  link->fresh.clear();
  Flush(link);
  while (link->units.size() > link->max) {
    DropOldestUnit(link);
    ++link->replaced;
    ++object->dropped_count;
  }
  if (!link->units.empty() && link->waiting_since_us < 0) link->waiting_since_us = system->now_us();
  return oSUCCESS;
}

void SubjectState::Flush(ObserverLink* link) {
  if (link->ready <= 0 || link->units.empty() || link->units.size() < link->min) return;
  // Whole units, oldest first, as many as one message holds.
  size_t unit_count = 0;
  int data_count = 0;
  while (unit_count < link->units.size() &&
         data_count + link->units[unit_count].data <= MAX_NUM_DATA) {
    data_count += link->units[unit_count++].data;
  }
  Message* const message =
      system->NewMessage(ObjectIdOf(link->observer.GetOID()), link->observer.GetSelector());
  auto& notify = *new (message->payload) ONotifyMessage;
  notify.msgType = omsgNOTIFY_V22;
  notify.subjectID = id;
  notify.numOfData = static_cast<short>(data_count);
  notify.numOfNotify = static_cast<short>(unit_count);
  for (int i = 0; i < data_count; ++i) {
    RCRegion* const region = link->pending[static_cast<size_t>(i)];
    notify.data[i].srcRCR = region;
    notify.data[i].memID = region->MemID();
    notify.data[i].offset = region->Offset();
    notify.data[i].size = region->Size();
  }
  message->size = sizeof notify;
  message->kind = PayloadKind::kNotify;
  if (system->Post(message) != sSUCCESS) return;  // stays pending; the next notify or ready retries
  link->pending.erase(link->pending.begin(), link->pending.begin() + data_count);
  link->units.erase(link->units.begin(), link->units.begin() + static_cast<long>(unit_count));
  link->waiting_since_us = link->units.empty() ? -1 : system->now_us();
  link->ready = 0;
  ++link->sent;
}

void SubjectState::Clear(ObserverLink* link) {
  for (RCRegion* region : link->fresh) region->RemoveReference();
  for (RCRegion* region : link->pending) region->RemoveReference();
  link->fresh.clear();
  link->pending.clear();
  link->units.clear();
  link->waiting_since_us = -1;
}

void SubjectState::DescribeWaiting(const Object& owner, std::vector<std::string>* lines) const {
  for (const auto& link : links) {
    if (link->waiting_since_us < 0) continue;
    lines->push_back(fmt::format("{} waits for ready of {} on {} since t={:.3f} s", owner.name,
                                 link->name, service,
                                 static_cast<double>(link->waiting_since_us) * 1e-6));
  }
}

void SubjectState::HashState(Hasher* hasher) const {
  hasher->AddText(service);
  for (const auto& link : links) {
    hasher->Add(link->ready);
    hasher->Add(static_cast<uint64_t>(link->skipped));
    hasher->Add(static_cast<uint64_t>(link->fresh.size()));
    hasher->Add(static_cast<uint64_t>(link->pending.size()));
    hasher->Add(static_cast<uint64_t>(link->units.size()));
  }
}

}  // namespace openr_host
