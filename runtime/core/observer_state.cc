#include "runtime/core/observer_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <utility>

#include "runtime/core/api.h"
#include "runtime/core/region_access.h"
#include "runtime/core/system.h"

namespace openr_host {

void ObserverState::ReportRepeatedReady(const Held& held) {
  const Object* const peer = system->object(ObjectIdOf(held.subject.GetOID()));
  system->AddFindingAbout(
      object, Severity::kWarning,
      fmt::format("{}: asserts ready to {} again and again ({} times) without a notification "
                  "between; ready is a flag, once per notification is enough",
                  service, peer == nullptr ? "an unknown object" : peer->name, held.asserted));
}

ObserverState::Held& ObserverState::AddHeld(const SubjectID& subject) {
  return held.emplace_back(Held{subject, ObjectIdOf(subject.GetOID()), {}});
}

OStatus ObserverState::SendReady(const SubjectID& subject, ObjcommCommand command) {
  Held& entry = HeldOf(subject);
  OwnedMessage message = system->NewMessage(entry.target, subject.GetSelector());
  auto& ready = *new (message->payload) OReadyMessage;
  ready.command = command;
  ready.observerID = id;
  message->size = sizeof ready;
  message->kind = PayloadKind::kReady;
  // The number of regions that this ready gives back.  It gives back the regions that this object
  // no longer uses: those to which the object holds no reference of its own.  A ready can hold
  // MAX_NUM_DATA regions; further regions are given back by the next ready.
  int count = 0;
  for (RCRegion* region : entry.regions) {
    if (region->NumberOfReference() > 1 || count == MAX_NUM_DATA) continue;
    ready.rcRegion[count++] = RegionAccess::SourceOf(region);
  }
  ready.numOfData = count;
  // Posts the ready before this object gives up the regions, because the object keeps them if the
  // ready is refused.
  const sError error = system->PostAtOnce(std::move(message));
  if (error != sSUCCESS) [[unlikely]]
    return ReportRefusedReady(error);
  // Counts the readies to one subject that follow each other without a notification in between;
  // more than kTimesMax become a finding.  On the robot these readies can fail: they wait in the
  // message queue of the subject's object, and the robot refuses the 33rd message in a queue.  The
  // limit of 8 is our choice: no program asserts ready more than 8 times in a row on purpose.
  constexpr int kTimesMax = 8;
  entry.asserted = command == objcommCMD_ASSERT_READY ? entry.asserted + 1 : 0;
  if (entry.asserted == kTimesMax + 1 && !object->is_system()) ReportRepeatedReady(entry);
  // Removes from `entry.regions` (regions received from the subject) the regions that the posted
  // ready gives back: the first `count` regions to which the object holds no reference of its own.
  // The references have not changed since the ready was made, so these are the same regions as in
  // the ready.
  auto kept = entry.regions.begin();
  for (RCRegion* const region : entry.regions) {
    if (region->NumberOfReference() > 1 || count == 0) {
      *kept++ = region;
    } else {
      RegionAccess::GiveBack(system, region);
      --count;
    }
  }
  entry.regions.erase(kept, entry.regions.end());
  return oSUCCESS;
}

OStatus ObserverState::SendReadyToAll(ObjcommCommand command) {
  OStatus status = oSUCCESS;
  // If the ready to one subject fails, goes on with the next subject, so that all other subjects
  // get their ready.  Returns the status of the last failure.
  for (const OSubjectInfo& subject : subjects) {
    const OStatus one = SendReady(subject.GetSubjectID(), command);
    if (one != oSUCCESS) status = one;
  }
  for (Missing& subject : missing) subject.command = command;
  return status;
}

void ObserverState::AddSubject(const SubjectID& subject, const std::string& subject_service) {
  subjects.push_back(OSubjectInfo(subject, objcommVERSION22));
  names.push_back({subject, subject_service});
  const auto found = std::find_if(missing.begin(), missing.end(), [&](const Missing& each) {
    return each.service == subject_service;
  });
  if (found == missing.end()) return;
  const ObjcommCommand command = found->command;
  missing.erase(found);
  if (command != objcommCMD_UNDEF) SendReady(subject, command);
}

void ObserverState::RemoveSubjects(const std::function<bool(const SubjectID&)>& ends) {
  subjects.remove_if([&](const OSubjectInfo& info) { return ends(info.GetSubjectID()); });
  std::erase_if(names, [&](const Name& name) { return ends(name.subject); });
}

void ObserverState::MissSubject(const std::string& subject_service) {
  for (const Missing& each : missing) {
    // Keeps the record of this subject if there is one already, because it may have a command that
    // must still be sent to the subject.
    if (each.service == subject_service) return;
  }
  missing.push_back({subject_service});
}

OStatus ObserverState::ReportRefusedReady(sError error) {
  system->Print(fmt::format("OObserver({})::SendReady() Sending Ready failed. sError = {}\n",
                            service, error));
  return oSEND_FAIL;
}

}  // namespace openr_host
